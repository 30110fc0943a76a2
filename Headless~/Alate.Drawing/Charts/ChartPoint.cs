namespace Alate.Drawing;

/// <summary>A point of a curve.</summary>
/// <param name="X">Value on the horizontal axis.</param>
/// <param name="Y">Value on the vertical axis.</param>
internal readonly record struct ChartPoint(double X, double Y);
