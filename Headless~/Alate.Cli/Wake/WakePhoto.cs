namespace Alate.Cli;

/// <summary>Rings of a wake as photos of an insect show them.</summary>
internal sealed class WakePhoto
{
    /// <summary>Oldest wake that is shown, beats.</summary>
    public const double Beats = 1.5;

    /// <summary>Share of its density that the oldest wake has lost: it is the most tangled.</summary>
    private const float k_Faded = 0.85f;

    private readonly List<List<ShapedSheet>> m_Shapes;
    private readonly int m_First;
    private readonly float m_Reach;

    /// <param name="wake">A wake that has been shed.</param>
    public WakePhoto(WakeFlight wake)
    {
        m_Shapes = wake.Shapes.ConvertAll(
            sheets => sheets.ConvertAll(sheet => sheet.Newest((int)(Beats * wake.Plan.StepsPerBeat) + 1)));
        m_First = wake.Flight.Wings.Count + 1;
        Strongest = WakeColours.Strongest(m_Shapes.SelectMany(sheets => sheets));
        m_Reach = m_Shapes.Max(sheets => sheets.Max(sheet => sheet.Points.Max(math.length)));
    }

    /// <summary>The strongest circulation over the beat, m²/s.</summary>
    public float Strongest { get; }

    /// <summary>Adds the rings at a phase, 0 to 1 beats, to the scene of their insect.</summary>
    public PhotoScene AddTo(PhotoScene scene, double turns)
    {
        List<ShapedSheet> sheets = m_Shapes[(int)Math.Round(turns * m_Shapes.Count) % m_Shapes.Count];
        return scene.With(sheets.Select((sheet, k) => Part(sheet, m_First + k)), m_Reach);
    }

    private PhotoPart Part(ShapedSheet sheet, int index)
    {
        var colours = new float4[sheet.Points.Length];
        for (int k = 0; k < colours.Length; k++)
        {
            int row = Math.Min(k / sheet.Width, sheet.Rows - 2);
            float4 shown = WakeColours.Of(sheet.CirculationAt(row, k % sheet.Width) / Strongest);
            colours[k] = new float4(Shading.ToLinear(shown.xyz), (1f - k_Faded * row / sheet.Rows) * shown.w);
        }

        float3[] normals = Array.ConvertAll(sheet.Points, _ => new float3(0f, 1f, 0f));
        int[] triangles = Triangles(sheet.Rows, sheet.Width);
        return new PhotoPart(
            PhotoSurface.Thin(index, sheet.Points, triangles, colours, (colour, _) => colour, hasEdge: false), 1f,
            _ => (sheet.Points, normals), sheet.Points);
    }

    private static int[] Triangles(int rows, int width)
    {
        var triangles = new List<int>();
        for (int row = 0; row + 1 < rows; row++)
        {
            for (int k = 0; k + 1 < width; k++)
            {
                int at = row * width + k;
                triangles.AddRange([at, at + 1, at + width, at + 1, at + width + 1, at + width]);
            }
        }

        return [.. triangles];
    }
}
