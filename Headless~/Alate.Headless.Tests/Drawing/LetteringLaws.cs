using System.Collections.Generic;
using System.Linq;
using Alate.Drawing;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Drawing;

/// <summary>Laws of letters, pens and the words on pictures.</summary>
public sealed class LetteringLaws
{
    private const string k_Straight = "AEFHIKLMNTVWXYZ147";

    // At this size a unit of the glyphs' grid, a seventh of a capital, is one.
    private const float k_Unit = 7f / 0.72f;

    [Test]
    public void CapitalsOfStraightLines_ReachFromTheBaseLineToTheirHeight_AndAreAsWideAsTold()
    {
        foreach (char letter in k_Straight)
        {
            float2[] points = [.. Lettering.Strokes($"{letter}", 10f, false).Strokes.SelectMany(stroke => stroke)];
            Assert.That(points.Max(point => point.y), Is.EqualTo(0f).Within(1e-5f), $"{letter}");
            Assert.That(points.Min(point => point.y), Is.EqualTo(-7.2f).Within(1e-4f), $"{letter}");
            Assert.That(points.Min(point => point.x), Is.EqualTo(0f).Within(1e-5f), $"{letter}");
            Assert.That(points.Max(point => point.x), Is.EqualTo(Lettering.Width($"{letter}", 10f)).Within(1e-4f), $"{letter}");
        }
    }

    [Test]
    public void WordsAreLettersBesideOneAnother_WithOneGap_AndASpaceIsTwoMore()
    {
        float gap = Lettering.Width("II", 20f), own = 0f;
        const string k_Word = "wing 4.5%";
        foreach (char letter in k_Word)
            own += letter == ' ' ? 2f * gap : Lettering.Width($"{letter}", 20f) + gap;

        // An I has no width; of seven parts of a capital's height, narrowed, the gap takes 2.3.
        Assert.That(gap, Is.EqualTo(2.3f * 0.82f * 0.72f * 20f / 7f).Within(1e-4f));
        Assert.That(Lettering.Width(k_Word, 20f), Is.EqualTo(own - gap).Within(1e-3f));
        Assert.That(Lettering.Width("", 20f), Is.Zero);
        Assert.That(Lettering.Width(k_Word, 40f), Is.EqualTo(2f * Lettering.Width(k_Word, 20f)).Within(1e-3f));

        List<float2[]> word = Lettering.Strokes("aI", 20f, false).Strokes, alone = Lettering.Strokes("a", 20f, false).Strokes;
        for (int k = 0; k < alone.Count; k++)
            Assert.That(word[k], Is.EqualTo(alone[k]));
        Assert.That(word[^1], Has.All.Matches<float2>(point => math.abs(point.x - Lettering.Width("a", 20f) - gap) < 1e-4f));
    }

    [Test]
    public void APen_IsAShareOfTheSize_AndThickerForBoldWords()
    {
        float pen = Lettering.Strokes("a", 10f, false).Pen, bold = Lettering.Strokes("a", 10f, true).Pen;

        // Half widths; a capital is 72 hundredths high.
        Assert.That((pen, bold), Is.EqualTo((0.42f, 0.62f)));
        Assert.That(Lettering.Strokes("a", 20f, false).Pen, Is.EqualTo(2f * pen).Within(1e-6f));
        Assert.That(Lettering.Strokes("a", 20f, true).Pen, Is.EqualTo(2f * bold).Within(1e-6f));
    }

    [Test]
    public void ALetterThatIsNotKnown_IsABox() => Assert.That(
        Lettering.Strokes("\u2603", k_Unit, false).Strokes.Single().Select(point => math.round(point / new float2(0.82f, 1f))),
        Is.EqualTo(new float2[] { new(0f, -7f), new(4f, -7f), new(4f, 0f), new(0f, 0f), new(0f, -7f) }));

    // A curve of the second degree over a row of corners begins and ends in the outer ones, touches the middle of each side, and turns
    // evenly.
    [TestCase('J', 3, 0, 3, 7, 0, 7, 0, 5)]
    [TestCase('o', 2, 2, 4, 2, 4, 7, 0, 7, 0, 2, 2, 2)]
    [TestCase('0', 2, 0, 4, 0, 4, 7, 0, 7, 0, 0, 2, 0)]
    public void ARoundLetter_TouchesItsSidesInTheirMiddles_AndHasNoCorner(char letter, params int[] numbers)
    {
        float2[] corners = [.. Enumerable.Range(0,
            numbers.Length / 2).Select(k => new float2(0.82f * numbers[2 * k], numbers[2 * k + 1] - 7f))];
        float2[] curve = Lettering.Strokes($"{letter}", k_Unit, false).Strokes[0];
        float2[] middles = [.. curve.Zip(curve.Skip(1), (a, b) => 0.5f * (a + b))];

        Assert.That(math.distance(curve[0], corners[0]) + math.distance(curve[^1], corners[^1]), Is.LessThan(1e-4f));
        for (int k = 1; k + 2 < corners.Length; k++)
            Assert.That(middles.Min(middle => math.distance(middle, 0.5f * (corners[k] + corners[k + 1]))), Is.LessThan(1e-4f));
        for (int k = 1; k + 1 < curve.Length; k++)
        {
            float2 before = curve[k] - curve[k - 1], after = curve[k + 1] - curve[k];
            Assert.That(math.dot(math.normalize(before), math.normalize(after)), Is.GreaterThan(math.cos(math.radians(35f))));
        }

        foreach (float2 point in curve)
            Assert.That(math.all(point >= new float2(0f, -7f) - 1e-4f) && math.all(point <= new float2(3.28f, 0f) + 1e-4f), Is.True);
    }

