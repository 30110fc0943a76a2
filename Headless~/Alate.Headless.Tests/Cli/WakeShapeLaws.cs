using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json;
using System.Text.RegularExpressions;
using Alate.Cli;
using Alate.Drawing;
using Alate.Wake;
using NUnit.Framework;
using StandIns;
using Unity.Mathematics;
using Unity.StandIns;
using UnityEngine;

namespace Alate.Tests.Cli;

/// <summary>Rings of a wake as pictures and files show them.</summary>
public sealed class WakeShapeLaws
{
    private const int k_Steps = 12;
    private static readonly Regex s_Cell = new(
        @"<rect x=""([\d.]+)"" y=""([\d.]+)"" width=""[\d.]+"" height=""[\d.]+"" fill=""#(\w\w)\w\w(\w\w)"" fill-opacity=""1""");

    private WakeFlight m_Wake, m_Windy;

    [OneTimeSetUp]
    public void Shed()
    {
        var plan = new FlightPlan { Species = "dragonfly", Speed = 1.5, Substeps = 24 };
        var wake = new WakePlan { StepsPerBeat = k_Steps, SpanPanels = 5, Keep = 1.5 };
        m_Wake = new WakeFlight(TetheredFlight.Fly(plan), wake, isShown: true);
        m_Wake.Run(_ => { });
        m_Windy = new WakeFlight(TetheredFlight.Fly(plan with { Wind = [0.3, 0.0, 0.0] }), wake, isShown: true);
        m_Windy.Run(_ => { });
    }

    [OneTimeTearDown]
    public void Free()
    {
        m_Wake.Dispose();
        m_Windy.Dispose();
    }

    [Test]
    public void AWake_LeavesNoMemory()
    {
        int live = NativeMemoryLedger.LiveCount;
        using (var wake = new WakeFlight(m_Wake.Flight, new WakePlan { StepsPerBeat = k_Steps, SpanPanels = 5, Keep = 0.5 }))
        {
            wake.Run(_ => { });
            Assert.That(NativeMemoryLedger.LiveCount, Is.GreaterThan(live));
        }

        Assert.That(NativeMemoryLedger.LiveCount, Is.EqualTo(live), NativeMemoryLedger.Describe());
    }

    // The strongest circulation, above 0, at the tip and the begin of the beat; the strongest one below 0 at the root and its end.
    [Test]
    public void TheMapOfTheSpan_HasTheTipAbove_TheBeatFromTheLeft_AndLiftRed()
    {
        WakeStrip[] Strips(float tip, float root) =>
            [new(0.25, root, default, new float3(0f, root, 0f)), new(0.75, tip, default, new float3(0f, tip, 0f))];
        WakeMoment At(double turns, float tip, float root) => new(
            turns, [.. m_Wake.Wings.Select(_ => new WakeLoad(default, default, 0.0, default, Strips(tip, root)))], true);
        string page = SpanPicture.Draw(m_Wake, [At(0.0, 1f, 0f), At(0.5, 0f, -1f)]);
        (double X, double Y, bool IsRed)[] cells = [.. s_Cell.Matches(page).Select(cell => (
            double.Parse(cell.Groups[1].Value, CultureInfo.InvariantCulture),
            double.Parse(cell.Groups[2].Value, CultureInfo.InvariantCulture),
            Convert.ToInt32(cell.Groups[3].Value, 16) > Convert.ToInt32(cell.Groups[4].Value, 16)))];

        Assert.That(cells, Has.Length.EqualTo(4 * m_Wake.Wings.Count), "circulation and air of each wing, each with its two extremes");
        for (int k = 0; k < cells.Length; k += 2)
        {
            Assert.That((cells[k].IsRed, cells[k + 1].IsRed), Is.EqualTo((true, false)));
            Assert.That(cells[k].X, Is.LessThan(cells[k + 1].X));
            Assert.That(cells[k].Y, Is.LessThan(cells[k + 1].Y));
        }
    }

    // Where the wing's trailing edge is at that moment, a quarter of its way behind it; metres of the body.
    [Test]
    public void TheNewestRow_IsAtTheTrailingEdge()
    {
        RecordedWing fore = m_Wake.Wings[0];
        for (int step = 0; step < k_Steps; step++)
        {
            ShapedSheet sheet = m_Wake.Shapes[step][0];
            float3[] wing = fore.At((double)step / k_Steps).Positions;
            float far = Enumerable.Range(0, sheet.Width).Max(k => wing.Min(place => math.distance(place, sheet.Points[k])));
            Assert.That(far, Is.LessThan(0.25f * fore.Placement.Length), $"step {step}");
            Assert.That(sheet.Rows, Is.EqualTo(m_Wake.Shapes[0][0].Rows));
        }
    }

