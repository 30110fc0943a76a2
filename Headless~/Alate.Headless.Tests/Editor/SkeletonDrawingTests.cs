using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Editor;
using Alate.Editor.Tests;
using NUnit.Framework;
using StandIns;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests.Editor;

/// <summary>Lines and dots of a skeleton under edit: where, how large, in which colour. Handles are one unit large here.</summary>
public sealed class SkeletonDrawingTests : EditingFixture
{
    private readonly Matrix4x4 m_Place = Matrix4x4.TRS(new Vector3(3f, -1f, 2f), Quaternion.Euler(20f, 50f, -30f), new Vector3(2f, 2f, 2f));

    [SetUp]
    public void Put() => Editing.LocalToWorld = m_Place;

    [Test]
    public void Chains_AreLinesThroughTheirJoints_TheFirstInItsOwnColour_AndRowsJoinThem([Values] bool isActive)
    {
        List<(Color Colour, Vector3[] Points)> drawn = Drawn(isActive, false);
        float strength = isActive ? 1f : 0.5f;

        for (int i = 0; i < 5; i++)
        {
            Vector3[] joints = [.. Enumerable.Range(0, 5).Select(j => World(i, j))];
            Color colour = (i == 0 ? SkeletonColours.principalChain : SkeletonColours.chain) * strength;
            Assert.That(drawn.Count(line => line.Colour == colour && Same(line.Points, joints)), Is.EqualTo(1), $"chain {i}");
            for (int j = 0; i > 0 && j < 5; j++)
            {
                Assert.That(drawn.Count(line => line.Colour == SkeletonColours.row * strength
                    && Same(line.Points, [World(i - 1, j), World(i, j)])), Is.EqualTo(1), $"row {j} to chain {i}");
            }
        }

        Assert.That(drawn.Count(line => line.Colour == SkeletonColours.row * strength), Is.EqualTo(20));
    }

    [Test]
    public void Joints_AreDots_LargerUnderThePointer_AndSelectedOnesInTheirColour([Values] bool isActive)
    {
        Select((1, 2), (3, 4));
        var hovered = new JointIndex(2, 2);
        List<(Color Colour, Vector3[] Points)> drawn = Drawn(isActive, false, hovered);
        float strength = isActive ? 1f : 0.5f;

        foreach (JointIndex joint in JointPicking.All(Skeleton))
        {
            (Color colour, Vector3[] points) = drawn.Single(
                line => IsDot(line.Points) && Near(line.Points[0], World(joint.chain, joint.joint)));
            bool isSelected = joint == new JointIndex(1, 2) || joint == new JointIndex(3, 4);
            Assert.That(colour, Is.EqualTo((isSelected ? SkeletonColours.selected : joint == hovered ? SkeletonColours.hovered
                : SkeletonColours.joint) * strength), joint.ToString());
            Assert.That(points[1].x, Is.EqualTo(joint == hovered ? 1.5f * 0.045f : 0.045f).Within(1e-6f), joint.ToString());
        }
    }

    [Test]
    public void TheHinge_HasARing_AndAnArrowAlongEachOfItsAxes()
    {
        Skeleton.Hinge = new Vector3(0.1f, 0.2f, -0.05f);
        Skeleton.SpanAxis = new Vector3(3f, 0f, 1f);
        Vector3 hinge = m_Place.MultiplyPoint3x4(Skeleton.Hinge);
        List<(Color Colour, Vector3[] Points)> at = [.. Drawn(true, false).Where(line => Near(line.Points[0], hinge))];

        Assert.That(at, Has.Count.EqualTo(3));
        Assert.That(at[0].Colour, Is.EqualTo(SkeletonColours.hinge));
        Assert.That(at[0].Points[1].magnitude, Is.EqualTo(0.1f).Within(1e-5f));
        Assert.That(WingAxes.TryMake(Skeleton.SpanAxis, Skeleton.UpAxis, out float3x3 axes), Is.True);
        foreach ((int k, float3 axis) in new[] { (1, axes.c0), (2, axes.c1) })
        {
            var turn = Quaternion.LookRotation(m_Place.MultiplyVector(axis));
            Assert.That((at[k].Points[1] - new Vector3(0.8f, turn.x, turn.w)).magnitude, Is.LessThan(1e-5f));
        }
    }

    [Test]
    public void ProblemsAndLabels_AreShownOfTheActiveSkeletonAlone()
    {
        Skeleton.Chains[2].joints[3] = Skeleton.GetJoint(2, 2);
        (Color Colour, Vector3[] Points) ring = Drawn(true, false).Single(line => line.Colour == SkeletonColours.problem);
        Assert.That(Near(ring.Points[0], World(2, 3)));
        Assert.That(Drawn(false, true).Any(line => line.Colour == SkeletonColours.problem), Is.False);

        // Five chains by their tips, four joints of the first, and the hinge.
        Vector3[] labels = [.. Drawn(true, true).Where(line => line.Points.Length == 1).Select(line => line.Points[0])];
        Vector3[] wanted = [.. Enumerable.Range(0, 5).Select(i => World(i, 4)), .. Enumerable.Range(0, 4).Select(j => World(0, j)),
            m_Place.MultiplyPoint3x4(Skeleton.Hinge)];
        Assert.That(Same(labels, wanted));
        Assert.That(Drawn(false, true).Any(line => line.Points.Length == 1), Is.False);
        Assert.That(Drawn(true, false).Any(line => line.Points.Length == 1), Is.False);
    }

    private static bool IsDot(Vector3[] points) => points.Length == 2 && points[1].y == 0f && points[1].z == 1f;

    private static bool Near(Vector3 a, Vector3 b) => (a - b).magnitude < 1e-5f;

    private static bool Same(Vector3[] a, Vector3[] b) => a.Length == b.Length && a.Zip(b, Near).All(near => near);

    private Vector3 World(int chain, int joint) => m_Place.MultiplyPoint3x4(Skeleton.GetJoint(chain, joint));

    private List<(Color Colour, Vector3[] Points)> Drawn(bool isActive, bool labels, JointIndex? hovered = null)
    {
        DrawnLines.Calls = [];
        try
        {
            SkeletonDrawing.Draw(Editing, isActive, labels, hovered);
            return DrawnLines.Calls;
        }
        finally
        {
            DrawnLines.Calls = null;
        }
    }
}
