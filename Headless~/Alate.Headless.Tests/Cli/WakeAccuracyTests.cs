using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Xml.Linq;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Cli;

/// <summary>The chart and the table of the manual's page on wakes.</summary>
public sealed class WakeAccuracyTests
{
    private const string k_Part = "accuracy of wakes";

    // Errors that fall as the square of the fineness, at costs that rise as its square: straight falling lines of one slope.
    [Test]
    public void AChart_HasErrorOverCost_ACurveOverStepsAndOneOverPanels_AndRingsAtTheDefaults()
    {
        WakeAccuracy Wake(string title) => new(title)
        {
            OverSteps = { Point(12, 10), Point(24, 10), Point(48, 10) },
            OverPanels = { Point(24, 5), Point(24, 10), Point(24, 20) },
            DefaultErrorPct = 1.25,
        };
        List<WakeAccuracy> wakes = [Wake("one"), Wake("two")];
        using var folder = new TemporaryFolder();
        string file = folder.PathOf("wake.svg");
        File.WriteAllText(file, WakeAccuracyPicture.Draw(wakes));
        SvgBounds.AssertAllIsOnThePage(file);

        XNamespace svg = "http://www.w3.org/2000/svg";
        (double X, double Y)[] rings = [.. XDocument.Load(file).Descendants(svg + "circle")
            .Where(ring => ring.Attribute("fill").Value == "none").Select(ring => (Number(ring, "cx"), Number(ring, "cy")))];
        Assert.That(rings, Has.Length.EqualTo(1 + 2 * 2), "in the legend, and two a chart");
        Assert.That(rings[1], Is.EqualTo(rings[2]), "one default");
        Assert.That(rings[3].Y, Is.EqualTo(rings[1].Y), "side by side");
        string[][] rows = [.. WakeAccuracyPicture.Table(wakes).Select(row => row.ToArray())];
        Assert.That(rows[0][1..], Is.EqualTo(
            new[] { "12 steps", "24 steps", "48 steps", "5 panels", "10 panels", "20 panels", "default, against finer in both" }));
        Assert.That(rows[2], Is.EqualTo(new[] { "two", "4.0", "1.0", "0.3", "4.0", "1.0", "0.3", "1.3" }).Or.EqualTo(
            new[] { "two", "4.0", "1.0", "0.2", "4.0", "1.0", "0.2", "1.2" }), "a tie is rounded either way");
    }

    // ALATE_WRITE_FIGURES=1 writes chart and table again, as figures does with all pages.
    [Test]
    [Explicit]
    [Category("Long")]
    public void ThePagesErrors_AreThoseOfToday()
    {
        string folder = Path.Combine(PackageRoot.Find(), "Documentation~"), file = Path.Combine(folder, WakeFigures.Page);
        List<WakeAccuracy> wakes = WakeFigures.Measure();
        if (Environment.GetEnvironmentVariable("ALATE_WRITE_FIGURES") == "1")
        {
            foreach ((string name, string text) in WakeFigures.Make(File.ReadAllText(file).ReplaceLineEndings("\n"), wakes))
                File.WriteAllText(Path.Combine(folder, name), text);
        }

        string page = File.ReadAllText(file).ReplaceLineEndings("\n");
        int from = page.IndexOf(PageBlock.Begin(k_Part), StringComparison.Ordinal);
        string[][] told = [.. page[(from + PageBlock.Begin(k_Part).Length)..page.IndexOf(PageBlock.End(k_Part), StringComparison.Ordinal)]
            .Split('\n', StringSplitOptions.RemoveEmptyEntries).Where((_, k) => k != 1)
            .Select(row => row.Split('|')[1..^1].Select(cell => cell.Trim()).ToArray())];
        string[][] rows = [.. WakeAccuracyPicture.Table(wakes).Select(row => row.ToArray())];
        Assert.That(rows[0], Is.EqualTo(told[0]));
        Assert.That(rows.Select(row => row[0]), Is.EqualTo(told.Select(row => row[0])));
        for (int k = 1; k < rows.Length; k++)
            Assert.That(rows[k][1..].Select(Value), Is.EqualTo(told[k][1..].Select(Value)).Within(0.11), rows[k][0]);
    }

    private static WakePoint Point(int steps, int panels)
    {
        double fineness = steps / 24.0 * panels / 10;
        return new WakePoint(steps, panels, 1 / (fineness * fineness), fineness * fineness);
    }

    private static double Value(string cell) => double.Parse(cell, CultureInfo.InvariantCulture);

    private static double Number(XElement shape, string name) => Value(shape.Attribute(name).Value);
}
