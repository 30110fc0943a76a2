using System;
using System.Linq;
using Alate.Cli;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Cli;

/// <summary>Distances between two flights of one wing, of wings that are moved by hand: per cent of the wing's length.</summary>
public sealed class SurfaceDistanceTests
{
    [Test]
    public void AWingThatIsMovedByAHundredth_IsOnePerCentAway_WhateverItsLength([Values(0.05f, 2f)] float length)
    {
        RecordedWing wing = Wing(length, (_, _) => 0f), moved = Wing(length, (_, _) => new float3(0.006f, 0f, 0.008f));
        var distance = SurfaceDistance.Between(wing, moved);

        Assert.That((distance.MeanPct, distance.MaxPct),
            Is.EqualTo((1.0, 1.0)).Using<(double, double)>((a, b) => Math.Abs(a.Item1 - b.Item1) + Math.Abs(a.Item2 - b.Item2) < 1e-4));
        Assert.That(JointError.Percent(wing, moved), Is.EqualTo(1.0).Within(1e-4));
        Assert.That(JointError.Percent(wing, wing), Is.EqualTo(0.0).Within(1e-6));
    }

    [Test]
    public void TheMean_IsOverVerticesAndPhases_TheErrorOfJointsTheRootOfTheirMeanSquare()
    {
        // One of four vertices and joints is away by four hundredths, the whole beat long.
        RecordedWing wing = Wing(1f, (_, _) => 0f), moved = Wing(1f, (_, vertex) => vertex == 2 ? new float3(0f, 0.04f, 0f) : 0f);
        var distance = SurfaceDistance.Between(wing, moved);

        Assert.That(distance.MeanPct, Is.EqualTo(1.0).Within(1e-4));
        Assert.That(distance.MaxPct, Is.EqualTo(4.0).Within(1e-4));
        Assert.That(JointError.Percent(wing, moved), Is.EqualTo(2.0).Within(1e-4), "√(4² / 4)");
    }

    [Test]
    public void Flights_AreComparedAtEqualPhase_NotFrameByFrame()
    {
        float3 Beat(double phase, int vertex) => new float3(0f, 0.1f * (float)Math.Sin(phase), 0f);
        RecordedWing sixteen = Wing(1f, Beat), shifted = Wing(1f, Beat, 48, 0.03);

        Assert.That(
            SurfaceDistance.Between(sixteen, shifted).MaxPct, Is.LessThan(0.25), "but for what straight lines between frames cut off");
        Assert.That(JointError.Percent(sixteen, shifted), Is.LessThan(0.1));
    }

    // Two wings, of which the second is farther off at another phase, but by less.
    [Test]
    public void TheFarthestPhase_IsThatOfAllWings_InTheMean()
    {
        Func<double, int, float3> Off(double phase, float most) =>
            (at, _) => new float3(0f, most * (float)(1.0 + Math.Cos(at - 2.0 * Math.PI * phase)), 0f);
        RecordedWing rest = Wing(1f, (_, _) => 0f, 24);
        RecordedWing[] moved = [Wing(1f, Off(7.0 / 24.0, 0.04f), 24), Wing(1f, Off(19.0 / 24.0, 0.01f), 24)];

        Assert.That(SurfaceDistance.FarthestPhase([rest, rest], moved), Is.EqualTo(7.0 / 24.0).Within(1e-9));
        Assert.That(SurfaceDistance.FarthestPhase(moved[1..], [rest]), Is.EqualTo(19.0 / 24.0).Within(1e-9));
    }

    // Four frames, whose heights are straight between and whose joints are the vertices; the last is followed by the first.
    [TestCase(0.0, 0.0)]
    [TestCase(0.1, 0.4)]
    [TestCase(0.3, 1.2)]
    [TestCase(0.75, 3.0)]
    [TestCase(0.8, 2.4)]
    [TestCase(1.0, 0.0)]
    public void BetweenTwoFrames_AWingLiesByTheShareOfItsPhase(double turns, double height)
    {
        RecordedWing wing = Wing(2f, (phase, _) => new float3(0f, (float)(2.0 * phase / Math.PI), 0f), 4);
        var joints = new float3[4];
        wing.JointsAt(turns, joints);
        (float3[] positions, float3[] normals) = wing.At(turns);
        for (int k = 0; k < 4; k++)
        {
            float3 place = wing.Rest[k] + new float3(0f, (float)height, 0f);
            Assert.That(math.distance(joints[k], place), Is.LessThan(1e-5f));
            Assert.That(math.distance(positions[k], wing.Placement.ToBody(place)), Is.LessThan(1e-5f));
            Assert.That(math.length(normals[k]), Is.EqualTo(1f).Within(1e-6f));
        }
    }

    private static RecordedWing Wing(float length, Func<double, int, float3> moved, int frames = 16, double first = 0.0)
    {
        float3[] rest = [new float3(0f, 0f, 0f), new float3(1f, 0f, 0f), new float3(0.5f, 0f, -0.4f), new float3(0.2f, 0f, -0.2f)];
        var wing = new RecordedWing
        {
            Rest = rest,
            Placement = new WingMount(
            new float3(0.1f, 0f, 0f), length, WingSide.Left),
            ChainCount = 2,
            JointsPerChain = 2
        };
        for (int k = 0; k < frames; k++)
        {
            double phase = first + 2.0 * Math.PI * k / frames;
            float3[] places = rest.Select((place, vertex) => place + moved(phase, vertex)).ToArray();
            wing.Frames.Add(new RecordedFrame
            {
                Phase = (float)phase,
                Positions = places,
                Normals = rest.Select(_ => new float3(0f, 1f, 0f))
                .ToArray(),
                Joints = places
            });
        }

        return wing;
    }
}
