namespace Alate.Cli;

/// <summary>Charts of a study: each measure over each parameter, and the best compromises between two measures.</summary>
internal static class StudyPictures
{
    /// <summary>Most charts of a picture, and dots of a chart.</summary>
    private const int k_MostCharts = 60, k_MostDots = 1000;

    /// <summary>Parts of a parameter's range over which a mean is taken.</summary>
    private const int k_Parts = 10;

    private const float k_Width = 620f, k_Height = 440f, k_Top = 70f;

    private const string k_Line = "#0b5fa5", k_Dot = "#a39b88", k_Front = "#c2410c";

    /// <summary>effects.svg.</summary>
    public static string DrawEffects(StudyResult result)
    {
        StudyFile file = result.Plan.File;
        int all = file.Measures.Count * file.Parameters.Count;
        var sheet = new ChartSheet($"{result.Plan.Flight.Insect.DisplayName}: what changes what",
            "A dot is a run. The line is the mean over a tenth of the range of a parameter, or at each value of a grid."
            + (all > k_MostCharts ? FormattableString.Invariant($" The first {k_MostCharts} of {all} charts.") : ""));
        int charts = 0;
        foreach (string measure in file.Measures)
        {
            double[] values = result.Values(measure);
            for (int k = 0; k < file.Parameters.Count && charts < k_MostCharts; k++)
            {
                int parameter = k;
                double[] at = result.Rows.Select(row => result.Plan.Points[row.Run][parameter]).ToArray();
                PointChart chart = sheet.Chart(
                    charts++, $"{Title(result, measure)} over {Short(file.Parameters[k].Key)}", Across(file.Parameters[k], at),
                    ChartAxis.Around(values));
                chart.Draw(new PointCurve(Thinned(at, values), k_Dot, CurveLook.Dots));
                chart.Draw(new PointCurve(Means(file, file.Parameters[k], at, values), k_Line, CurveLook.Discs));
            }
        }

        return sheet.Finish(charts, "Measures of a study over its parameters");
    }

    /// <summary>pareto.svg.</summary>
    public static string DrawFront(StudyResult result)
    {
        StudyFile file = result.Plan.File;
        double[] most = result.Values(file.Most), least = result.Values(file.Least);
        SvgPage page = Page(
            result, "the best compromises", $"{result.Front.Count} of {most.Length} runs are beaten by no other in both.");
        PointChart chart = Chart(page, $"{Title(result, file.Most)} over {Title(result, file.Least)}", least, most);
        chart.Draw(new PointCurve(Thinned(least, most), k_Dot, CurveLook.Dots));
        chart.Draw(new PointCurve(
            result.Front.Select(run => new ChartPoint(least[run], most[run])).Reverse().ToList(), k_Front, CurveLook.Discs));
        return page.Finish(k_Width, k_Top + k_Height + 12f, "The best compromises between two measures of a study");
    }

    /// <summary>search.svg.</summary>
    public static string DrawSearch(StudyResult result)
    {
        StudyGoal goal = result.Plan.File.Goal;
        double[] values = result.Values(goal.Measure), runs = Enumerable.Range(0, values.Length).Select(run => (double)run).ToArray();
        SvgPage page = Page(result, "the way of a search", $"A dot is a run. The line is the best so far"
            + (goal.Bounds.Count == 0 ? "." : ", of those that keep to their bounds where there are any."));
        PointChart chart = Chart(page, $"{Title(result, goal.Measure)} over runs", runs, values);
        chart.Draw(new PointCurve(Thinned(runs, values), k_Dot, CurveLook.Dots));
        int step = 1 + values.Length / k_MostDots;
        StudyRow[] best = result.BestSoFar();
        int measure = result.Plan.File.Measures.ToList().IndexOf(goal.Measure);
        chart.Draw(new PointCurve(
            Enumerable.Range(0, values.Length).Where(run => run % step == 0)
                .Select(run => new ChartPoint(run, best[run].Measures[measure]))
                .Where(point => double.IsFinite(point.Y)).ToList(),
            k_Front, CurveLook.Plain));
        return page.Finish(k_Width, k_Top + k_Height + 12f, "The best run so far of a search");
    }

    private static SvgPage Page(StudyResult result, string title, string caption)
    {
        var page = new SvgPage();
        page.Text(ChartSheet.Edge, 38f, 22f, $"{result.Plan.Flight.Insect.DisplayName}: {title}", look: "b");
        page.Text(ChartSheet.Edge, 60f, 13f, caption, look: "t");
        return page;
    }

    private static PointChart Chart(SvgPage page, string title, double[] across, double[] up) => new(
        page, title, ChartAxis.Around(across), ChartAxis.Around(up), 12f, k_Top, new float2(k_Width - ChartSheet.Edge, k_Height));

    private static string Title(StudyResult result, string measure) =>
        result.Plan.Flight.TitleOf(measure);

    private static string Short(string name) => name.StartsWith(StudyParameter.OfInsect, StringComparison.Ordinal)
        ? name[(name.LastIndexOf('.') + 1)..]
        : name.Replace('_', ' ');

    private static ChartAxis Across(StudyParameter parameter, double[] values) =>
        parameter.IsLogarithmic ? ChartAxis.Logarithmic(values.Min(), values.Max()) : ChartAxis.Around(values);

    private static List<ChartPoint> Thinned(double[] across, double[] up)
    {
        int step = 1 + across.Length / k_MostDots;
        return Enumerable.Range(0, across.Length).Where(k => k % step == 0 && double.IsFinite(across[k]) && double.IsFinite(up[k]))
            .Select(k => new ChartPoint(across[k], up[k])).ToList();
    }

    private static List<ChartPoint> Means(StudyFile file, StudyParameter parameter, double[] at, double[] values)
    {
        bool isGrid = file.Design == StudyDesign.Grid;
        return Enumerable.Range(0, at.Length).Where(k => double.IsFinite(values[k]))
            .GroupBy(k => isGrid ? at[k] : Part(parameter, at[k]))
            .OrderBy(part => part.Key)
            .Select(part => new ChartPoint(part.Average(k => at[k]), part.Average(k => values[k]))).ToList();
    }

    private static double Part(StudyParameter parameter, double value)
    {
        double share = parameter.IsLogarithmic
            ? Math.Log(value / parameter.From) / Math.Log(parameter.To / parameter.From)
            : (value - parameter.From) / (parameter.To - parameter.From);
        return Math.Min((int)(share * k_Parts), k_Parts - 1);
    }
}
