using System;
using System.Collections.Generic;
using Unity.Mathematics;

namespace Alate.Cli.Pictures;

/// <summary>
/// Orders what is seen from back to front, and gathers what has one look into layers that can be painted at once: a piece joins an earlier
/// layer of its look
/// as long as nothing that was painted after that layer lies beneath the piece.
/// </summary>
internal sealed class Painter
{
    private readonly List<Piece> m_Pieces = [];
    private readonly int m_Width, m_Height;
    private readonly float m_Fineness;

    /// <param name="width">Of the picture.</param>
    /// <param name="height">Of the picture.</param>
    /// <param name="fineness">Points in a unit of length at which pieces are tested for lying over one another.</param>
    public Painter(float width, float height, float fineness)
    {
        m_Fineness = fineness;
        m_Width = (int)math.ceil(width * fineness);
        m_Height = (int)math.ceil(height * fineness);
    }

    /// <summary>Adds a triangle; corners are x, y on the picture and the depth.</summary>
    public void AddTriangle(PaintedShape shape, int3 vertices, float3 a, float3 b, float3 c) =>
        m_Pieces.Add(new Piece(shape, vertices, a, b, c, (a.z + b.z + c.z) / 3f));

    /// <summary>Adds a line along the edge of a triangle, to be painted right after it.</summary>
    public void AddLine(PaintedShape shape, int2 vertices, float3 a, float3 b, float depth) =>
        m_Pieces.Add(new Piece(shape, new int3(vertices, -1), a, b, b, math.asfloat(math.asint(depth) - 1)));

    /// <summary>The layers from back to front.</summary>
    public List<PaintedLayer> Layers()
    {
        m_Pieces.Sort((one, other) => other.Depth.CompareTo(one.Depth));
        var layers = new List<PaintedLayer>();
        var byShape = new Dictionary<PaintedShape, List<int>>();
        var top = new int[m_Width * m_Height];
        Array.Fill(top, -1);
        var covered = new List<int>();
        foreach (Piece piece in m_Pieces)
        {
            Cover(piece, covered);
            int beneath = -1;
            foreach (int point in covered)
                beneath = math.max(beneath, top[point]);
            int layer = Layer(piece.Shape, beneath, layers, byShape);
            layers[layer].Vertices.Add(piece.Vertices);
            foreach (int point in covered)
                top[point] = layer;
        }

        return layers;
    }

    private static int Layer(PaintedShape shape, int beneath, List<PaintedLayer> layers, Dictionary<PaintedShape, List<int>> byShape)
    {
        if (!byShape.TryGetValue(shape, out List<int> candidates))
            byShape.Add(shape, candidates = []);
        foreach (int candidate in candidates)
        {
            if (candidate >= beneath)
                return candidate;
        }

        layers.Add(new PaintedLayer(shape, []));
        candidates.Add(layers.Count - 1);
        return layers.Count - 1;
    }

    private void Cover(in Piece piece, List<int> covered)
    {
        covered.Clear();
        if (piece.Shape.IsLine)
            CoverLine(piece, covered);
        else
            CoverTriangle(piece, covered);
    }

    private void CoverLine(in Piece piece, List<int> covered)
    {
        int points = 1 + (int)(2f * m_Fineness * math.distance(piece.A.xy, piece.B.xy));
        for (int k = 0; k <= points; k++)
            Add(math.lerp(piece.A.xy, piece.B.xy, (float)k / points) * m_Fineness, covered);
    }

    private void CoverTriangle(in Piece piece, List<int> covered)
    {
        float2 a = piece.A.xy * m_Fineness, b = piece.B.xy * m_Fineness, c = piece.C.xy * m_Fineness;
        float area = Cross(b - a, c - a);
        float2 min = math.min(a, math.min(b, c)), max = math.max(a, math.max(b, c));
        for (float y = math.floor(min.y) + 0.5f; y <= max.y; y++)
        {
            for (float x = math.floor(min.x) + 0.5f; x <= max.x; x++)
            {
                var point = new float2(x, y);
                if (Cross(b - a, point - a) * area >= 0f && Cross(c - b, point - b) * area >= 0f && Cross(a - c, point - c) * area >= 0f)
                    Add(point, covered);
            }
        }
    }

    private void Add(float2 point, List<int> covered)
    {
        var place = (int2)math.floor(point);
        if (place.x >= 0 && place.x < m_Width && place.y >= 0 && place.y < m_Height)
            covered.Add(place.y * m_Width + place.x);
    }

    private static float Cross(float2 a, float2 b) => a.x * b.y - a.y * b.x;

    private readonly record struct Piece(PaintedShape Shape, int3 Vertices, float3 A, float3 B, float3 C, float Depth);
}
