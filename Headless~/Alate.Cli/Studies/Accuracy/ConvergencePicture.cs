namespace Alate.Cli;

/// <summary>convergence.svg: error over cost, a chart for each species, both schemes.</summary>
internal static class ConvergencePicture
{
    private static readonly (TimeScheme Scheme, CurveLook Look)[] s_Looks =
        [(TimeScheme.BackwardEuler, CurveLook.Squares), (TimeScheme.SecondOrder, CurveLook.Discs)];

    /// <summary>The whole picture.</summary>
    public static string Draw(IReadOnlyList<SpeciesConvergence> species)
    {
        var sheet = new ChartSheet(
            KnownSpecies.Titled("How far wings are off, and what they cost", species[0].Plan.Variant),
            $"Distance of the joints from {ConvergencePlan.ReferenceSubsteps} substeps of the same scheme, RMS, % of the wing's length, "
            + "over the time of a beat, version 0.1 = 1.");
        var legend = new ChartLegend(sheet.Page, sheet.LegendTop);
        legend.Add("second order (default)", ChartSheet.Ink, CurveLook.Discs);
        legend.Add("backward Euler", ChartSheet.Ink, CurveLook.Squares);
        legend.AddRing("default substeps", ChartSheet.Ink);
        legend.AddCross("version 0.1", ChartSheet.Ink);
        legend.NextLine();
        legend.AddWings(species.SelectMany(one => one.Wings.Select((wing, kind) => (one.Wings.Count, kind))));
        legend.AddText($"Points from left to right: {string.Join(", ", ConvergencePlan.Substeps)} substeps; more where the air is fast.");
        var all = species.SelectMany(one => one.Wings).SelectMany(wing => wing.Points.Append(wing.Version01)).ToList();
        // A wing that is not off at all has no place on a logarithmic axis.
        const double k_Least = 1e-4;
        var across = ChartAxis.Logarithmic(all.Min(point => point.Cost), all.Max(point => point.Cost));
        var up = ChartAxis.Logarithmic(Math.Max(all.Min(point => point.ErrorPct), k_Least), all.Max(point => point.ErrorPct));
        for (int k = 0; k < species.Count; k++)
        {
            PointChart chart = sheet.Chart(k, species[k].DisplayName, across, up);
            for (int kind = 0; kind < species[k].Wings.Count; kind++)
                Draw(chart, species[k].Wings[kind], ChartSheet.Colours[kind % ChartSheet.Colours.Count]);
        }

        return sheet.Finish(species.Count, "Error of the joints over the cost of a beat");
    }

    private static void Draw(PointChart chart, WingConvergence wing, string colour)
    {
        foreach ((TimeScheme scheme, CurveLook look) in s_Looks)
            chart.Draw(new PointCurve(wing.By(scheme).ConvertAll(Place), colour, look));
        chart.Ring(Place(wing.AtDefaults), colour);
        chart.Cross(Place(wing.Version01), colour);
    }

    private static ChartPoint Place(ConvergencePoint point) => new(point.Cost, point.ErrorPct);
}
