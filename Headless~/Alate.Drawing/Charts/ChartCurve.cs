namespace Alate.Drawing;

/// <summary>One curve of a chart.</summary>
/// <param name="Values">[x] Its height at each place.</param>
/// <param name="Colour">Of the line, as SVG has it.</param>
/// <param name="IsDashed">Dashed, or drawn through.</param>
internal sealed record ChartCurve(IReadOnlyList<double> Values, string Colour, bool IsDashed);
