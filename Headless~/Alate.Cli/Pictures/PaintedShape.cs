namespace Alate.Cli.Pictures;

/// <summary>Triangles or lines of one colour that are painted in one go.</summary>
/// <param name="Colour">Six hexadecimal digits in an integer.</param>
/// <param name="IsLine">A line along a margin; else triangles.</param>
/// <param name="IsTurned">Triangles seen from behind, whose edges run the other way on the picture.</param>
/// <param name="Glass">How far they are seen through; solid by default.</param>
internal readonly record struct PaintedShape(int Colour, bool IsLine, bool IsTurned, Glass Glass = default);
