using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Alate.Catalogue;

namespace Alate.Cli.Flights;

/// <summary>Between what a number of a wing's beat lies on real insects, or may lie here.</summary>
/// <param name="Key">The number's name in files, of <see cref="WingMeasure"/> where it is one of them.</param>
/// <param name="Title">Its name in tables.</param>
/// <param name="Unit">Its unit.</param>
/// <param name="Low">Least.</param>
/// <param name="High">Most.</param>
/// <param name="Source">Where the range is from.</param>
/// <param name="Of">Reads it.</param>
internal sealed record MeasureBound(string Key, string Title, string Unit, double Low, double High, string Source, Func<WingSummary, double> Of)
{
    /// <summary>Mark of a number that lies outside.</summary>
    public const string Mark = " †";

    /// <summary>An edge of an expressive wing may stretch by so much, per cent.</summary>
    private const double k_ExpressiveStretch = 8;

    /// <summary>Every number for which there is a range.</summary>
    public static IReadOnlyList<MeasureBound> All { get; } =
    [
        new("twist_pp_deg", "twist p-p °", "°", 10, 50, "around what was measured on locusts, Walker, Thomas and Taylor 2009", wing => wing.TwistPpDeg),
        new("camber_pct", "largest camber %", "%", 2, 15, "around what was measured on locusts, Walker, Thomas and Taylor 2009", wing => Math.Max(wing.CamberMaxPct, -wing.CamberMinPct)),
        new("tip_bend_max_deg", "tip bend max °", "°", 0, 46, "blowflies, Lehmann, Gorb, Nasir and Schützner 2011", wing => wing.TipBendMaxDeg),
        new("lag_deg", "lag °", "°", 10, 40, "butterflies", wing => wing.LagDeg),
        new("edge_stretch_max_pct", "stretch max %", "%", 0, 6, "not measured on insects: what a membrane is allowed here", wing => wing.EdgeStretchMaxPct),
    ];

    /// <summary>Text of the range.</summary>
    public string Range => Low > 0 ? Text($"{Low}–{High}") : Text($"< {High}");

    /// <summary>The bound of a measure; null where there is none.</summary>
    public static MeasureBound Find(string key) => All.FirstOrDefault(bound => bound.Key == key);

    /// <summary>Most for a variant.</summary>
    public double Most(InsectVariant variant) => Key.StartsWith("edge_stretch", StringComparison.Ordinal) && variant == InsectVariant.Expressive ? k_ExpressiveStretch : High;

    /// <summary>Returns true where the number of a wing lies in the range, as it is shown.</summary>
    public bool Holds(WingSummary wing, InsectVariant variant)
    {
        double value = Math.Round(Of(wing), 1);
        return value >= Low && value <= Most(variant);
    }

    /// <summary>The number, marked where it lies outside.</summary>
    public string Cell(WingSummary wing, InsectVariant variant) => Text($"{Math.Round(Of(wing), 1):0.0}") + (Holds(wing, variant) ? "" : Mark);

    private static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture).Replace('-', '−');
}
