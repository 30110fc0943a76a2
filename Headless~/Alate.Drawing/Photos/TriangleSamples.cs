namespace Alate.Drawing;

/// <summary>The cells of a grid whose middles a triangle covers.</summary>
internal static class TriangleSamples
{
    /// <summary>Called for a cell.</summary>
    /// <param name="x">Its column.</param>
    /// <param name="y">Its row.</param>
    /// <param name="share">Shares of the three corners in its middle; their sum is 1.</param>
    public delegate void Visitor(int x, int y, float3 share);

    /// <summary>Visits every cell; corners are in cells. A triangle without an area covers none.</summary>
    /// <param name="a">A corner.</param>
    /// <param name="b">The next one.</param>
    /// <param name="c">The last one.</param>
    /// <param name="visitor">Told the cells.</param>
    /// <param name="size">Columns and rows of the grid, where cells beside it are left out; null visits all.</param>
    public static void Visit(float2 a, float2 b, float2 c, Visitor visitor, int2? size = null)
    {
        float2 min = math.floor(math.min(a, math.min(b, c))), max = math.max(a, math.max(b, c));
        if (size is { } grid)
            (min, max) = (math.max(min, 0f), math.min(max, grid));
        float area = Cross(b - a, c - a);
        if (area == 0f)
            return;
        float3 slope = new float3(b.y - c.y, c.y - a.y, a.y - b.y) / area;
        for (float y = min.y; y + 0.5f <= max.y; y++)
        {
            // Of a row only the part between its edges is tried, and a cell beside it: rounding decides no cell otherwise.
            float3 first = Shares(a, b, c, new float2(min.x, y) + 0.5f), crossing = -first / slope;
            float from = math.cmax(math.select(0f, crossing, slope > 0f)) - 1f,
                to = math.cmin(math.select(float.PositiveInfinity, crossing, slope < 0f)) + 1f;
            for (float x = min.x + math.max(math.floor(from), 0f); x + 0.5f <= max.x && x <= min.x + to; x++)
            {
                float3 share = Shares(a, b, c, new float2(x, y) + 0.5f);
                if (math.all(share >= 0f))
                    visitor((int)x, (int)y, share);
            }
        }
    }

    /// <summary>Shares of the corners of a triangle at a point; some are below 0 where it lies outside.</summary>
    public static float3 Shares(float2 a, float2 b, float2 c, float2 point) =>
        new float3(Cross(c - b, point - b), Cross(a - c, point - c), Cross(b - a, point - a)) / Cross(b - a, c - a);

    private static float Cross(float2 a, float2 b) => a.x * b.y - a.y * b.x;
}
