namespace Alate.Drawing;

/// <summary>Surface as a light sees it, blurred: how much of the light it takes away, and how near to the light it lies.</summary>
internal sealed class ShadowLayer
{
    /// <summary>Samples along a side of a cell.</summary>
    private const int k_Fineness = 2;

    /// <summary>Share of the light below which nothing is taken away.</summary>
    private const float k_None = 1e-3f;

    private readonly int2 m_Low, m_Size;

    /// <summary>[cell] Share of the light that is taken away, and that share times the height.</summary>
    private readonly float2[] m_Cells;

    /// <param name="places">[vertex] Column and row, cells.</param>
    /// <param name="heights">[vertex] How near to the light it lies, metres.</param>
    /// <param name="caster">The surface.</param>
    /// <param name="blur">Cells by which an edge is blurred, twice.</param>
    public ShadowLayer(float2[] places, float[] heights, ShadowCaster caster, int blur)
    {
        float2 least = places.Aggregate(math.min), most = places.Aggregate(math.max);
        int margin = 2 * blur + 2;
        m_Low = (int2)math.floor(least) - margin;
        m_Size = (int2)math.ceil(most) + margin - m_Low;
        m_Cells = Cells(Nearest(places, heights, caster));
        for (int pass = 0; pass < 2; pass++)
        {
            for (int row = 0; row < m_Size.y; row++)
                Blur(row * m_Size.x, 1, m_Size.x, blur);
            for (int column = 0; column < m_Size.x; column++)
                Blur(column, m_Size.x, m_Size.y, blur);
        }
    }

    /// <summary>Share of the light that is taken away from a place.</summary>
    /// <param name="place">Column and row, cells.</param>
    /// <param name="height">How near to the light it lies, metres.</param>
    /// <param name="fade">Metres below the surface at which it takes its whole share.</param>
    public float At(float2 place, float height, float fade)
    {
        float2 at = place - 0.5f - m_Low;
        var corner = (int2)math.floor(at);
        if (math.any(corner < 0) || math.any(corner >= m_Size - 1))
            return 0f;
        float2 share = at - corner;
        int cell = corner.y * m_Size.x + corner.x;
        float2 seen = math.lerp(math.lerp(m_Cells[cell], m_Cells[cell + 1], share.x),
            math.lerp(m_Cells[cell + m_Size.x], m_Cells[cell + m_Size.x + 1], share.x), share.y);
        return seen.x < k_None ? 0f : seen.x * math.saturate((seen.y / seen.x - height) / fade);
    }

    // [sample] Height of what the light meets first, and the share that it takes.
    private (float Height, float Taken)[] Nearest(float2[] places, float[] heights, ShadowCaster caster)
    {
        int width = k_Fineness * m_Size.x;
        var nearest = new (float Height, float Taken)[width * k_Fineness * m_Size.y];
        Array.Fill(nearest, (float.NegativeInfinity, 0f));
        float2[] samples = Array.ConvertAll(places, place => k_Fineness * (place - m_Low));
        for (int k = 0; k < caster.Triangles.Length; k += 3)
        {
            (int a, int b, int c) = (caster.Triangles[k], caster.Triangles[k + 1], caster.Triangles[k + 2]);
            float3 height = new(heights[a], heights[b], heights[c]), taken = new(caster.Taken[a], caster.Taken[b], caster.Taken[c]);
            TriangleSamples.Visit(samples[a], samples[b], samples[c], (x, y, share) =>
            {
                ref (float Height, float Taken) known = ref nearest[y * width + x];
                float here = math.dot(share, height);
                if (here > known.Height)
                    known = (here, math.dot(share, taken));
            });
        }

        return nearest;
    }

    private float2[] Cells((float Height, float Taken)[] nearest)
    {
        var cells = new float2[m_Size.x * m_Size.y];
        for (int k = 0; k < nearest.Length; k++)
        {
            (float height, float taken) = nearest[k];
            if (taken <= 0f)
                continue;
            int2 sample = new(k % (k_Fineness * m_Size.x), k / (k_Fineness * m_Size.x)), cell = sample / k_Fineness;
            cells[cell.y * m_Size.x + cell.x] += taken * new float2(1f, height) / (k_Fineness * k_Fineness);
        }

        return cells;
    }

    // The mean of those within a distance, along a line; the margin beyond is empty.
    private void Blur(int first, int step, int count, int blur)
    {
        var line = new float2[count];
        for (int k = 0; k < count; k++)
            line[k] = m_Cells[first + k * step];
        float2 sum = 0f;
        for (int k = 0; k < count + blur; k++)
        {
            if (k < count)
                sum += line[k];
            if (k > 2 * blur)
                sum -= line[k - 2 * blur - 1];
            if (k >= blur)
                m_Cells[first + (k - blur) * step] = sum / (2 * blur + 1);
        }
    }
}