    [Test]
    public void AStream_CarriesARow_FromStepToStep()
    {
        float3 stream = m_Wake.Flight.Plan.AirInBodyAxes * (float)(m_Wake.Period / k_Steps);
        for (int step = 1; step < k_Steps; step++)
        {
            ShapedSheet before = m_Wake.Shapes[step - 1][0], now = m_Wake.Shapes[step][0];
            float3 moved = default;
            for (int k = 0; k < (now.Rows - 1) * now.Width; k++)
                moved += (now.Points[k + now.Width] - before.Points[k]) / ((now.Rows - 1) * now.Width);
            Assert.That(math.distance(moved, stream), Is.LessThan(0.6f * math.length(stream)), "and the vortices a little more");
            int rings = now.Width - 1;
            Assert.That(
                now.Circulation[(2 * rings)..], Is.EqualTo(before.Circulation[rings..^rings]).Within(1e-9f),
                "a ring keeps its circulation");
        }
    }

    [Test]
    public void LeftSheets_AreMirrorImages_AndWhereBothAreComputed_TurnAlike()
    {
        List<ShapedSheet> sheets = m_Wake.Shapes[k_Steps / 4];
        Assert.That((m_Wake.IsSymmetric, sheets.Count), Is.EqualTo((true, 4)));
        Assert.That(sheets[2].Points.Select(point => point * new float3(-1f, 1f, 1f)), Is.EqualTo(sheets[0].Points));
        Assert.That(sheets[2].Circulation, Is.EqualTo(sheets[0].Circulation));

        List<ShapedSheet> windy = m_Windy.Shapes[k_Steps / 4];
        Assert.That((m_Windy.IsSymmetric, windy.Count), Is.EqualTo((false, 4)));
        Assert.That(m_Windy.Wings.Select(wing => wing.Placement.IsLeft).Distinct().Count(), Is.EqualTo(2));
        float[] shed = [.. windy.Select(sheet => sheet.Circulation.Take(sheet.Width - 1).Sum())];
        Assert.That(shed, Is.All.GreaterThan(0f), "in the middle of the downstroke all wings are pushed up");
    }

    // Metres of a reference length of 3 and seconds of a period of 0.5: places grow by the length, circulation by its square over the time.
    [Test]
    public void ASheet_IsCopiedInMetresAndSeconds_WithTheSignOfItsSide()
    {
        var settings = new WakeSettings { SpanPanels = 4, StepsPerBeat = 8, Stream = new float3(0f, 0f, -4f) };
        using var wake = new FreeWake(settings, [new WakeWing(ThinWing.Steady(2f, 0.1))]);
        for (int k = 0; k < 5; k++)
            wake.Step();
        ShapedSheet one = ShapedSheet.Of(wake.Sheet(0), 1.0, 1.0, true), large = ShapedSheet.Of(wake.Sheet(0), 3.0, 0.5, true),
            right = ShapedSheet.Of(wake.Sheet(0), 1.0, 1.0, false);

        Assert.That(one.Circulation.Max(Math.Abs), Is.GreaterThan(0.01f));
        Assert.That(large.Points, Is.EqualTo(one.Points.Select(point => 3f * point)));
        Assert.That(large.Circulation, Is.EqualTo(one.Circulation.Select(circulation => 18f * circulation)).Within(1e-5f));
        Assert.That(right.Circulation, Is.EqualTo(one.Circulation.Select(circulation => -circulation)));
        Assert.That(one.Circulation[0], Is.EqualTo(wake.Sheet(0).Circulation(0, 0)));
    }

    [Test]
    public void ASheet_IsThinned_AndCut_ByWholeRows()
    {
        var sheet = new ShapedSheet(
            3, [.. Enumerable.Range(0, 15).Select(k => new float3(k, 0f, 0f))], [.. Enumerable.Range(0, 8).Select(k => 1f + k)]);

        Assert.That(sheet.Rows, Is.EqualTo(5));
        Assert.That(sheet.Every(2).Points.Select(point => point.x), Is.EqualTo(new[] { 0f, 1f, 2f, 6f, 7f, 8f, 12f, 13f, 14f }));
        Assert.That(sheet.Every(2).Circulation, Is.EqualTo(new[] { 1f, 2f, 5f, 6f }));
        Assert.That(sheet.Newest(2).Points.Select(point => point.x), Is.EqualTo(new[] { 0f, 1f, 2f, 3f, 4f, 5f }));
        Assert.That(sheet.Newest(2).Circulation, Is.EqualTo(new[] { 1f, 2f }));
        Assert.That(sheet.Newest(9), Is.SameAs(sheet));
        Assert.That(
            Enumerable.Range(0, 3).Select(point => sheet.CirculationAt(1, point)), Is.EqualTo(new[] { 1.5f, 3.5f, 2f }),
            "half of one ring at the ends, the mean of two between them");
        Assert.That(sheet.CirculationAt(4, 1), Is.Zero);
    }

