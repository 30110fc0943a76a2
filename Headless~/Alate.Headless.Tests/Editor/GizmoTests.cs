using System.Collections.Generic;
using System.Linq;
using Alate.Crowds;
using Alate.Editor;
using Alate.Flight;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests.Editor;

/// <summary>Gizmos of crowds and pilots: what is drawn where, in the world.</summary>
public sealed class GizmoTests
{
    private GameObject m_Object;

    [SetUp]
    public void Make()
    {
        m_Object = new GameObject("marked");
        m_Object.transform.SetPositionAndRotation(new Vector3(3f, 2f, 1f), Quaternion.Euler(0f, 90f, 0f));
    }

    [TearDown]
    public void Clear() => Object.DestroyImmediate(m_Object);

    // By their luminance, which who cannot tell red from green sees too.
    [Test]
    public void AxesOfAHinge_AreToldApartByTheirLightness_AndDelaysGrowDarker()
    {
        float[] axes = [.. new[] { GizmoColours.Hinge, GizmoColours.Up, GizmoColours.Span }.Select(Luminance)];
        Assert.That(axes[0] - axes[1], Is.GreaterThan(0.15f));
        Assert.That(axes[1] - axes[2], Is.GreaterThan(0.15f));
        for (int k = 0; k < 20; k++)
        {
            float step = Luminance(GizmoColours.Delay(k / 20f)) - Luminance(GizmoColours.Delay((k + 1) / 20f));
            Assert.That(step, Is.InRange(0.005f, 0.04f), $"from {k / 20f}");
        }

        static float Luminance(Color colour) => 0.2126f * colour.r + 0.7152f * colour.g + 0.0722f * colour.b;
    }

    [Test]
    public void ASpawner_ShowsItsBox_TurnedAsItIs()
    {
        CrowdSpawner spawner = m_Object.AddComponent<CrowdSpawner>();
        spawner.Area = new Vector3(4f, 6f, 8f);
        (string shape, Color colour, Vector3[] places) = ShownGizmos.Of(spawner).Single();

        Assert.That((shape, colour), Is.EqualTo(("wire box", GizmoColours.Bounds)));
        Near(places, new Vector3(3f, 2f, 1f), new Vector3(3f, 2f, -1f), new Vector3(3f, 5f, 1f), new Vector3(7f, 2f, 1f));
    }

    [TestCase(VolumeShape.Box, "wire box")]
    [TestCase(VolumeShape.Ellipsoid, "wire ball")]
    public void AWanderer_ShowsItsVolume_AboutWhatItFliesAround(VolumeShape kind, string shape)
    {
        WanderPilot pilot = m_Object.AddComponent<WanderPilot>();
        FlightVolume volume = default;
        volume.centre = new Vector3(1f, 0f, 0f);
        volume.size = new Vector3(2f, 4f, 6f);
        volume.shape = kind;
        pilot.FromStart = false;
        pilot.Volume = volume;
        pilot.Around = m_Object.transform;
        (string drawn, Color colour, Vector3[] places) = ShownGizmos.Of(pilot).Single();

        Assert.That((drawn, colour), Is.EqualTo((shape, GizmoColours.Bounds)));
        Near(places, new Vector3(4f, 2f, 1f), new Vector3(5f, 2f, 1f), new Vector3(4f, 4f, 1f), new Vector3(4f, 2f, 4f));
        pilot.Around = null;
        Near(ShownGizmos.Of(pilot).Single().Places.Take(1).ToArray(), new Vector3(1f, 0f, 0f));
    }

    [Test]
    public void AFollower_ShowsItsPath_ClosedWhereItLoops_FromItsOrigin()
    {
        FollowPilot pilot = m_Object.AddComponent<FollowPilot>();
        Vector3[] points = [new(0f, 0f, 0f), new(1f, 0f, 0f), new(1f, 0f, 2f)];
        pilot.Points.Clear();
        pilot.Points.AddRange(points);
        pilot.Loop = false;
        pilot.Origin = null;
        List<(string Shape, Color Colour, Vector3[] Places)> open = ShownGizmos.Of(pilot);
        Assert.That(open.Select(line => (line.Shape, line.Colour)), Is.All.EqualTo(("line", GizmoColours.Span)));
        Assert.That(open, Has.Count.EqualTo(2));
        Near(open[0].Places, points[0], points[1]);
        Near(open[1].Places, points[1], points[2]);

        pilot.Loop = true;
        pilot.Origin = m_Object.transform;
        List<(string Shape, Color Colour, Vector3[] Places)> closed = ShownGizmos.Of(pilot);
        Assert.That(closed, Has.Count.EqualTo(3));
        Near(closed[0].Places, new Vector3(5f, 2f, 0f), new Vector3(3f, 2f, 1f));
        Near(closed[2].Places, new Vector3(3f, 2f, 0f), new Vector3(5f, 2f, 0f));
    }

