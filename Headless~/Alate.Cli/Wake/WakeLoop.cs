namespace Alate.Cli;

/// <summary>
/// Wake of a beat as a loop: each row of rings is shed, drifts, grows as old as rows are kept, and shrinks to nothing before it is shed
/// again. So a loop is longer than a beat, and rings keep their colours.
/// </summary>
internal sealed class WakeLoop
{
    /// <summary>Most key frames of a beat: steps between them are left out, and the rows that were shed there.</summary>
    private const int k_MostKeys = 24;

    private readonly List<List<ShapedSheet>> m_Shapes;
    private readonly float m_Strongest;

    /// <param name="wake">A wake that has been shed.</param>
    public WakeLoop(WakeFlight wake)
    {
        int steps = wake.Shapes.Count, stride = Enumerable.Range(1, steps).First(
            one => steps % one == 0 && steps / one <= k_MostKeys);
        m_Shapes = [.. wake.Shapes.Where((_, step) => step % stride == 0)
            .Select(sheets => sheets.ConvertAll(sheet => sheet.Every(stride)))];
        Beats = m_Shapes.Max(sheets => sheets[0].Rows) / m_Shapes.Count + 1;
        m_Strongest = WakeColours.Strongest(m_Shapes.SelectMany(sheets => sheets));
    }

    /// <summary>Beats of the loop.</summary>
    public int Beats { get; }

    /// <summary>Steps of a beat.</summary>
    public int Steps => m_Shapes.Count;

    /// <summary>Key frames: the steps of the loop.</summary>
    public int Keys => Beats * Steps;

    /// <summary>Number of sheets.</summary>
    public int SheetCount => m_Shapes[0].Count;

    /// <summary>
    /// [vertex] Places at a key frame, metres, axes of the body: for each row of rings its older points, then its newer ones.
    /// </summary>
    public float3[] Places(int sheet, int key)
    {
        ShapedSheet shape = m_Shapes[key % Steps][sheet];
        var places = new List<float3>();
        for (int shed = 0; shed < Keys; shed++)
        {
            int age = (key - shed + Keys) % Keys;
            foreach (int row in new[] { Math.Min(age, shape.Rows - 1), Math.Clamp(age - 1, 0, shape.Rows - 1) })
                places.AddRange(shape.Points.AsSpan(row * shape.Width, shape.Width));
        }

        return [.. places];
    }

    /// <summary>[vertex] Colours, sRGB, by the circulation with which each row was shed.</summary>
    public float4[] Colours(int sheet)
    {
        var colours = new List<float4>();
        for (int shed = 0; shed < Keys; shed++)
        {
            // A step after a row was shed the ring behind it has its circulation.
            ShapedSheet shape = m_Shapes[(shed + 1) % Steps][sheet];
            for (int k = 0; k < 2 * shape.Width; k++)
                colours.Add(WakeColours.Of(shape.CirculationAt(0, k % shape.Width) / m_Strongest));
        }

        return [.. colours];
    }

    /// <summary>Three vertices a triangle.</summary>
    public int[] Triangles(int sheet)
    {
        int width = m_Shapes[0][sheet].Width;
        var triangles = new List<int>();
        for (int shed = 0; shed < Keys; shed++)
        {
            for (int k = 0; k + 1 < width; k++)
            {
                int older = 2 * shed * width + k, newer = older + width;
                triangles.AddRange([older, older + 1, newer, older + 1, newer + 1, newer]);
            }
        }

        return [.. triangles];
    }
}