    // A row of rings is shed, drifts, shrinks where it is oldest, and goes back to the wing without being seen.
    [Test]
    public void ALoop_CarriesEachRowOfRings_FromTheWingToItsEnd_AndBackUnseen()
    {
        var loop = new WakeLoop(m_Wake);
        int rows = m_Wake.Shapes[0][0].Rows, width = m_Wake.Shapes[0][0].Width;
        Assert.That((loop.Steps, loop.Keys, loop.SheetCount), Is.EqualTo((k_Steps, loop.Beats * k_Steps, 4)));
        Assert.That(loop.Keys, Is.GreaterThan(rows), "it shrinks before it goes back");
        for (int key = 0; key < loop.Keys; key++)
        {
            float3[] places = loop.Places(1, key);
            ShapedSheet shape = m_Wake.Shapes[key % k_Steps][1];
            for (int shed = 0; shed < loop.Keys; shed++)
            {
                int age = (key - shed + loop.Keys) % loop.Keys;
                float3[] older = places[(2 * shed * width)..((2 * shed + 1) * width)];
                float3[] newer = places[((2 * shed + 1) * width)..((2 * shed + 2) * width)];
                int row = math.min(age, rows - 1);
                Assert.That(older, Is.EqualTo(shape.Points[(row * width)..((row + 1) * width)]));
                if (age == 0 || age >= rows)
                    Assert.That(newer, Is.EqualTo(older), "as thin as a line");
                else
                    Assert.That(newer, Is.EqualTo(shape.Points[((age - 1) * width)..(age * width)]));
            }
        }

        float4[] colours = loop.Colours(1);
        Assert.That((colours.Length, loop.Triangles(1).Length), Is.EqualTo((loop.Keys * 2 * width, loop.Keys * (width - 1) * 6)));
        Assert.That(loop.Triangles(1).Max(), Is.EqualTo(colours.Length - 1));
        Assert.That(colours[..width], Is.EqualTo(colours[width..(2 * width)]), "a row of rings has its colour on both sides");
    }

    [Test]
    public void TheAnimation_BeatsTheWings_ThroughTheLoopOfTheWake()
    {
        using var stream = new MemoryStream();
        var loop = new WakeLoop(m_Wake);
        WingsGlb.Write(m_Wake.Flight, stream, beside: new WakeGlb(loop));
        var file = new GlbFile(stream.ToArray());
        JsonElement[] meshes = [.. file.Root.GetProperty("meshes").EnumerateArray()];
        JsonElement animation = file.Root.GetProperty("animations")[0];
        double[] ends = [.. animation.GetProperty("samplers").EnumerateArray().Select(sampler =>
            file.Root.GetProperty("accessors")[sampler.GetProperty("input").GetInt32()].GetProperty("max")[0].GetDouble())];

        Assert.That(meshes.Select(mesh => mesh.GetProperty("name").GetString()).TakeLast(4),
            Is.EqualTo(new[] { "wake 1", "wake 2", "wake 3", "wake 4" }));
        Assert.That(meshes[^1].GetProperty("primitives")[0].GetProperty("targets").GetArrayLength(), Is.EqualTo(loop.Keys - 1));
        Assert.That(ends, Is.All.EqualTo(loop.Beats * m_Wake.Period).Within(1e-6), "seconds");
        Assert.That(animation.GetProperty("channels").GetArrayLength(), Is.EqualTo(4 + 4));
        Assert.That(file.Root.GetProperty("extensionsUsed").EnumerateArray().Select(used => used.GetString()),
            Does.Contain("KHR_materials_unlit"));
        using var folder = new TemporaryFolder();
        string path = folder.PathOf("wake.glb");
        File.WriteAllBytes(path, stream.ToArray());
        GlbLooksTests.Validate(path);
    }

