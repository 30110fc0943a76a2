using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
using Alate.Cli;
using Alate.Drawing;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Cli;

/// <summary>
/// Laws of every picture of pixels: words lie on the page, beside one another and beside the photos, and headings stand over what they
/// name.
/// </summary>
public sealed class LayoutLaws
{
    private static readonly FlightPlan s_Fishfly = new() { Species = "fishfly", Substeps = 12, Patches = 64 };

    private FlightRecord m_Flight;

    [OneTimeSetUp]
    public void Fly() => m_Flight = TetheredFlight.Fly(s_Fishfly);

    [Test]
    public void AStrip_HasAngleAndTimeBelowEachPhase()
    {
        PixelPage page = BeatStrip.Compose(m_Flight, out StripLayout layout);
        AssertTidy(page);

        Assert.That(page.Size, Is.EqualTo(new float2(layout.Width, layout.Height)));
        Assert.That(page.Title, Is.EqualTo("Fishfly: twelve phases of a beat, seen from the front left"));
        AssertHeading(page, 1200f);
        Assert.That((page.Words[0].Size, page.Words[1].Size), Is.EqualTo((24f, 17f)));
        for (int k = 0; k < 12; k++)
        {
            PixelWords angle = page.Words[2 + 2 * k], time = page.Words[3 + 2 * k];
            float middle = layout[k].Left + 0.5f * layout[k].Width, below = layout[k].Top + layout[k].Height;
            Assert.That(middle - Right(angle), Is.EqualTo(time.At.x - middle).Within(0.01f).And.InRange(2f, 10f));
            Assert.That((angle.At.y, time.At.y), Is.EqualTo((below + 10f, below + 10f)));
            Assert.That((angle.Size, time.Size, time.Look), Is.EqualTo((17f, 13f, "t")));
        }
    }

    [Test]
    public void AStretchMap_HasItsScaleBelowTheWorstPlace()
    {
        PixelPage page = StretchMap.Compose(m_Flight);
        AssertTidy(page);
        AssertHeading(page, 760f);
        PixelWords worst = page.Words[2], none = page.Words[3], most = page.Words[4];

        Assert.That((Right(worst), Right(most), none.At.x), Is.EqualTo((734f, 734f, 514f)).Using<(float, float, float)>(Near));
        Assert.That((none.At.y, most.At.y), Is.EqualTo((74f, 74f)), "10 of the ramp, and a line of words");
        Assert.That((page.Size.x, page.Size.y - page.Panels[0].Top - page.Panels[0].Height), Is.EqualTo((760f, 20f)));
        Assert.That((page.Panels[0].Left, page.Panels[0].Top, page.Panels[0].Width), Is.EqualTo((0f, 74f, 760f)));
    }

    [Test]
    public void APortrait_HasTheAngleBelowEachPhase()
    {
        PixelPage page = SpeciesPortrait.Compose(m_Flight);
        AssertTidy(page);
        for (int k = 0; k < 3; k++)
        {
            Assert.That(Middle(page.Words[k]), Is.EqualTo(page.Panels[k].Left + 0.5f * page.Panels[k].Width).Within(0.01f));
            Assert.That(page.Words[k].At.y, Is.EqualTo(page.Panels[k].Top + page.Panels[k].Height + 12f).Within(0.01f));
            Assert.That((page.Words[k].Size, page.Words[k].Look), Is.EqualTo((15f, "t")));
        }

        Assert.That(page.Size, Is.EqualTo(new float2(960f, page.Panels[0].Top + page.Panels[0].Height + 26f)));
    }

