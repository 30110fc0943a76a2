using System;
using System.Globalization;
using System.Linq;
using System.Xml.Linq;
using Alate.Cli;
using Alate.Drawing;
using Alate.Fitting;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests.Cli;

/// <summary>Laws of what studies draw, tell and refuse.</summary>
public sealed class StudyLaws
{
    private static readonly XNamespace s_Svg = "http://www.w3.org/2000/svg";

    [TestCase(1f, 1f)]
    [TestCase(40f, 1f)]
    [TestCase(0.02f, 3f)]
    public void ASkeletonsPicture_FillsItsPage_WithOneScaleForWingJointsAndHinge(float length, float slenderness)
    {
        SurfaceMesh surface = TestWings.Ellipse(length: length, chord: length / slenderness);
        SkeletonFit fit = SkeletonFitter.Fit(surface,
            new SkeletonFitSettings { chains = 5, jointsPerChain = 4, hinge = Vector3.zero, forward = Vector3.forward });
        var svg = XElement.Parse(SkeletonPicture.Draw(fit));
        double[] page = Numbers((string)svg.Attribute("viewBox"));
        double[] path = Numbers(((string)svg.Element(s_Svg + "path").Attribute("d")).Replace('M', ' ').Replace('Z', ' '));
        double[] x = path.Where((_, k) => k % 2 == 0).ToArray(), y = path.Where((_, k) => k % 2 == 1).ToArray();
        double high = Math.Max(x.Max() - x.Min(), y.Max() - y.Min());

        Assert.That((x.Min(), page[2] - x.Min(), page[3] - y.Max(), y.Min()),
            Is.EqualTo((40.0, 860.0, 40.0, 40.0)).Using<(double, double, double, double)>(
            (a, b) => Math.Abs(a.Item1 - b.Item1) + Math.Abs(a.Item2 - b.Item2) + Math.Abs(a.Item3 - b.Item3)
                + Math.Abs(a.Item4 - b.Item4) < 0.4));
        Assert.That(high, Is.EqualTo(820.0).Within(0.2), "the longer side is the page less its margins");

        double scale = high / Math.Max(Extent(fit.Outline, place => place.x), Extent(fit.Outline, place => place.z));
        XElement[] circles = svg.Elements(s_Svg + "circle").ToArray();
        float2[] drawn = circles.Select(circle => new float2((float)Number(circle, "cx"), (float)Number(circle, "cy"))).ToArray();
        Vector3[] joints = fit.Skeleton.Chains.SelectMany(chain => chain.joints).Append(fit.Skeleton.Hinge).ToArray();
        Assert.That(drawn, Has.Length.EqualTo(joints.Length));
        for (int k = 1; k < joints.Length; k++)
        {
            Assert.That(drawn[k].x - drawn[0].x, Is.EqualTo(scale * (joints[k].x - joints[0].x)).Within(0.2));
            Assert.That(drawn[k].y - drawn[0].y, Is.EqualTo(-scale * (joints[k].z - joints[0].z)).Within(0.2),
                "the leading edge lies above");
        }

        // Colours run from the first of the leading chain to the last of the trailing one; the hinge has a ring.
        string[] colours = svg.Elements(s_Svg + "polyline").Select(line => (string)line.Attribute("stroke")).ToArray();
        Assert.That(colours, Is.EqualTo(new[] { "#b3261e", "#d97706", "#4d7c0f", "#0e7490", "#6d28d9" }));
        for (int k = 0; k < circles.Length - 1; k++)
            Assert.That((string)circles[k].Attribute("fill"), Is.EqualTo(colours[k / fit.Skeleton.JointsPerChain]));
        Assert.That(((string)circles[^1].Attribute("fill"), Number(circles[^1], "r")), Is.EqualTo(("none", 11.0)));
        XElement[] ways = svg.Elements(s_Svg + "polyline").ToArray();
        for (int chain = 0; chain < ways.Length; chain++)
        {
            double[] points = Numbers((string)ways[chain].Attribute("points"));
            for (int joint = 0; joint < fit.Skeleton.JointsPerChain; joint++)
            {
                float2 dot = drawn[chain * fit.Skeleton.JointsPerChain + joint];
                Assert.That(Math.Abs(points[2 * joint] - dot.x) + Math.Abs(points[2 * joint + 1] - dot.y), Is.LessThan(1e-3));
            }
        }
    }

