namespace Alate.Cli;

/// <summary>Range of one of <see cref="WingGroups"/> on real insects.</summary>
/// <param name="Key">Name in files.</param>
/// <param name="Title">Name in tables.</param>
/// <param name="Low">Least.</param>
/// <param name="High">Most; infinite for none.</param>
/// <param name="IsPublished">True where the range is from publications; else it is what is expected here.</param>
/// <param name="Source">Where the range is from.</param>
/// <param name="Of">Reads the number.</param>
internal sealed record GroupBound(
    string Key, string Title, double Low, double High, bool IsPublished, string Source, Func<WingGroups, double> Of)
{
    /// <summary>Factor by which a stiffness may be off the measured regression.</summary>
    public const double MostStiffness = 30;

    /// <summary>Every group for which there is a range.</summary>
    public static IReadOnlyList<GroupBound> All { get; } =
    [
        new("wing_loading_n_m2", "wing loading, N/m²", 0.17, 50, false,
            "whiteflies 0.17 to 0.51, aphids to 1.4: Byrne, Buchmann and Spangler 1988; large beetles and bees are expected below 50",
            groups => groups.WingLoading),
        new("wing_mass_share_pct", "mass of the wings, % of the insect", 0.3, 20, false,
            "expected here: from bees, below 1, to butterflies with broad wings", groups => groups.WingMassShare),
        new("body_density_kg_m3", "density of the body, kg/m³", 150, 2000, false,
            "300 to 1000 as measured, Bennet-Clark and Alder 1979; ellipsoids fit a body by a factor of two", groups => groups.BodyDensity),
        new("flap_deg", "flap, end to end, °", 35, 180, true,
            "from mosquitoes, about 40, Bomphrey, Nakata, Phillips and Walker 2017, to wings that clap above and below",
            groups => groups.Flap),
        new("tip_speed_m_s", "mean speed of the tip, m/s", 0.05, 15, false,
            "expected here: from the smallest insects to bees, of which 12 mm at 150 Hz through 120° make 7.5",
            groups => groups.TipSpeed),
        new("reynolds", "Reynolds number of the tip", 5, 20000, false,
            "from thrips, 12, to hawkmoths, 6300: Liu and Aono 2009; the largest butterflies and dragonflies are expected to have more",
            groups => groups.Reynolds),
        new("reduced_frequency", "reduced frequency", 0.1, 1, false,
            "0.21 to 0.30 of thrips, flies, bees and hawkmoths: Liu and Aono 2009; broad wings are expected to have more",
            groups => groups.ReducedFrequency),
        new("strouhal", "Strouhal number", 0.2, double.PositiveInfinity, true,
            "0.2 to 0.4 in cruise, Taylor, Nudds and Thomas 2003; more in slow flight and without a bound in hover",
            groups => groups.Strouhal),
        new("ei_over_usual", "EI over that of measured wings", 1 / MostStiffness, MostStiffness, false,
            "regression over 16 species, Combes and Daniel 2003; a factor of 30 about it is expected to hold them all",
            groups => groups.StiffnessRatio),
        new("ei_over_gj", "EI over GJ", 0.05, 50, false, "expected here: veins and membranes bend and twist alike",
            groups => groups.BendOverTwist),
        new("structural_over_beat", "first frequency of the wing over the beat", 1.5, 7.7, true,
            "1/0.67 to 1/0.13 of insects that beat below 100 Hz, Ha, Truong, Phan, Goo and Park 2013; honeybees 2.6, Clark et al. 2017",
            groups => groups.StructuralRatio),
        new("hinge_pct", "hinge from the middle, % of the wing", 0.5, 40, false, "expected here: half of the thorax's width",
            groups => groups.HingeShare),
    ];

    /// <summary>Text of the range, with a star where no publication gives it.</summary>
    public string Range => (double.IsInfinity(High) ? $"> {Text(Low)}" : $"{Text(Low)}–{Text(High)}") + (IsPublished ? "" : " *");

    /// <summary>Returns true where the number of a wing lies in the range, or is none.</summary>
    public bool Holds(WingGroups groups) => Of(groups) is var value && (double.IsNaN(value) || value >= Low && value <= High);

    /// <summary>Text of the number, marked where it lies outside; empty where there is none.</summary>
    public string Cell(WingGroups groups) =>
        double.IsNaN(Of(groups)) ? "" : Text(Of(groups)) + (Holds(groups) ? "" : MeasureBound.Mark);

    // Three digits.
    private static string Text(double value)
    {
        double size = Math.Abs(value);
        string form = size is >= 1e5 or < 1e-3 and > 0 ? "0.0e-0" : size >= 100 ? "0" : size >= 10 ? "0.#" : size >= 1 ? "0.##" : "0.###";
        return value.ToString(form, CultureInfo.InvariantCulture);
    }
}
