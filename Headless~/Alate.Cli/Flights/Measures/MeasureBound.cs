namespace Alate.Cli;

/// <summary>Between what a number of a wing's beat lies on real insects, or may lie here.</summary>
/// <param name="Key">The number's name in files, of <see cref="WingMeasure"/> where it is one of them.</param>
/// <param name="Title">Its name in tables.</param>
/// <param name="Unit">Its unit.</param>
/// <param name="Low">Least.</param>
/// <param name="High">Most.</param>
/// <param name="IsPublished">True where the range is from a publication; else it is what is expected here.</param>
/// <param name="Source">Where the range is from.</param>
/// <param name="Of">Reads it.</param>
internal sealed record MeasureBound(
    string Key, string Title, string Unit, double Low, double High, bool IsPublished, string Source, Func<WingSummary, double> Of)
{
    /// <summary>Mark of a number that lies outside.</summary>
    public const string Mark = " †";

    /// <summary>Note below tables with ranges.</summary>
    public const string Note = "† outside the range. * expected here: no published range is known.";

    /// <summary>An edge of an expressive wing may stretch by so much, per cent.</summary>
    private const double k_ExpressiveStretch = 8;

    /// <summary>Every number for which there is a range.</summary>
    public static IReadOnlyList<MeasureBound> All { get; } =
    [
        new("twist_pp_deg", "twist p-p °", "°", 10, 50, false,
            "expected here; locusts' wings were measured as strongly twisted, Walker, Thomas and Taylor 2009", wing => wing.TwistPpDeg),
        new("camber_pct", "largest camber %", "%", 2, 15, false,
            "expected here; locusts' wings were measured as cambered by both signs, Walker, Thomas and Taylor 2009",
            wing => Math.Max(wing.CamberMaxPct, -wing.CamberMinPct)),
        new("tip_bend_max_deg", "tip bend max °", "°", 0, 46, true, "blowflies, Lehmann, Gorb, Nasir and Schützner 2011",
            wing => wing.TipBendMaxDeg),
        new("lag_deg", "lag °", "°", 10, 40, false, "expected here", wing => wing.LagDeg),
        new("edge_stretch_max_pct", "stretch max %", "%", 0, 6, false, "what a membrane is allowed here", wing => wing.EdgeStretchMaxPct),
    ];

    /// <summary>Text of the range, with a star where no publication gives it.</summary>
    public string Range => RangeOf(InsectVariant.Standard);

    /// <summary>Text of the range for a variant.</summary>
    public string RangeOf(InsectVariant variant) =>
        (Low > 0 ? Text($"{Low}–{High}") : Text($"< {Most(variant)}")) + (IsPublished ? "" : " *");

    /// <summary>The bound of a measure; null where there is none.</summary>
    public static MeasureBound Find(string key) => All.FirstOrDefault(bound => bound.Key == key);

    /// <summary>Most for a variant.</summary>
    public double Most(InsectVariant variant) =>
        Key.StartsWith("edge_stretch", StringComparison.Ordinal) && variant == InsectVariant.Expressive ? k_ExpressiveStretch : High;

    /// <summary>Returns true where the number of a wing lies in the range, as it is shown.</summary>
    public bool Holds(WingSummary wing, InsectVariant variant)
    {
        double value = Math.Round(Of(wing), 1);
        return value >= Low && value <= Most(variant);
    }

    /// <summary>The number, marked where it lies outside.</summary>
    public string Cell(WingSummary wing, InsectVariant variant) => Marked(Text($"{Math.Round(Of(wing), 1):0.0}"), wing, variant);

    /// <summary>A text of the number, marked where it lies outside.</summary>
    public string Marked(string text, WingSummary wing, InsectVariant variant) => text + (Holds(wing, variant) ? "" : Mark);

    private static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture).Replace('-', '−');
}
