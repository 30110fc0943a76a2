namespace Alate.Drawing;

/// <summary>Small multiples: a column for each of several flights, a row for each of several phases, all of one scale.</summary>
internal sealed class PoseGrid
{
    private const float k_Gap = 4f;

    private readonly IReadOnlyList<PhotoScene> m_Scenes;
    private readonly List<Pose> m_Poses = [];
    private readonly StripLayout m_Layout;

    /// <param name="scenes">[column] What was flown.</param>
    /// <param name="phases">[row] Beats, 0 to 1.</param>
    /// <param name="left">Where the first panel begins.</param>
    /// <param name="top">Where the first panel begins.</param>
    /// <param name="panelWidth">Units of the picture.</param>
    public PoseGrid(IReadOnlyList<PhotoScene> scenes, IReadOnlyList<double> phases, float left, float top, float panelWidth)
    {
        m_Scenes = scenes;
        foreach (double phase in phases)
        {
            foreach (PhotoScene scene in scenes)
                m_Poses.Add(scene.PoseAt(phase));
        }

        m_Layout = new StripLayout(m_Poses, scenes.Count, left, top, panelWidth, k_Gap);
    }

    public float Right => m_Layout.Width;

    public float Bottom => m_Layout.Height;

    /// <summary>The panel of a row and a column.</summary>
    public StripPanel this[int row, int column] => m_Layout[row * m_Scenes.Count + column];

    /// <summary>Paints every pose.</summary>
    public void Draw(PixelPage page)
    {
        for (int k = 0; k < m_Poses.Count; k++)
            page.Add(m_Scenes[k % m_Scenes.Count], m_Poses[k], m_Layout[k]);
    }

    /// <summary>Writes each row's phase at its left end.</summary>
    public void LabelRows(PixelPage page, IReadOnlyList<double> phases, float right)
    {
        for (int row = 0; row < phases.Count; row++)
        {
            StripPanel panel = this[row, 0];
            page.Text(right, panel.Top + 0.5f * panel.Height + 5f, 14f, $"{360.0 * phases[row]:0}°", "end");
        }
    }
}
