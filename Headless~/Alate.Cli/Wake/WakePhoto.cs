namespace Alate.Cli;

/// <summary>Rings of a wake as photos of an insect show them.</summary>
internal sealed class WakePhoto
{
    /// <summary>Share of its density that the oldest wake has lost: it is the most tangled.</summary>
    private const float k_Faded = 0.85f;

    private readonly List<List<ShapedSheet>> m_Shapes;
    private readonly int m_First;
    private readonly float m_Reach;

    /// <param name="wake">A wake that has been shed.</param>
    /// <param name="beats">Oldest wake that is shown.</param>
    public WakePhoto(WakeFlight wake, double beats)
    {
        m_Shapes = wake.Shapes.ConvertAll(
            sheets => sheets.ConvertAll(sheet => sheet.Newest((int)(beats * wake.Plan.StepsPerBeat) + 1)));
        m_First = wake.Flight.Wings.Count + 1;
        Strongest = WakeColours.Strongest(m_Shapes.SelectMany(sheets => sheets));
        m_Reach = m_Shapes.Max(sheets => sheets.Max(sheet => sheet.Points.Max(math.length)));
    }

    /// <summary>Steps of the beat.</summary>
    public int Steps => m_Shapes.Count;

    /// <summary>The strongest circulation over the beat, m²/s.</summary>
    public float Strongest { get; }

    /// <summary>Adds the rings at a step of the beat to the scene of their insect.</summary>
    public PhotoScene AddTo(PhotoScene scene, int step) =>
        scene.With(m_Shapes[step].Select((sheet, k) => Part(sheet, m_First + k)), m_Reach);

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
