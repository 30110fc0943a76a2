using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Xml.Linq;
using Alate.Benchmarks;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Cli;

/// <summary>Chart and table of the page on performance.</summary>
public sealed class PerformanceFiguresTests
{
    private static readonly string s_Folder = Path.Combine(PackageRoot.Find(), "Documentation~");

    private static string Page => File.ReadAllText(Path.Combine(s_Folder, PerformanceFigures.Page)).ReplaceLineEndings("\n");

    [Test]
    public void EachFrame_HasItsCells_AndAMarkInEachChart()
    {
        List<LivingFrame> frames =
        [
            new(LivingCrowd.Cpu, 100, 4.25, 0.5), new(LivingCrowd.Gpu, 100, 2.5, 0.25), new(LivingCrowd.Cpu, 1000, 42.5, 5.25),
            new(LivingCrowd.Gpu, 1000, 25.4, 2.5), new(LivingCrowd.Baked, 1000, 0.07, 0.04),
        ];
        List<InsectMemory> memory = [.. MemoryFigures.Crowds.SelectMany(crowd => MemoryFigures.Parts.Select(
            (part, k) => new InsectMemory(crowd, part, (crowd == LivingCrowd.Cpu ? 10_400 : 2_000) * (k + 1))))];
        (string Name, string Text)[] made = [.. PerformanceFigures.Make(Page, memory, frames)];

        Assert.That(made.Select(file => file.Name), Is.EqualTo(PerformanceFigures.Files));
        Assert.That(made[0].Text, Does.Contain("\n| 100 | 4.3 | 0.500 | 2.5 | 0.250 |  |  |  |  |  |  |\n"));
        Assert.That(made[0].Text, Does.Contain("\n| 1,000 | 43 | 5.3 | 25 | 2.5 |  |  |  |  | 0.070 | 0.040 |\n"));
        Assert.That(made[0].Text, Does.Contain($"\n| {MemoryFigures.State} | 10 | 2 |\n"));
        Assert.That(made[0].Text, Does.Contain($"\n| {MemoryFigures.All} | 73 | 14 |\n"));
        XNamespace svg = "http://www.w3.org/2000/svg";
        XElement[] marks = [.. XElement.Parse(made[1].Text).Descendants(svg + "circle")];
        Assert.That(marks.Length, Is.GreaterThanOrEqualTo(2 * frames.Count));
    }

    [Test, Explicit, Category("Long")]
    public void AMonarch_TakesNoMoreThanItMay()
    {
        List<InsectMemory> memory = BenchmarkSuite.MeasureMemory(TextWriter.Null);
        double All(LivingCrowd crowd) => memory.Single(part => part.Crowd == crowd && part.Part == MemoryFigures.All).Bytes;

        Assert.That(All(LivingCrowd.Gpu), Is.InRange(20e3, 100e3));
        Assert.That(All(LivingCrowd.Cpu), Is.InRange(100e3, 200e3));
    }

    [Test]
    public void ThePage_HasEveryCrowdThatIsMeasured_AndAPicture()
    {
        string[] rows = [.. Page.Split('\n').Where(row => row.StartsWith("| ") && row.Count(letter => letter == '|') == 12)];
        Assert.That(rows, Has.Length.GreaterThanOrEqualTo(1 + LivingFigures.Crowds.Count));
        foreach (int insects in LivingFigures.Crowds)
            Assert.That(rows.Count(row => row.StartsWith($"| {insects:#,0} |")), Is.EqualTo(1));
        Assert.That(new FileInfo(Path.Combine(s_Folder, PerformanceFigures.Files[1])).Length, Is.InRange(1_000, 100_000));
    }
}
