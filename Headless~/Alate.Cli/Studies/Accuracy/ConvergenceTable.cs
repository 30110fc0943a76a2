namespace Alate.Cli;

/// <summary>convergence.csv: one row for each kind of wing, scheme and number of substeps; and the tables of the terminal.</summary>
internal static class ConvergenceTable
{
    public static void Write(IReadOnlyList<SpeciesConvergence> species, Stream stream) => CsvTable.Write(stream, Rows(species));

    /// <summary>Error and cost of a wing, a row for each number of substeps, schemes side by side.</summary>
    public static IEnumerable<IReadOnlyList<string>> Errors(WingConvergence wing)
    {
        yield return
        [
            "substeps", .. ConvergencePlan.Schemes.SelectMany(scheme => new[] { $"{Words(scheme)}: error, %", "cost" }),
        ];
        foreach (int substeps in wing.Points.Select(point => point.Substeps).Distinct())
        {
            IEnumerable<ConvergencePoint> points = ConvergencePlan.Schemes.Select(
                scheme => wing.By(scheme).First(point => point.Substeps == substeps));
            string mark = substeps == wing.AtDefaults.Substeps ? " (default)" : "";
            yield return [substeps + mark,
                .. points.SelectMany(point => new[] { Error(point), point.Cost.ToString("0.00", CultureInfo.InvariantCulture) })];
        }

        yield return [$"version 0.1, {wing.Version01.Substeps}", "", "", Error(wing.Version01), "1.00"];
    }

    /// <summary>Numbers of a wing at the defaults and their limits.</summary>
    public static IEnumerable<IReadOnlyList<string>> Values(WingConvergence wing)
    {
        yield return ["", $"at {wing.AtDefaults.Substeps} substeps", $"at {ConvergencePlan.ReferenceSubsteps}", "difference, %"];
        foreach (ConvergedValue value in wing.Values)
        {
            yield return [value.Title, Number(value.AtDefaults), Number(value.Converged),
                value.DifferencePct.ToString("+0.0;−0.0;0.0", CultureInfo.InvariantCulture)];
        }
    }

    private static IEnumerable<IReadOnlyList<string>> Rows(IReadOnlyList<SpeciesConvergence> species)
    {
        yield return ["species", "variant", "wing", "model", "scheme", "substeps", "joint_error_pct", "cost_over_version_0_1",
            "is_default"];
        foreach (SpeciesConvergence one in species)
        {
            foreach (WingConvergence wing in one.Wings)
            {
                foreach (ConvergencePoint point in wing.Points)
                    yield return Row(one, wing, "now", point);
                yield return Row(one, wing, "0.1", wing.Version01);
            }
        }
    }

    private static string[] Row(SpeciesConvergence species, WingConvergence wing, string model, ConvergencePoint point) =>
    [
        species.Plan.Species, species.Plan.Variant.ToString().ToLowerInvariant(), wing.Name, model, Key(point.Scheme),
        point.Substeps.ToString(CultureInfo.InvariantCulture), point.ErrorPct.ToString("0.#####", CultureInfo.InvariantCulture),
        point.Cost.ToString("0.###", CultureInfo.InvariantCulture),
        point == wing.AtDefaults || point == wing.Version01 ? "yes" : "no",
    ];

    /// <summary>Name of a scheme in running text.</summary>
    public static string Words(TimeScheme scheme) => scheme == TimeScheme.SecondOrder ? "second order" : "backward Euler";

    private static string Key(TimeScheme scheme) => Words(scheme).ToLowerInvariant().Replace(' ', '-');

    private static string Error(ConvergencePoint point) => point.ErrorPct.ToString("0.000", CultureInfo.InvariantCulture);

    private static string Number(double value) => value.ToString("0.00", CultureInfo.InvariantCulture).Replace('-', '−');
}
