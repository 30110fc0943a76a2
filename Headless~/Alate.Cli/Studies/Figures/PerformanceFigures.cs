using Alate.Benchmarks;

namespace Alate.Cli;

/// <summary>Chart and tables of the documentation's page on performance.</summary>
internal static class PerformanceFigures
{
    /// <summary>The page, in the documentation's folder.</summary>
    public const string Page = "performance.md";

    private const string k_Picture = "images/performance.svg";

    // Fewer show nothing of how the cost grows.
    private const int k_Fewest = 100;

    private static readonly (LivingCrowd Crowd, string Name, string Colour, CurveLook Look)[] s_Crowds =
    [
        (LivingCrowd.Cpu, "live, by the processor", ChartSheet.Colours[0], CurveLook.Discs),
        (LivingCrowd.Gpu, "live, by the graphics card", ChartSheet.Colours[1], CurveLook.Discs),
        (LivingCrowd.GpuWithLevels, "the same with levels of detail", ChartSheet.Colours[1], CurveLook.Squares),
        (LivingCrowd.GpuWithBudget, $"and a budget of {LivingFigures.Budget:0} ms", ChartSheet.Ink, CurveLook.Squares),
        (LivingCrowd.Baked, "baked, on one core", ChartSheet.Ink, CurveLook.Discs),
    ];

    /// <summary>All files, in the documentation's folder.</summary>
    public static IReadOnlyList<string> Files { get; } = [Page, k_Picture];

    /// <summary>Measures, draws, and writes the page's tables again.</summary>
    /// <param name="page">The page as it is.</param>
    /// <returns>Each of <see cref="Files"/> with its text.</returns>
    public static IEnumerable<(string Name, string Text)> Make(string page) =>
        Make(page, BenchmarkSuite.MeasureMemory(TextWriter.Null),
            BenchmarkSuite.MeasureCrowds(TextWriter.Null).FindAll(frame => frame.Insects >= k_Fewest));

    internal static IEnumerable<(string Name, string Text)> Make(
        string page, IReadOnlyList<InsectMemory> memory, IReadOnlyList<LivingFrame> frames)
    {
        string counted = PageBlock.Replace(page, "memory", MarkdownTable.Write(Table(memory)));
        return [(Page, PageBlock.Replace(counted, "frames", MarkdownTable.Write(Table(frames)))), (k_Picture, Draw(frames))];
    }

    private static IEnumerable<IReadOnlyList<string>> Table(IReadOnlyList<InsectMemory> memory)
    {
        yield return ["a monarch, kB", .. MemoryFigures.Crowds.Select(crowd => Array.Find(s_Crowds, one => one.Crowd == crowd).Name)];
        foreach (string part in MemoryFigures.Parts)
        {
            yield return
            [
                part,
                .. MemoryFigures.Crowds.Select(crowd => memory.First(one => one.Crowd == crowd && one.Part == part).Bytes / 1e3)
                    .Select(bytes => bytes.ToString("0", CultureInfo.InvariantCulture)),
            ];
        }
    }

    private static IEnumerable<IReadOnlyList<string>> Table(IReadOnlyList<LivingFrame> frames)
    {
        yield return
        [
            "monarchs", .. s_Crowds.SelectMany(crowd => new[] { $"{crowd.Name}: a frame, ms", "its main thread, ms" }),
        ];
        foreach (int insects in frames.Select(frame => frame.Insects).Distinct().Order())
        {
            yield return
            [
                insects.ToString("#,0", CultureInfo.InvariantCulture),
                .. s_Crowds.SelectMany(crowd => frames.FirstOrDefault(one => one.Crowd == crowd.Crowd && one.Insects == insects)
                    is { } frame ? new[] { Number(frame.Frame), Number(frame.Main) } : ["", ""]),
            ];
        }
    }

    private static string Draw(IReadOnlyList<LivingFrame> frames)
    {
        var sheet = new ChartSheet("What a frame of monarchs costs", "Milliseconds, over the number of insects; both axes logarithmic.");
        var legend = new ChartLegend(sheet.Page, sheet.LegendTop);
        foreach ((LivingCrowd crowd, string name, string colour, CurveLook look) in s_Crowds)
        {
            legend.Add(name, colour, look);
            if (crowd == LivingCrowd.GpuWithLevels)
                legend.NextLine();
        }

        var across = ChartAxis.Logarithmic(frames.Min(frame => frame.Insects), frames.Max(frame => frame.Insects));
        var up = ChartAxis.Logarithmic(frames.Min(frame => frame.Main), frames.Max(frame => frame.Frame));
        PointChart whole = sheet.Chart(0, "a frame, jobs included", across, up), main = sheet.Chart(1, "of it the main thread", across, up);
        foreach ((LivingCrowd crowd, _, string colour, CurveLook look) in s_Crowds)
        {
            var its = frames.Where(frame => frame.Crowd == crowd).ToList();
            whole.Draw(new PointCurve(its.ConvertAll(frame => new ChartPoint(frame.Insects, frame.Frame)), colour, look));
            main.Draw(new PointCurve(its.ConvertAll(frame => new ChartPoint(frame.Insects, frame.Main)), colour, look));
        }

        return sheet.Finish(2, "Time of a frame over the number of insects");
    }

    private static string Number(double milliseconds) =>
        milliseconds.ToString(milliseconds < 1 ? "0.000" : milliseconds < 10 ? "0.0" : "0", CultureInfo.InvariantCulture);
}