    [TestCase("fishfly")]
    [TestCase("monarch")]
    public void AComparison_HasItsHeadingsOverTheColumns_AndItsNumbersUnderThem(string species)
    {
        IReadOnlyList<ComparisonColumn> columns = ComparisonColumn.All;
        Comparison flown = Comparison.Fly(new ComparisonPlan([s_Fishfly with { Species = species }], columns, 2), _ => { }).Single();
        PixelPage page = ComparisonPicture.Compose(flown);
        AssertTidy(page);
        AssertHeading(page, page.Size.x);
        float last = page.Panels.Max(panel => panel.Top + panel.Height);
        for (int column = 0; column < 4; column++)
        {
            StripPanel panel = page.Panels[column];
            float middle = panel.Left + 0.5f * panel.Width;
            PixelWords title = page.Words.First(words => words.Text == columns[column].Title);
            Assert.That((Middle(title), title.At.y, title.Look), Is.EqualTo((middle, 68f, "b")).Using<(float, float, string)>(
                (a, b) => math.abs(a.Item1 - b.Item1) < 0.01f && a.Item2 == b.Item2 && a.Item3 == b.Item3));
            string[] description =
            [
                .. page.Words.Where(words => math.abs(Middle(words) - middle) < 0.01f && words.At.y is > 70f and < 100f
                    && words.Text.Length > 0)
                    .Select(words => words.Text),
            ];
            Assert.That(string.Join(' ', description), Is.EqualTo(columns[column].Description));
            PixelWords[] own = [.. page.Words.Where(words => words.At.y > last + 20f && words.At.x > panel.Left
                && words.At.x < panel.Left + panel.Width)];
            float[] lines = [.. own.Where(words => words.Size is 12f or 13f).Select(words => words.At.y).Distinct()];
            Assert.That(lines, Has.Length.EqualTo(species == "fishfly" ? 8 : 7),
                "a line a measure, the lift, and the wings' names where there are two");
            // Below the last photo its gap, the line, and the first line of numbers.
            Assert.That(lines[0], Is.EqualTo(last + 4f + 12f + 24f).Within(0.01f));
            Assert.That(lines.Zip(lines.Skip(1), (a, b) => b - a), Is.All.EqualTo(19f).Within(0.01f));
            Assert.That(own.Where(words => words.Size == 13f && words.Anchor == "start" && words.Text != "†").Select(words => words.At.x),
                Is.All.EqualTo(middle - 84f).Within(0.01f));
            float[] ends = [.. own.Where(words => words.Anchor == "end").Select(Right).Distinct().Order()];
            Assert.That(ends.Select(end => math.min(math.abs(end - middle - 38f), math.abs(end - middle - 104f))), Is.All.LessThan(0.01f),
                "numbers end below one another");
            Assert.That(own.Where(words => words.Text == "†").All(mark => own.Any(number =>
                number.At.y == mark.At.y && math.abs(Right(number) + 4f - mark.At.x) < 0.01f)), Is.True,
                    "marks stand behind their numbers");
        }

        Assert.That(page.Words[^1].At.y - page.Words[^2].At.y, Is.EqualTo(15f).Within(0.01f));
        Assert.That(page.Size.y - page.Words[^1].At.y, Is.EqualTo(15f).Within(0.01f));
        double first = SurfaceDistance.FarthestPhase(flown.Flights[0].Summary.Flight.Wings, flown.Held.Summary.Flight.Wings);
        Assert.That(flown.Phases, Is.EqualTo(new[] { first, (first + 0.5) % 1.0 }), "the first row shows the difference best");
    }

    [TestCase(2, "On")]
    [TestCase(2, "Both")]
    [TestCase(9, "Off")]
    public void ASweep_HasEachValueOverItsColumn_AndEachPhaseBesideItsRow(int steps, string wave)
    {
        SweepWaves waves = System.Enum.Parse<SweepWaves>(wave);
        var plan = new SweepPlan(FlownParameters.Find("pitch"), 0.0, 20.0, steps,
            new FlightPlan { Species = "monarch", Substeps = 12, Patches = 64 }, waves);
        PixelPage page = SweepPicture.Compose(Sweep.Fly(plan, _ => { }));
        AssertTidy(page);
        AssertHeading(page, page.Size.x);
        int columns = System.Math.Min(steps, 8), rows = waves == SweepWaves.Both ? 8 : 4;
        Assert.That(page.Panels, Has.Count.EqualTo(rows * columns));
        Assert.That(page.Panels[0].Width, Is.EqualTo(steps == 2 ? 210f : 118f), "as wide as 1,000 allow, at most 210");
        PixelWords[] values = [.. page.Words.Where(words => words.At.y == 72f)],
            angles = [.. page.Words.Where(words => words.Text.EndsWith('°') && words.Anchor == "end" && words.At.y > 80f)];
        for (int k = 0; k < columns; k++)
            Assert.That(Middle(values[k]), Is.EqualTo(page.Panels[k].Left + 0.5f * page.Panels[k].Width).Within(0.01f));
        Assert.That(angles, Has.Length.EqualTo(rows));
        for (int row = 0; row < rows; row++)
        {
            StripPanel panel = page.Panels[row * columns];
            Assert.That(angles[row].Text, Is.EqualTo($"{90 * (row % 4)}°"));
            Assert.That(Right(angles[row]), Is.EqualTo(panel.Left - 8f).Within(0.01f));
            Assert.That(angles[row].At.y, Is.EqualTo(panel.Top + 0.5f * panel.Height + 5f).Within(0.01f));
        }

        string[] told = [.. page.Words.Where(words => words.Text.Contains("the deformation wave")).Select(words => words.Text)];
        Assert.That(told, Is.EqualTo(waves == SweepWaves.On ? [] : waves == SweepWaves.Off ? ["without the deformation wave"]
            : new[] { "with the deformation wave", "without the deformation wave" }));
        Assert.That(page.Size.x, Is.EqualTo(math.max(760f, page.Panels.Max(panel => panel.Left + panel.Width) + 26f)));
        Assert.That(page.Size.y, Is.EqualTo(math.ceil(page.Panels.Max(panel => panel.Top + panel.Height) + 4f + 10f + 6f)));
    }