    [TestCase(3, new[] { 0, 2, 4 })]
    [TestCase(4, new[] { 0, 1, 2, 4 })]
    [TestCase(9, new[] { 0, 0, 1, 1, 2, 2, 3, 3, 4 })]
    public void ChainsOfAPicture_TakeTheirColoursFromEndToEnd(int chains, int[] colours)
    {
        SkeletonFit fit = SkeletonFitter.Fit(TestWings.Ellipse(length: 1f, chord: 0.5f),
            new SkeletonFitSettings { chains = chains, jointsPerChain = 3, hinge = Vector3.zero, forward = Vector3.forward });
        string[] known = ["#b3261e", "#d97706", "#4d7c0f", "#0e7490", "#6d28d9"];

        Assert.That(XElement.Parse(SkeletonPicture.Draw(fit)).Elements(s_Svg + "polyline").Select(line => (string)line.Attribute("stroke")),
            Is.EqualTo(colours.Select(colour => known[colour])));
    }

    [Test]
    public void ARefusedNumber_IsToldTheBoundsThatHold_InSixDigits()
    {
        var random = new System.Random(3);
        for (int k = 0; k < 200; k++)
        {
            double own = Math.Pow(10.0, 4.0 * random.NextDouble() - 2.0), low = own * random.NextDouble(),
                high = own * (1.0 + 9.0 * random.NextDouble());
            (double from, double to) = Told(0.0, 1e6, own, value => value >= low && value <= high);

            Assert.That(from, Is.InRange(low * (1.0 - 1e-9), low * (1.0 + 1e-5)), "rounded towards what holds");
            Assert.That(to, Is.InRange(high * (1.0 - 1e-5), high * (1.0 + 1e-9)));
        }
    }

    [Test]
    public void BoundsOfEitherSign_AreFound_AndThoseOfTheOptionAreKept()
    {
        Assert.That(Told(-90.0, 90.0, 10.0, value => value is >= -30.5 and <= 20.25),
            Is.EqualTo((-30.5, 20.25)).Using<(double, double)>(Near));
        Assert.That(Told(-90.0, 90.0, -10.0, value => value is >= -30.5 and <= -2.5),
            Is.EqualTo((-30.5, -2.5)).Using<(double, double)>(Near));
        Assert.That(Told(-5.0, 7.0, 1.0, _ => true, 8.0), Is.EqualTo((-5.0, 7.0)));
        Assert.That(Told(-5.0, 7.0, 0.0, value => value == 0.0, 1.0).From, Is.Zero.Within(1e-20), "nothing but nought holds");
        Assert.That(() => TypedRange.Check("--x", 7.0, -5.0, 7.0, "it", 1.0, value => value <= 7.0), Throws.Nothing, "bounds are taken");
        Assert.That(() => TypedRange.Check("--x", -5.0, -5.0, 7.0, "it", 1.0, _ => true), Throws.Nothing);
    }

    [TestCase("speed", 0.0, 100.0)]
    [TestCase("climb", -100.0, 100.0)]
    [TestCase("wind", -100.0, 100.0)]
    [TestCase("pitch", -90.0, 90.0)]
    [TestCase("elasticity", 0.001, 1e6)]
    public void ANumberOfTheFlight_IsTakenAtItsBounds_AndRefusedBeyond(string name, double least, double most)
    {
        FlownParameter parameter = FlownParameters.Find(name);

        Assert.That((parameter.Min, parameter.Max), Is.EqualTo((least, most)));
        using var run = new CommandRun();
        if (name == "elasticity")
            return;
        string beyond = (1.001 * most).ToString(CultureInfo.InvariantCulture);
        Assert.That(run.Run("sweep", name, "0", beyond, "--out", run.Out), Is.EqualTo(2));
        Assert.That(run.Errors, Does.Contain(FormattableString.Invariant($"between {least} and {most}")));
    }

    [Test]
    [Explicit]
    [Category("Long")]
    public void Gusts_BlowInTheBeatsThatAreMeasured()
    {
        var plan = new FlightPlan { Species = "monarch", Substeps = 16, Patches = 64 };
        using var tunnel = new WindTunnel(plan, Insect.Of(plan).Wings[0]);
        WindPoint still = tunnel.Measure(0.0, true), blown = tunnel.Measure(6.0, true);

        Assert.That(blown.StretchMaxPct, Is.GreaterThan(1.2 * still.StretchMaxPct));
        Assert.That((still.Worst, still.Speed, blown.Speed), Is.EqualTo(((WindDirection)null, 0.0, 6.0)));
    }

