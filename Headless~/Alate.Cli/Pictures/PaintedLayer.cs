using System.Collections.Generic;
using Unity.Mathematics;

namespace Alate.Cli.Pictures;

/// <summary>Pieces of one look.</summary>
/// <param name="Shape">The look.</param>
/// <param name="Vertices">Corners of triangles, or ends of lines and −1.</param>
internal sealed record PaintedLayer(PaintedShape Shape, List<int3> Vertices);
