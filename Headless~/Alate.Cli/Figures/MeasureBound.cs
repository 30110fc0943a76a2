using System;
using System.Collections.Generic;
using System.Globalization;
using Alate.Catalogue;
using Alate.Cli.Flights;

namespace Alate.Cli.Figures;

/// <summary>A number of the documentation's table, and between what it lies on real insects or may lie here.</summary>
/// <param name="Title">The column's head.</param>
/// <param name="Low">Least.</param>
/// <param name="High">Most.</param>
/// <param name="Of">Reads it.</param>
internal sealed record MeasureBound(string Title, double Low, double High, Func<WingSummary, double> Of)
{
    /// <summary>
    /// Twist 10 to 50°, camber 2 to 15 %, tip bend below 46° (blowflies, Lehmann et al. 2011) and lag 10 to 40° are what was measured on real insects; edges may stretch by 6 %.
    /// </summary>
    public static IReadOnlyList<MeasureBound> All { get; } =
    [
        new("twist p-p °", 10, 50, wing => wing.TwistPpDeg),
        new("largest camber %", 2, 15, wing => Math.Max(wing.CamberMaxPct, -wing.CamberMinPct)),
        new("tip bend max °", 0, 46, wing => wing.TipBendMaxDeg),
        new("lag °", 10, 40, wing => wing.LagDeg),
        new("stretch max %", 0, 6, wing => wing.EdgeStretchMaxPct),
    ];

    /// <summary>Text of the bound in the head of the table.</summary>
    public string Range => Low > 0 ? Text($"{Low}–{High}") : Text($"< {High}");

    /// <summary>The number, marked where it lies outside.</summary>
    public string Cell(WingSummary wing, InsectVariant variant)
    {
        double value = Math.Round(Of(wing), 1), high = Title.StartsWith("stretch", StringComparison.Ordinal) && variant == InsectVariant.Expressive ? 8 : High;
        return Text($"{value:0.0}") + (value >= Low && value <= high ? "" : " †");
    }

    private static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture).Replace('-', '−');
}