    [Test]
    public void APortrait_SaysThePhasesOfItsPoses()
    {
        Assert.That(
            SpeciesPortrait.Compose(MonarchFlight.Level).Texts.Where(text => text.EndsWith('°')),
            Is.EqualTo(new[] { "0°", "108°", "216°" }), "0, 0.3 and 0.6 of 360°");
    }

    [Test]
    public void AFilm_HoldsAllOfTheBeatWithinEqualMargins()
    {
        var film = Film.Fly(new FilmPlan { Flight = new FlightPlan { Species = "monarch" }, Frames = 4, Beats = 1, Width = 120 });
        Color32[][] frames = film.Draw(_ => { });
        int width = film.Size.x, height = film.Size.y;
        Color32 ground = frames[0][0];
        int[] columns = Enumerable.Range(0, width * height).Where(k => frames.Any(frame => !frame[k].Equals(ground)))
            .Select(k => k % width).ToArray();
        int[] rows = Enumerable.Range(0, width * height).Where(k => frames.Any(frame => !frame[k].Equals(ground)))
            .Select(k => k / width).ToArray();
        int left = columns.Min(), right = width - 1 - columns.Max(), above = rows.Min(), below = height - 1 - rows.Max();

        Assert.That(frames.All(frame => frame.Length == width * height), Is.True);
        double inset = 14.0 * PixelPage.Fineness;
        Assert.That((double)left, Is.EqualTo(inset).Within(0.3 * inset + 2.0), $"{left} {right} {above} {below} of {width} x {height}");
        Assert.That(right, Is.EqualTo(left).Within(3));
        Assert.That(below, Is.EqualTo(above).Within(4));
        Assert.That(above, Is.GreaterThan(0.5 * inset));
    }

    // Patches have the normals and velocities of the surface around them.
    [Test]
    public void AttackOfARun_IsTheAngleBetweenTheSurfaceAndItsWay_InDegrees()
    {
        var run = DragonflyRun.Fly(MeasuredDragonfly.Tethered, true, 48);
        RecordedWing wing = run.Record.Wings[0];
        int count = wing.Frames.Count;
        int[] band = Enumerable.Range(0, wing.Rest.Length).Where(k => math.abs(math.length(wing.Rest[k]) - 0.75f) < 0.05f).ToArray();
        double[] expected = Enumerable.Range(0, count).Select(k => band.Average(vertex =>
        {
            float3 way = wing.Frames[(k + 1) % count].Positions[vertex] - wing.Frames[(k + count - 1) % count].Positions[vertex];
            return 180.0 / Math.PI * Math.Asin(Math.Min(1.0, math.abs(math.dot(math.normalize(way), wing.Frames[k].Normals[vertex]))));
        })).ToArray();

        Assert.That(run.Attack, Has.Length.EqualTo(count));
        Assert.That(run.Attack, Is.All.InRange(0.0, 90.0));
        Assert.That(run.Attack.Zip(expected, (a, b) => Math.Abs(a - b)).Average(), Is.LessThan(4.0), "degrees");
    }

    private static (double From, double To) Told(double min, double max, double own, Func<double, bool> holds, double typed = 1e9)
    {
        UserException problem = Assert.Throws<UserException>(() => TypedRange.Check("--x", typed, min, max, "it", own, holds));
        string[] words = problem.Message.Split(' ');
        Assert.That(problem.Message, Does.StartWith("--x must lie between ")
            .And.EndWith(FormattableString.Invariant($" for it; it is {typed:0.##}.")
            .Replace("1000000000", "1E+09")));
        return (double.Parse(words[4], CultureInfo.InvariantCulture), double.Parse(words[6], CultureInfo.InvariantCulture));
    }

    private static bool Near((double, double) a, (double, double) b) => Math.Abs(a.Item1 - b.Item1) + Math.Abs(a.Item2 - b.Item2) < 1e-4;

    private static double Extent(Vector3[] places, Func<Vector3, double> of) => places.Max(of) - places.Min(of);

    private static double Number(XElement element, string name) =>
        double.Parse((string)element.Attribute(name), CultureInfo.InvariantCulture);

    private static double[] Numbers(string text) => text.Split([' ', ','], StringSplitOptions.RemoveEmptyEntries)
        .Select(word => double.Parse(word, CultureInfo.InvariantCulture)).ToArray();
}