    [Test]
    public void AMark_ShowsItsNormalAndItsWay_AndWhetherItIsFree()
    {
        PerchMark mark = m_Object.AddComponent<PerchMark>();
        List<(string Shape, Color Colour, Vector3[] Places)> drawn = ShownGizmos.Of(mark);

        Assert.That(drawn.Select(line => (line.Shape, line.Colour)), Is.All.EqualTo(("line", GizmoColours.Up)));
        Near(drawn[0].Places, new Vector3(3f, 2f, 1f), new Vector3(3f, 2.5f, 1f));
        Near(drawn[1].Places, new Vector3(3f, 2f, 1f), new Vector3(3.5f, 2f, 1f));
    }

    [Test]
    public void AnInsectThatDoesNotFly_ShowsNothing()
    {
        m_Object.AddComponent<InsectWings>();
        Assert.That(ShownGizmos.Of(m_Object.AddComponent<InsectFlight>()), Is.Empty);
    }

    [Test]
    public void ATrail_HoldsTheLastPlaces_FarEnoughApart_OfOneInsect()
    {
        var trail = new FlightTrail();
        Object one = m_Object, other = m_Object.transform;
        for (int k = 0; k < 1000; k++)
            trail.Add(one, new Vector3(0f, 0f, 0.01f * k));
        Assert.That(trail.Points, Has.Count.InRange(160, 200), "twenty a unit");
        for (int k = 1; k < trail.Points.Count; k++)
            Assert.That((trail.Points[k] - trail.Points[k - 1]).magnitude, Is.InRange(0.0499f, 0.0611f));

        for (int k = 0; k < 1000; k++)
            trail.Add(one, new Vector3(k, 0f, 0f));
        Assert.That(trail.Points, Has.Count.EqualTo(400));
        Assert.That((trail.Points[0], trail.Points[399]), Is.EqualTo((new Vector3(600f, 0f, 0f), new Vector3(999f, 0f, 0f))));
        trail.Add(other, Vector3.one);
        Assert.That(trail.Points, Is.EqualTo(new[] { Vector3.one }));
    }

    [Test]
    public void APen_DrawsLinesDotsAndBoxes_InTheirColours()
    {
        var pen = new ScenePen();
        StandIns.DrawnGizmos.Calls = [];
        StandIns.DrawnLines.Calls = [];
        pen.Line(Vector3.zero, Vector3.up, Color.red, false);
        pen.Line(Vector3.zero, Vector3.right, Color.blue, true);
        pen.Dot(Vector3.one, Color.green);
        pen.Box(m_Object.transform.localToWorldMatrix, new Bounds(Vector3.zero, 2f * Vector3.one), Color.cyan);
        List<(string Shape, Color Colour, Vector3[] Places)> gizmos = StandIns.DrawnGizmos.Calls;
        List<(Color Colour, Vector3[] Points)> lines = StandIns.DrawnLines.Calls;
        StandIns.DrawnGizmos.Calls = null;
        StandIns.DrawnLines.Calls = null;

        Assert.That(gizmos.Select(drawn => (drawn.Shape, drawn.Colour)),
            Is.EqualTo(new[] { ("line", Color.red), ("ball", Color.green), ("wire box", Color.cyan) }));
        Near(gizmos[0].Places, Vector3.zero, Vector3.up);
        Assert.That(gizmos[1].Places[0], Is.EqualTo(Vector3.one));
        Near(gizmos[2].Places, new Vector3(3f, 2f, 1f), new Vector3(3f, 2f, 0f), new Vector3(3f, 3f, 1f), new Vector3(4f, 2f, 1f));
        Assert.That(lines.Single().Colour, Is.EqualTo(Color.blue));
        Near(lines[0].Points, Vector3.zero, Vector3.right);
        Assert.That(Gizmos.matrix, Is.EqualTo(Matrix4x4.identity));
    }

    private static void Near(Vector3[] places, params Vector3[] expected)
    {
        Assert.That(places, Has.Length.EqualTo(expected.Length));
        for (int k = 0; k < expected.Length; k++)
            Assert.That((places[k] - expected[k]).magnitude, Is.LessThan(1e-4f), $"{k}: {places[k]}");
    }
}
