namespace Alate.Cli;

/// <summary>Table and chart of the documentation's page of results on insects that wander.</summary>
internal static class WanderFigures
{
    /// <summary>The chart, in the documentation's folder.</summary>
    public const string Picture = "images/wander.svg";

    private const string k_Part = "wandering";

    private static readonly double[] s_Erratic = [0, 0.5, 1];

    /// <summary>Measures, draws, and writes the page's table again.</summary>
    /// <param name="page">The page as it is.</param>
    /// <returns>The page, and the chart.</returns>
    public static (string Page, string Chart) Make(string page) => Make(page, Measure());

    internal static (string Page, string Chart) Make(string page, IReadOnlyList<WanderStatistics> measured) =>
        (PageBlock.Replace(page, k_Part, MarkdownTable.Write(Table(measured))), Draw(measured));

    /// <summary>Flies all insects that fly, calm, half and wholly erratic.</summary>
    public static List<WanderStatistics> Measure() =>
    [
        .. from insect in InsectCatalogue.All where insect.Name != "snailfish" && insect.Variants.Contains(InsectVariant.Flight)
        from erratic in s_Erratic select WanderStatistics.Of(insect, erratic),
    ];

    /// <summary>Rows: each species and liveliness.</summary>
    public static IEnumerable<string[]> Table(IEnumerable<WanderStatistics> measured)
    {
        yield return
        [
            "", "erratic", "speed m/s", "power over steady", "straightness over 1 s", "over 4 s", "turning rms °/s", "tumbled",
        ];
        foreach (WanderStatistics one in measured)
        {
            yield return
            [
                one.Species, Text($"{one.Erratic:0.0}"), Text($"{one.Speed:0.00}"), Text($"{one.PowerOverSteady:0.00}"),
                Text($"{one.Straightness[Array.IndexOf(WanderStatistics.Lags, 1)]:0.00}"),
                Text($"{one.Straightness[Array.IndexOf(WanderStatistics.Lags, 4)]:0.00}"), Text($"{one.Turning:0}"), Text($"{one.Tumbled}"),
            ];
        }
    }

    /// <summary>
    /// wander.svg: straightness over time and the spectrum of turning of the first species, and the power of all over their liveliness.
    /// </summary>
    public static string Draw(IReadOnlyList<WanderStatistics> measured)
    {
        WanderStatistics[] shown = [.. measured.Where(one => one.Species == measured[0].Species)];
        var sheet = new ChartSheet($"How a {measured[0].Species.ToLowerInvariant()} wanders",
            "Distance flown straight over the way flown; spectrum of the rate at which the course turns, (°/s)²/Hz; power over "
            + "steady flight.");
        var legend = new ChartLegend(sheet.Page, sheet.LegendTop);
        string[] colours = [ChartSheet.Colours[0], ChartSheet.Ink, ChartSheet.Colours[1]];
        CurveLook[] looks = [CurveLook.Discs, CurveLook.Plain, CurveLook.Squares];
        for (int k = 0; k < shown.Length; k++)
            legend.Add(Text($"erratic {shown[k].Erratic:0.0}"), colours[k % 3], looks[k % 3]);
        IGrouping<string, WanderStatistics>[] species = [.. measured.GroupBy(one => one.Species)];
        string[] names = [.. species.OrderBy(one => one.Last().PowerOverSteady).Select(one => one.Key)];
        legend.NextLine();
        legend.AddText($"On the right, from below: {string.Join(", ", names)}.");
        PointChart straight = sheet.Chart(0, "straightness over seconds",
            ChartAxis.Logarithmic(WanderStatistics.Lags[0], WanderStatistics.Lags[^1]), ChartAxis.Linear([0, 1]));
        List<double> spectra = [.. shown.SelectMany(one => one.Spectrum)];
        PointChart turning = sheet.Chart(1, "turning over hertz",
            ChartAxis.Logarithmic(WanderStatistics.Frequencies[0], WanderStatistics.Frequencies[^1]),
            ChartAxis.Logarithmic(spectra.Min(), spectra.Max()));
        for (int k = 0; k < shown.Length; k++)
        {
            straight.Draw(Curve(WanderStatistics.Lags, shown[k].Straightness, colours[k % 3], looks[k % 3]));
            turning.Draw(Curve(WanderStatistics.Frequencies, shown[k].Spectrum, colours[k % 3], CurveLook.Plain));
        }

        PointChart power = sheet.Chart(
            2, "power over erratic", ChartAxis.Linear([0, 1]), ChartAxis.Around(measured.Select(one => one.PowerOverSteady)));
        foreach (IGrouping<string, WanderStatistics> one in species)
            power.Draw(Curve(one.Select(at => at.Erratic), one.Select(at => at.PowerOverSteady), ChartSheet.Ink, CurveLook.Discs));
        return sheet.Finish(3, "Straightness, turning and power of insects that wander");
    }

    private static PointCurve Curve(IEnumerable<double> across, IEnumerable<double> up, string colour, CurveLook look) =>
        new([.. across.Zip(up, (x, y) => new ChartPoint(x, y))], colour, look);

    private static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