    // As the camera of the insect sees them, from far enough to see all.
    [TestCase(0.0, 0)]
    [TestCase(0.25, 3)]
    [TestCase(0.79, 9)]
    [TestCase(0.99, 0)]
    public void RingsOfAPhoto_AreThoseOfItsPhase(double turns, int step)
    {
        PictureView view = PictureView.ByName["top"];
        PhotoScene scene = new WakePhoto(m_Wake).AddTo(FlightPhoto.Scene(m_Wake.Flight, view), turns);
        List<float3[]> seen = scene.PoseAt(turns).Places;
        List<ShapedSheet> sheets = m_Wake.Shapes[step].ConvertAll(sheet => sheet.Newest(3 * k_Steps / 2 + 1));
        float reach = m_Wake.Shapes.Max(shown => shown.Max(sheet => sheet.Newest(3 * k_Steps / 2 + 1).Points.Max(math.length)));
        var camera = new PictureCamera(view, 5f * reach);

        Assert.That(seen, Has.Count.EqualTo(1 + m_Wake.Flight.Wings.Count + 4));
        for (int k = 0; k < 4; k++)
        {
            float3[] expected = Array.ConvertAll(sheets[k].Points, camera.Project);
            Assert.That(seen[seen.Count - 4 + k].Zip(expected, math.distance).Max(), Is.LessThan(1e-4f * reach), $"sheet {k}");
        }
    }

    [TestCase(1.2f, 1.5e-5)]
    [TestCase(998f, 1.0e-6)]
    public void Fluids_HaveTheViscosityOfAirOrWater(float density, double expected) =>
        Assert.That(WakeFluid.ViscosityOf(density), Is.EqualTo(expected).Within(1).Percent);

    [Test]
    public void AStrongRing_IsDense_AndItsColourSaysHowItTurns()
    {
        float4 strong = WakeColours.Of(1f), weak = WakeColours.Of(0.1f), other = WakeColours.Of(-1f);

        Assert.That(strong.w, Is.GreaterThan(4f * weak.w));
        Assert.That(strong.x, Is.GreaterThan(2f * strong.z), "red");
        Assert.That(other.z, Is.GreaterThan(2f * other.x), "blue");
        Assert.That(WakeColours.Of(3f), Is.EqualTo(strong));
        Assert.That(WakeColours.Strongest(m_Wake.Shapes[3]), Is.EqualTo(m_Wake.Shapes[3].Max(sheet => sheet.Circulation.Max(math.abs))));
        Assert.That(WakeColours.Strongest([]), Is.GreaterThan(0f));
    }

    [Test]
    [Explicit]
    [Category("Long")]
    public void ThePicture_ShowsRingsOfBothColours_BehindTheInsect_AndSaysHowStrongTheyAre()
    {
        PixelPage page = WakePicture.Compose(m_Wake);
        float strongest = new WakePhoto(m_Wake).Strongest;
        Assert.That(strongest, Is.EqualTo(WakeColours.Strongest(m_Wake.Shapes.SelectMany(sheets => sheets))));
        var picture = PngFile.Read(page.Write());
        int Columns(Func<Color32, bool> isSeen, Func<IEnumerable<int>, int> which) => which(
            Enumerable.Range(0, picture.Pixels.Length).Where(k => isSeen(picture.Pixels[k]) && k % picture.Width > picture.Width / 2)
                .Select(k => k % picture.Width));

        Assert.That(page.Texts, Does.Contain("Dragonfly"));
        Assert.That(page.Texts[1], Does.EndWith(FormattableString.Invariant($"up to {1e4f * strongest:0} cm²/s")));
        Assert.That(picture.Pixels.Count(pixel => pixel.r > pixel.b + 60), Is.GreaterThan(2000));
        Assert.That(picture.Pixels.Count(pixel => pixel.b > pixel.r + 30), Is.GreaterThan(500));
        // From its left the insect looks to the left: the air carries the rings to the right of it.
        Assert.That(
            Columns(pixel => pixel.r > pixel.b + 60, columns => columns.Max()),
            Is.GreaterThan(Columns(pixel => pixel.r + pixel.g + pixel.b < 150, columns => columns.Min()) + 300));
    }

    [Test]
    [Explicit]
    [Category("Long")]
    public void PicturesSmoothTheWake_AndItsLoadsStay()
    {
        FlightPlan plan = WakeFigures.Flown;
        using var wake = new WakeFlight(TetheredFlight.Fly(plan), new WakePlan());
        double Lift(WakeFlight flight) => flight.Run(_ => { }).Average(at => at.Force.y);
        double lift = Lift(wake);
        using var smooth = WakeFlight.Smooth(wake.Flight, wake.Plan, 16);
        using var again = new WakeFlight(wake.Flight, smooth.Plan);

        Assert.That(smooth.Shapes, Has.Count.EqualTo(48), "the least of 40 steps and more that meets sixteen moments");
        Assert.That(Lift(again), Is.EqualTo(lift).Within(2).Percent);
        Assert.That((wake.Shapes.Count, wake.Plane), Is.EqualTo((0, (WakePlane)null)), "kept where it is shown alone");
        using var large = WakeFlight.Smooth(wake.Flight, new WakePlan { Beats = 1, SpanPanels = 60, Keep = 50 });
        Assert.That((large.Plan.SpanPanels, large.Plan.Keep), Is.EqualTo((24, 3.0)));
    }
}
