using System;
using System.Collections.Generic;
using Unity.Mathematics;

namespace Alate.Cli.Pictures;

/// <summary>
/// Leaves out what is hidden, orders what is seen from back to front, and gathers what has one look into layers that can be painted at once: a
/// piece joins an earlier layer of its look as long as nothing that was painted after that layer lies beneath the piece. Sheets of one glass
/// are gathered in the same way before.
/// </summary>
internal sealed class Painter
{
    private readonly List<PaintedPiece> m_Pieces = [];
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
    /// <param name="shape">Its look.</param>
    /// <param name="vertices">Its corners' numbers.</param>
    /// <param name="a">First corner.</param>
    /// <param name="b">Second corner.</param>
    /// <param name="c">Third corner.</param>
    /// <param name="above">The depth of a triangle beneath, right after which this one is painted; null paints it by its own depth.</param>
    public void AddTriangle(PaintedShape shape, int3 vertices, float3 a, float3 b, float3 c, float? above = null) =>
        m_Pieces.Add(new PaintedPiece(shape, vertices, a, b, c, above is float depth ? Nearer(depth) : (a.z + b.z + c.z) / 3f));

    /// <summary>Adds a line along the edge of a triangle, to be painted right after it.</summary>
    public void AddLine(PaintedShape shape, int2 vertices, float3 a, float3 b, float depth) =>
        m_Pieces.Add(new PaintedPiece(shape, new int3(vertices, -1), a, b, b, Nearer(depth)));

    private static float Nearer(float depth) => math.asfloat(math.asint(depth) - 1);

    /// <summary>Sheets to paint, from back to front.</summary>
    public List<PaintedSheet> Sheets()
    {
        List<PaintedPiece> seen = Seen();
        seen.Sort((one, other) => other.Depth.CompareTo(one.Depth));
        var sheets = new List<PaintedSheet>();
        foreach ((Glass glass, List<PaintedPiece> pieces) in Gather(seen, piece => piece.Shape.Glass))
        {
            var layers = new List<PaintedLayer>();
            foreach ((PaintedShape shape, List<PaintedPiece> alike) in Gather(pieces, piece => piece.Shape))
                layers.Add(new PaintedLayer(shape, alike.ConvertAll(piece => piece.Vertices)));
            sheets.Add(new PaintedSheet(glass, layers));
        }

        return sheets;
    }

    private List<PaintedPiece> Seen()
    {
        var map = new DepthMap(m_Width, m_Height);
        var covered = new List<float3>();
        foreach (PaintedPiece piece in m_Pieces)
        {
            if (piece.Shape.IsLine || !piece.Shape.Glass.IsSolid)
                continue;
            piece.Cover(m_Fineness, covered);
            map.Add(covered);
        }

        var scale = new float3(m_Fineness, m_Fineness, 1f);
        return m_Pieces.FindAll(piece => !map.Hides(
            scale * math.min(piece.A, math.min(piece.B, piece.C)), scale * math.max(piece.A, math.max(piece.B, piece.C))));
    }

    private List<(TLook Look, List<PaintedPiece> Pieces)> Gather<TLook>(List<PaintedPiece> pieces, Func<PaintedPiece, TLook> lookOf)
    {
        var layers = new List<(TLook Look, List<PaintedPiece> Pieces)>();
        var byLook = new Dictionary<TLook, List<int>>();
        int[] top = new int[m_Width * m_Height];
        Array.Fill(top, -1);
        var points = new List<float3>();
        var covered = new List<int>();
        foreach (PaintedPiece piece in pieces)
        {
            piece.Cover(m_Fineness, points);
            int beneath = -1;
            covered.Clear();
            foreach (float3 point in points)
            {
                int x = (int)math.floor(point.x), y = (int)math.floor(point.y);
                if (x < 0 || x >= m_Width || y < 0 || y >= m_Height)
                    continue;
                covered.Add(y * m_Width + x);
                beneath = math.max(beneath, top[y * m_Width + x]);
            }

            int layer = LayerOf(lookOf(piece), beneath, layers, byLook);
            layers[layer].Pieces.Add(piece);
            foreach (int point in covered)
                top[point] = layer;
        }

        return layers;
    }

    private static int LayerOf<TLook>(
        TLook look, int beneath, List<(TLook Look, List<PaintedPiece> Pieces)> layers, Dictionary<TLook, List<int>> byLook)
    {
        if (!byLook.TryGetValue(look, out List<int> candidates))
            byLook.Add(look, candidates = []);
        foreach (int candidate in candidates)
        {
            if (candidate >= beneath)
                return candidate;
        }

        layers.Add((look, []));
        candidates.Add(layers.Count - 1);
        return layers.Count - 1;
    }
}