    // Shares of a pixel add up: a line of a thickness above one pixel takes as much of every column as it is thick, wherever it lies.
    [TestCase(0.5f, 10.5f)]
    [TestCase(0.8f, 10.2f)]
    [TestCase(2f, 10.7f)]
    public void ALine_CoversItsThickness_AndItsLengthWithRoundEnds(float pen, float y)
    {
        var size = new int2(40, 24);
        Dictionary<int, float> level = Pen.Cover(size, [new float2(10.3f, y), new float2(27.9f, y)], pen);
        Dictionary<int, float> upright = Pen.Cover(size, [new float2(y, 5.2f), new float2(y, 19.1f)], pen);

        for (int column = 13; column < 25; column++)
            Assert.That(Sum(level, size, column, null), Is.EqualTo(2f * pen).Within(1e-4f));
        for (int row = 8; row < 16; row++)
            Assert.That(Sum(upright, size, null, row), Is.EqualTo(2f * pen).Within(1e-4f));
        float through = Sum(Pen.Cover(size, [new float2(10.3f, 10.5f), new float2(27.9f, 10.5f)], pen), size, null, 10);
        Assert.That(through, Is.EqualTo(17.6f + 2f * pen).Within(1e-3f));
        Assert.That(level.Values, Is.All.InRange(0f, 1f).And.All.GreaterThan(0f));
    }

    [TestCase(10f, 10f)]
    [TestCase(10.5f, 10.25f)]
    public void APointOfAPen_IsADisc(float x, float y)
    {
        // The integral of the share at a distance, pen + 1/2 - r from 0 to 1, over the plane.
        float sum = Pen.Cover(new int2(20, 20), [new float2(x, y), new float2(x, y)], 4f).Values.Sum();

        Assert.That(sum, Is.EqualTo(math.PI * (16f + 1f / 12f)).Within(1).Percent);
    }

    [Test]
    public void APen_LeavesOutWhatIsBeyondThePicture_AndCoversAPixelOnce()
    {
        float2[] way = [new(-3f, 4.4f), new(9f, -2f), new(15f, 14f), new(4f, 3f)];
        int2 size = new(12, 9), wide = new(32, 29), shift = 10;
        Dictionary<int, float> cut = Pen.Cover(size, way, 1.2f),
            whole = Pen.Cover(wide, [.. way.Select(point => point + shift)], 1.2f);
        for (int y = 0; y < size.y; y++)
        {
            for (int x = 0; x < size.x; x++)
            {
                Assert.That(cut.GetValueOrDefault(y * size.x + x),
                    Is.EqualTo(whole.GetValueOrDefault((y + shift.y) * wide.x + x + shift.x)).Within(1e-4f), $"{x}, {y}");
            }
        }

        Assert.That(cut.Keys, Is.All.InRange(0, size.x * size.y - 1));
        Dictionary<int, float> back = Pen.Cover(size, [.. way.Reverse()], 1.2f);
        Assert.That(back.Keys, Is.EquivalentTo(cut.Keys), "whichever way the pen goes");
        Assert.That(back.Keys.Select(pixel => back[pixel] - cut[pixel]), Is.All.Zero.Within(1e-4f));
        for (int k = 0; k + 1 < way.Length; k++)
        {
            foreach ((int pixel, float covered) in Pen.Cover(size, [way[k], way[k + 1]], 1.2f))
                Assert.That(cut[pixel], Is.GreaterThanOrEqualTo(covered), "the most of any stretch");
        }
    }

    // A sixth of the width is exactly a round length.
    [TestCase(100f, "1 m", 100)]
    [TestCase(99f, "1 m", 99)]
    [TestCase(102f, "50 cm", 51)]
    [TestCase(50f, "2 m", 100)]
    [TestCase(51f, "1 m", 51)]
    [TestCase(20f, "5 m", 100)]
    [TestCase(21f, "2 m", 42)]
    [TestCase(10000f, "1 cm", 100)]
    [TestCase(10200f, "5 mm", 51)]
    [TestCase(20000f, "5 mm", 100)]
    [TestCase(0.05f, "2000 m", 100)]
    public void AScaleBar_IsABarWithTwoEnds_AndItsLengthAbove(float unitsPerMetre, string told, int bar)
    {
        var page = new PixelPage();
        var corner = new float2(24f, 176f);
        ScaleBar.Draw(page, corner, unitsPerMetre, 600f);
        float2[] line = page.Strokes[0].Points;

        Assert.That(line, Has.Length.EqualTo(4));
        Assert.That(math.distance(line[1], corner), Is.LessThan(1e-3f));
        Assert.That(math.distance(line[2], corner + new float2(bar, 0f)), Is.LessThan(0.01f));
        Assert.That((line[0].x, line[3].x), Is.EqualTo((line[1].x, line[2].x)), "ends stand up");
        Assert.That((line[0].y, line[3].y), Is.EqualTo((corner.y - 7f, corner.y - 7f)));
        Assert.That(page.Texts, Is.EqualTo(new[] { told }));
        Assert.That(page.Words[0].At.x, Is.EqualTo(corner.x));
        Assert.That(page.Words[0].At.y, Is.InRange(corner.y - 20f, corner.y - 8f), "above the bar");
    }

    private static float Sum(Dictionary<int, float> cover, int2 size, int? column, int? row) => cover
        .Where(entry => (column == null || entry.Key % size.x == column)
            && (row == null || entry.Key / size.x == row)).Sum(entry => entry.Value);
}
