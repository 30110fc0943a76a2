namespace Alate.Drawing;

/// <summary>An edge of a single triangle of a mesh.</summary>
/// <param name="Triangle">The triangle.</param>
/// <param name="A">The vertex where the edge begins.</param>
/// <param name="B">The vertex where it ends.</param>
internal readonly record struct MarginEdge(int Triangle, int A, int B);
