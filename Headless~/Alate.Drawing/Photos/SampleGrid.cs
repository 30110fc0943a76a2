using UnityEngine;

namespace Alate.Drawing;

/// <summary>
/// The light of a picture, several samples a pixel: at each the nearest solid thing, and the see-through things before it.
/// </summary>
internal sealed class SampleGrid
{
    /// <summary>Samples along a side of a pixel.</summary>
    public const int k_Fineness = 3;

    private const int k_None = -1, k_Block = 1 << 14;

    /// <summary>
    /// Of the depth: two sheets of one surface that are nearer to each other are the same, met twice at an edge of its triangles.
    /// </summary>
    private const float k_SameSheet = 1e-4f;

    private readonly float[] m_Depths;
    private readonly float3[] m_Lights;
    private readonly int[] m_Newest;

    /// <summary>[row of samples] The first and the last column at which something was added.</summary>
    private readonly int[] m_First, m_Last;

    /// <summary>Layers of glass in blocks, as millions of them would be copied where a list grows.</summary>
    private readonly List<GlassSample[]> m_Glass = [];
    private int m_GlassCount;

    /// <param name="width">Pixels.</param>
    /// <param name="height">Pixels.</param>
    public SampleGrid(int width, int height)
    {
        Width = width;
        Height = height;
        int count = width * height * k_Fineness * k_Fineness;
        m_Depths = GC.AllocateUninitializedArray<float>(count);
        m_Lights = GC.AllocateUninitializedArray<float3>(count);
        m_Newest = GC.AllocateUninitializedArray<int>(count);
        Array.Fill(m_Depths, float.PositiveInfinity);
        Array.Fill(m_Newest, k_None);
        m_First = new int[height * k_Fineness];
        m_Last = new int[height * k_Fineness];
        Array.Fill(m_First, int.MaxValue);
        Array.Fill(m_Last, k_None);
    }

    /// <summary>Memory of a grid of so many pixels, without layers of glass.</summary>
    public static long BytesOf(int2 size) => 20L * k_Fineness * k_Fineness * size.x * size.y;

    /// <summary>Pixels.</summary>
    public int Width { get; }

    /// <summary>Pixels.</summary>
    public int Height { get; }

    /// <summary>Returns true where a surface at a depth would be visible at a sample, given the solid surfaces so far.</summary>
    public bool IsSeen(int x, int y, float depth) =>
        x >= 0 && x < k_Fineness * Width && y >= 0 && y < k_Fineness * Height && depth < m_Depths[Index(x, y)];

    /// <summary>Adds what is seen at a sample.</summary>
    /// <param name="x">Column of the sample.</param>
    /// <param name="y">Row of the sample, from above.</param>
    /// <param name="depth">Distance from the viewer.</param>
    /// <param name="light">Linear light, and the opacity.</param>
    /// <param name="surface">Whose it is.</param>
    public void Add(int x, int y, float depth, float4 light, int surface)
    {
        const float k_Solid = 0.995f;
        int index = Index(x, y);
        m_First[y] = Math.Min(m_First[y], x);
        m_Last[y] = Math.Max(m_Last[y], x);
        if (light.w >= k_Solid)
        {
            m_Depths[index] = depth;
            m_Lights[index] = light.xyz;
            return;
        }

        for (int k = m_Newest[index]; k != k_None; k = Glass(k).Next)
        {
            ref GlassSample known = ref Glass(k);
            if (known.Surface == surface && math.abs(known.Depth - depth) < k_SameSheet * depth)
                return;
        }

        if (m_GlassCount == m_Glass.Count * k_Block)
            m_Glass.Add(new GlassSample[k_Block]);
        Glass(m_GlassCount) = new GlassSample(depth, light, surface, m_Newest[index]);
        m_Newest[index] = m_GlassCount++;
    }

    /// <summary>Adds a solid disc.</summary>
    /// <param name="middle">Column and row, samples.</param>
    /// <param name="radius">Samples.</param>
    /// <param name="depth">Distance from the viewer.</param>
    /// <param name="light">Linear light.</param>
    public void AddDisc(float2 middle, float radius, float depth, float3 light)
    {
        int2 low = (int2)math.floor(middle - radius), high = (int2)math.ceil(middle + radius);
        for (int y = low.y; y <= high.y; y++)
        {
            for (int x = low.x; x <= high.x; x++)
            {
                if (math.distance(new float2(x, y) + 0.5f, middle) <= radius && IsSeen(x, y, depth))
                    Add(x, y, depth, new float4(light, 1f), k_None);
            }
        }
    }

    /// <summary>
    /// The pixels, row by row from above: samples weigh the less the farther they lie from the middle of a pixel, up to its neighbours'
    /// middles, so that thin lines at any slope look equally wide. Encoded values are averaged, not light: a dark line between two rows of
    /// pixels is then as dark as one on a row.
    /// </summary>
    /// <param name="paper">What is behind all, linear light.</param>
    public Color32[] Pixels(float3 paper)
    {
        var pixels = new Color32[Width * Height];
        Array.Fill(pixels, Shading.Bytes(Shading.ToEncoded(paper)));
        var seen = new EncodedRows(this, paper);
        for (int y = 0; y < Height; y++)
        {
            (int first, int last) = PixelsAround(y);
            for (int x = first; x <= last; x++)
            {
                if (!IsPaperAround(x, y))
                    pixels[y * Width + x] = Shading.Bytes(Mean(seen, new int2(x, y) * k_Fineness + k_Fineness / 2));
            }
        }

        return pixels;
    }