    // The name in the upper left corner, what it is about in the right one.
    private static void AssertHeading(PixelPage page, float width)
    {
        PixelWords name = page.Words.First(words => words.Look == "b" && words.At.y < 45f);
        Assert.That(name.At.x, Is.EqualTo(26f));
        Assert.That(name.At.y, Is.InRange(36f, 42f));
        PixelWords right = page.Words.First(words => words.Anchor == "end" && words.At.y < 42f);
        Assert.That(Right(right), Is.EqualTo(width - 26f).Within(0.01f));
        Assert.That(name.At.y - right.At.y, Is.EqualTo(1f));
    }

    private static void AssertTidy(PixelPage page)
    {
        List<(string What, float2 Min, float2 Max)> boxes = [.. page.Words.Where(words => words.Text.Length > 0).Select(Box)];
        foreach ((string what, float2 min, float2 max) in boxes)
            Assert.That(math.all(min > 4f) && math.all(max < page.Size - 4f), Is.True, $"'{what}' at {min} to {max} of {page.Size}");
        foreach (PixelWords words in page.Words)
        {
            Assert.That(words.Anchor, Is.AnyOf("start", "middle", "end"));
            Assert.That(words.Look, Is.AnyOf("", "t", "b"));
            Assert.That(words.Size, Is.InRange(11f, 24f));
        }

        for (int k = 0; k < boxes.Count; k++)
        {
            for (int other = 0; other < k; other++)
                Assert.That(Overlap(boxes[k], boxes[other], 0f), Is.False, $"'{boxes[k].What}' over '{boxes[other].What}'");
            foreach (StripPanel panel in page.Panels)
            {
                Assert.That(Overlap(boxes[k], ("", new float2(panel.Left, panel.Top),
                    new float2(panel.Left + panel.Width, panel.Top + panel.Height)), 4f),
                    Is.False, $"'{boxes[k].What}' over a photo");
            }
        }

        foreach (StripPanel panel in page.Panels)
        {
            Assert.That(panel.Left >= 0f && panel.Top >= 0f && panel.Left + panel.Width <= page.Size.x
                && panel.Top + panel.Height <= page.Size.y, Is.True);
        }
    }

    private static (string What, float2 Min, float2 Max) Box(PixelWords words) =>
        (words.Text, words.At - new float2(0f, 0.72f * words.Size), new float2(Right(words), words.At.y + 0.1f * words.Size));

    private static bool Overlap((string What, float2 Min, float2 Max) one, (string What, float2 Min, float2 Max) other, float slack) =>
        math.all(one.Min + slack < other.Max) && math.all(other.Min + slack < one.Max);

    private static float Right(PixelWords words) => words.At.x + Lettering.Width(words.Text, words.Size);

    private static float Middle(PixelWords words) => words.At.x + 0.5f * Lettering.Width(words.Text, words.Size);

    private static bool Near((float, float, float) a, (float, float, float) b) =>
        math.abs(a.Item1 - b.Item1) + math.abs(a.Item2 - b.Item2) + math.abs(a.Item3 - b.Item3) < 0.05f;
}
