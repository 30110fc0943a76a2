using System.Collections.Generic;
using System.Linq;
using Alate.Editor;
using Alate.Editor.Tests;
using NUnit.Framework;
using StandIns;
using UnityEngine;

namespace Alate.Tests.Editor;

/// <summary>Handles of a skeleton keep their size on the screen, each at its own distance; and the texts beside them.</summary>
public sealed class HandleSizeTests : EditingFixture
{
    private readonly Matrix4x4 m_Place = Matrix4x4.TRS(new Vector3(1f, 2f, 3f), Quaternion.Euler(10f, 40f, 0f), new Vector3(2f, 2f, 2f));

    [SetUp]
    public void Put()
    {
        Editing.LocalToWorld = m_Place;
        SceneEye.HandleSize = SizeAt;
    }

    [TearDown]
    public void Forget()
    {
        SceneEye.HandleSize = null;
        (DrawnLines.Calls, DrawnLines.Widths, DrawnLines.Labels, DrawnGizmos.Calls) = (null, null, null, null);
    }

    [Test]
    public void DotsRingsAndArrows_AreInProportionToTheHandleSize_WhereTheyAre()
    {
        Skeleton.Hinge = new Vector3(-0.3f, 0.2f, 0.4f);
        Skeleton.Chains[2].joints[3] = Skeleton.GetJoint(2, 2);
        DrawnLines.Calls = [];
        SkeletonDrawing.Draw(Editing, true, false, null);
        List<(Color Colour, Vector3[] Points)> drawn = DrawnLines.Calls;
        (Color Colour, Vector3[] Points)[] dots = [.. drawn.Where(call => call.Colour == SkeletonColours.joint)];

        Assert.That(dots, Has.Length.EqualTo(25));
        foreach ((Color _, Vector3[] points) in dots)
            Assert.That(points[1].x, Is.EqualTo(0.045f * SizeAt(points[0])).Within(1e-5f));
        (Color Colour, Vector3[] Points)[] rings =
            [.. drawn.Where(call => call.Colour == SkeletonColours.problem || call.Colour == SkeletonColours.hinge)];
        Assert.That(rings, Has.Length.EqualTo(2));
        foreach ((Color _, Vector3[] points) in rings)
        {
            Assert.That(Vector3.Distance(points[1], 0.1f * SizeAt(points[0]) * Vector3.up),
                Is.LessThan(1e-5f), "flat, where no camera looks");
        }

        Vector3 hinge = m_Place.MultiplyPoint3x4(Skeleton.Hinge);
        float[] arrows = [.. drawn.Where(call => call.Points.Length == 2 && Vector3.Distance(call.Points[0], hinge) < 1e-5f
            && call.Colour != SkeletonColours.hinge).Select(call => call.Points[1].x)];
        Assert.That(arrows, Is.EqualTo(new[] { 0.8f * SizeAt(hinge), 0.8f * SizeAt(hinge) }).Within(1e-5f));
    }

    [Test]
    public void Bones_AreThreePixelsWide_AndTheRimOfARingTwo()
    {
        DrawnLines.Widths = [];
        SkeletonDrawing.Draw(Editing, true, false, null);
        Assert.That(DrawnLines.Widths, Is.EqualTo(new[] { 3f, 3f, 3f, 3f, 3f, 2f }));
    }

    [Test]
    public void Labels_CountTheChainsAtTheirTips_AndTheJointsOfTheFirst()
    {
        DrawnLines.Labels = [];
        SkeletonDrawing.Draw(Editing, true, true, null);
        List<(string Text, Vector3 Place)> wanted = [.. Enumerable.Range(0, 5).Select(i => ($"  chain {i}", World(i, 4))),
            .. Enumerable.Range(0, 4).Select(j => ($"  {j}", World(0, j))), ("\n  hinge", m_Place.MultiplyPoint3x4(Skeleton.Hinge))];
        Assert.That(DrawnLines.Labels, Is.EqualTo(wanted));
    }

    [Test]
    public void AnAxisThatIsNone_AndAHingeThatIsNowhere_HaveNoArrow()
    {
        Skeleton.SpanAxis = Vector3.zero;
        Assert.That(Arrows(), Is.Zero);
        Skeleton.SpanAxis = Vector3.right;
        Assert.That(Arrows(), Is.EqualTo(2));
        Skeleton.Hinge = new Vector3(float.NaN, 0f, 0f);
        Assert.That(Arrows(), Is.Zero);

        int Arrows()
        {
            DrawnLines.Calls = [];
            SkeletonDrawing.Draw(Editing, true, false, null);
            return DrawnLines.Calls.Count(call => call.Points.Length == 2
                && Mathf.Abs(call.Points[1].x - 0.8f * SizeAt(call.Points[0])) < 1e-4f);
        }
    }

    [Test]
    public void APensDots_KeepTheirSizeToo_AndItsWideLinesAreTwoAndAHalfPixels()
    {
        var pen = new ScenePen();
        (DrawnGizmos.Calls, DrawnLines.Widths) = ([], []);
        var at = new Vector3(3f, 0f, 4f);
        pen.Dot(at, Color.green);
        pen.Line(at, Vector3.zero, Color.green, true);
        Vector3[] ball = DrawnGizmos.Calls.Single().Places;
        Assert.That(Vector3.Distance(ball[1], ball[0]), Is.EqualTo(0.035f * SizeAt(at)).Within(1e-5f));
        Assert.That(DrawnLines.Widths, Is.EqualTo(new[] { 2.5f }));
    }

    private static float SizeAt(Vector3 place) => 1f + 0.5f * place.x + 0.25f * place.magnitude;

    private Vector3 World(int chain, int joint) => m_Place.MultiplyPoint3x4(Skeleton.GetJoint(chain, joint));
}