    /// <summary>
    /// The pixels with nothing behind them, row by row from above: colours, and opacities by which they lie over any ground. On black and
    /// on white they look as if they were painted there.
    /// </summary>
    public Color32[] Cutout()
    {
        Color32[] dark = Pixels(0f), light = Pixels(1f), pixels = new Color32[dark.Length];
        for (int k = 0; k < pixels.Length; k++)
        {
            float3 least = new(dark[k].r, dark[k].g, dark[k].b), most = new(light[k].r, light[k].g, light[k].b);
            float opacity = math.saturate(1f - math.csum(most - least) / (3f * 255f));
            Color32 shown = Shading.Bytes(math.saturate(least / math.max(255f * opacity, 1f)));
            pixels[k] = new Color32(shown.r, shown.g, shown.b, (byte)math.round(255f * opacity));
        }

        return pixels;
    }

    // Those of a row whose samples or neighbouring samples hold more than paper.
    private (int First, int Last) PixelsAround(int y)
    {
        int first = int.MaxValue, last = k_None;
        for (int row = math.max(k_Fineness * y - 1, 0); row <= math.min(k_Fineness * (y + 1), k_Fineness * Height - 1); row++)
        {
            first = Math.Min(first, m_First[row]);
            last = Math.Max(last, m_Last[row]);
        }

        return last == k_None ? (0, k_None) : (math.max(first - 1, 0) / k_Fineness, math.min((last + 1) / k_Fineness, Width - 1));
    }

    private float3 Mean(EncodedRows seen, int2 middle)
    {
        float3 sum = 0f;
        for (int y = 1 - k_Fineness; y < k_Fineness; y++)
        {
            int row = math.clamp(middle.y + y, 0, k_Fineness * Height - 1);
            float3[] shown = seen.Row(row);
            float3 across = 0f;
            for (int x = 1 - k_Fineness; x < k_Fineness; x++)
                across += (k_Fineness - math.abs(x)) * shown[math.clamp(middle.x + x, 0, k_Fineness * Width - 1)];
            sum += (k_Fineness - math.abs(y)) * across;
        }

        return sum / (k_Fineness * k_Fineness * k_Fineness * k_Fineness);
    }

    private bool IsPaper(int index) => m_Newest[index] == k_None && float.IsPositiveInfinity(m_Depths[index]);

    // Nothing but paper in what a pixel takes its colour from.
    private bool IsPaperAround(int x, int y)
    {
        int left = math.max(k_Fineness * x - 1, 0), right = math.min(k_Fineness * (x + 1), k_Fineness * Width - 1),
            bottom = math.min(k_Fineness * (y + 1), k_Fineness * Height - 1);
        for (int row = math.max(k_Fineness * y - 1, 0); row <= bottom; row++)
        {
            for (int index = Index(left, row); index <= Index(right, row); index++)
            {
                if (!IsPaper(index))
                    return false;
            }
        }

        return true;
    }

    private float3 Seen(int index, float3 paper, List<GlassSample> sheets)
    {
        float3 light = math.select(m_Lights[index], paper, float.IsPositiveInfinity(m_Depths[index]));
        if (m_Newest[index] == k_None)
            return light;
        sheets.Clear();
        for (int k = m_Newest[index]; k != k_None; k = Glass(k).Next)
        {
            if (Glass(k).Depth < m_Depths[index])
                Insert(sheets, Glass(k));
        }

        foreach (GlassSample sheet in sheets)
            light = math.lerp(light, sheet.Light.xyz, sheet.Light.w);
        return light;
    }

    // From the farthest to the nearest; there are few.
    private static void Insert(List<GlassSample> sheets, GlassSample added)
    {
        int place = sheets.Count;
        sheets.Add(added);
        for (; place > 0 && sheets[place - 1].Depth < added.Depth; place--)
            sheets[place] = sheets[place - 1];
        sheets[place] = added;
    }

    private ref GlassSample Glass(int sample) => ref m_Glass[sample / k_Block][sample % k_Block];

    private int Index(int x, int y) => y * k_Fineness * Width + x;

    /// <summary>Samples as they are shown, a row at a time: a picture is large, and needs few rows at once.</summary>
    private sealed class EncodedRows
    {
        /// <summary>Rows that are kept: a power of two, at least the rows that a pixel needs.</summary>
        private const int k_Kept = 8;

        private readonly SampleGrid m_Grid;
        private readonly float3 m_Paper, m_Ground;
        private readonly float3[][] m_Rows = new float3[k_Kept][];
        private readonly int[] m_Held = new int[k_Kept];
        private readonly List<GlassSample> m_Sheets = [];

        public EncodedRows(SampleGrid grid, float3 paper)
        {
            m_Grid = grid;
            m_Paper = paper;
            m_Ground = Shading.ToEncoded(paper);
            Array.Fill(m_Held, k_None);
        }

        public float3[] Row(int row)
        {
            int place = row & (k_Kept - 1);
            float3[] shown = m_Rows[place] ??= new float3[k_Fineness * m_Grid.Width];
            if (m_Held[place] == row)
                return shown;
            m_Held[place] = row;
            for (int x = 0; x < shown.Length; x++)
            {
                int sample = m_Grid.Index(x, row);
                shown[x] = m_Grid.IsPaper(sample) ? m_Ground : Shading.ToEncoded(m_Grid.Seen(sample, m_Paper, m_Sheets));
            }

            return shown;
        }
    }

    /// <summary>Layer seen through at a sample.</summary>
    /// <param name="Depth">Distance from the viewer.</param>
    /// <param name="Light">Linear light, and the opacity.</param>
    /// <param name="Surface">Whose it is.</param>
    /// <param name="Next">The one that was added before, at the same sample.</param>
    private readonly record struct GlassSample(float Depth, float4 Light, int Surface, int Next);
}
