namespace Alate.Cli;

/// <summary>The tables of the documentation's page of accuracy, a row for each kind of wing.</summary>
internal static class AccuracyTable
{
    private static readonly (string Key, string Title, int Digits)[] s_Values =
    [
        ("twist_pp_deg", "twist p-p °", 1), ("camber_min_pct", "least camber %", 2), ("camber_max_pct", "most camber %", 2),
        ("tip_bend_pp_deg", "tip bend p-p °", 1), ("lag_deg", "lag °", 1), ("lift_over_weight", "lift / weight at 30°", 2),
    ];

    private static readonly double[] s_Winds = [0, 3, 5, 10];

    /// <summary>Errors and costs at the defaults, beside version 0.1's.</summary>
    public static IEnumerable<IReadOnlyList<string>> Errors(IEnumerable<SpeciesConvergence> species)
    {
        yield return ["species", "wing", "substeps", "error, % of length", "version 0.1's error", "cost of a beat over 0.1's"];
        foreach ((SpeciesConvergence one, WingConvergence wing) in species.SelectMany(one => one.Wings.Select(wing => (one, wing))))
        {
            yield return
            [
                one.Plan.Species, wing.Name, Number(wing.AtDefaults.Substeps, 0), Number(wing.AtDefaults.ErrorPct, 3),
                Number(wing.Version01.ErrorPct, 3), Number(wing.AtDefaults.Cost, 2),
            ];
        }
    }

    /// <summary>Numbers at the defaults, their limits and the difference.</summary>
    public static IEnumerable<IReadOnlyList<string>> Values(IEnumerable<SpeciesConvergence> species)
    {
        yield return ["species", "wing", .. s_Values.Select(value => value.Title)];
        foreach ((SpeciesConvergence one, WingConvergence wing) in species.SelectMany(one => one.Wings.Select(wing => (one, wing))))
            yield return [one.Plan.Species, wing.Name, .. s_Values.Select(value => Cell(wing, value.Key, value.Digits))];
    }

    /// <summary>Largest stretch and 99th percentile in some winds, version 0.1's largest, and the bend of the tip in a head wind.</summary>
    public static IEnumerable<IReadOnlyList<string>> Winds(IEnumerable<SpeciesWinds> species)
    {
        yield return
        [
            "species", "wing", .. s_Winds.Select(speed => speed > 0.0 ? $"{Number(speed, 0)} m/s" : "still"), "worst from",
            "version 0.1 at 3 m/s", "tip bend in a head wind of 0, 3, 10 m/s °",
        ];
        foreach ((SpeciesWinds one, WingWinds wing) in species.SelectMany(one => one.Wings.Select(wing => (one, wing))))
        {
            yield return
            [
                one.Plan.Species, wing.Name, .. s_Winds.Select(speed => Stretch(At(wing.Now, one, speed))),
                At(wing.Now, one, 10).Worst.Name,
                Number(At(wing.Before, one, 3).StretchMaxPct, 0),
                string.Join(", ", new[] { 0.0, 3.0, 10.0 }.Select(speed => Number(At(wing.Now, one, speed).HeadBendDeg, 1))),
            ];
        }
    }

    private static string Cell(WingConvergence wing, string key, int digits)
    {
        ConvergedValue value = wing.Values.FirstOrDefault(one => one.Key == key);
        return value == null
            ? ""
            : $"{Number(value.AtDefaults, digits)} / {Number(value.Converged, digits)} "
                + $"({(value.DifferencePct < 0.0 ? "" : "+")}{Number(value.DifferencePct, 1)} %)";
    }

    private static WindPoint At(IReadOnlyList<WindPoint> points, SpeciesWinds species, double speed) =>
        points.MinBy(point => System.Math.Abs(point.Speed - speed * species.SpeedShare));

    private static string Stretch(WindPoint point) => $"{Number(point.StretchMaxPct, 1)} / {Number(point.StretchP99Pct, 1)}";

    private static string Number(double value, int digits) => value.ToString("F" + digits, CultureInfo.InvariantCulture).Replace('-', '−');
}
