using System.Collections.Generic;
using Unity.Mathematics;

namespace Alate.Cli.Pictures;

/// <summary>A triangle, or a line, on its way to the picture.</summary>
/// <param name="Shape">Its look.</param>
/// <param name="Vertices">Its corners; a line's third is -1.</param>
/// <param name="A">First corner: x, y and the depth.</param>
/// <param name="B">Second corner.</param>
/// <param name="C">Third corner; a line's second again.</param>
/// <param name="Depth">The larger is painted the sooner.</param>
internal readonly record struct PaintedPiece(PaintedShape Shape, int3 Vertices, float3 A, float3 B, float3 C, float Depth)
{
    /// <summary>Lists the points of a grid that the piece covers, each with the piece's depth there in z.</summary>
    /// <param name="fineness">Points in a unit of length.</param>
    /// <param name="covered">Emptied and filled.</param>
    public void Cover(float fineness, List<float3> covered)
    {
        covered.Clear();
        var scale = new float3(fineness, fineness, 1f);
        if (Shape.IsLine)
            CoverLine(scale * A, scale * B, covered);
        else
            CoverTriangle(scale * A, scale * B, scale * C, covered);
    }

    private static void CoverLine(float3 a, float3 b, List<float3> covered)
    {
        int points = 1 + (int)(2f * math.distance(a.xy, b.xy));
        for (int k = 0; k <= points; k++)
            covered.Add(math.lerp(a, b, (float)k / points));
    }

    private static void CoverTriangle(float3 a, float3 b, float3 c, List<float3> covered) => TriangleSamples.Visit(
        a.xy, b.xy, c.xy, (x, y, share) => covered.Add(new float3(x + 0.5f, y + 0.5f, share.x * a.z + share.y * b.z + share.z * c.z)));
}
