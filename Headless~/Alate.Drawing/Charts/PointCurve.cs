namespace Alate.Drawing;

/// <summary>One curve of a <see cref="PointChart"/>.</summary>
/// <param name="Points">Values on both axes, in the order of the line.</param>
/// <param name="Colour">As SVG has it.</param>
/// <param name="Look">Line and marks.</param>
internal sealed record PointCurve(IReadOnlyList<ChartPoint> Points, string Colour, CurveLook Look);
