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
    public static void Visit(float2 a, float2 b, float2 c, Visitor visitor)
    {
        float area = Cross(b - a, c - a);
        float2 min = math.floor(math.min(a, math.min(b, c))), max = math.max(a, math.max(b, c));
        for (float y = min.y; y + 0.5f <= max.y; y++)
        {
            for (float x = min.x; x + 0.5f <= max.x; x++)
            {
                float2 point = new float2(x, y) + 0.5f;
                float3 share = new float3(Cross(c - b, point - b), Cross(a - c, point - c), Cross(b - a, point - a)) / area;
                if (math.all(share >= 0f))
                    visitor((int)x, (int)y, share);
            }
        }
    }

    private static float Cross(float2 a, float2 b) => a.x * b.y - a.y * b.x;
}
