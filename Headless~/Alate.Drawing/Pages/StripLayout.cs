namespace Alate.Drawing;

/// <summary>
/// Places of the panels of the strip. All have one scale, and the insect keeps its place within a row; a row is as high as its poses need.
/// </summary>
internal sealed class StripLayout
{
    private const float k_PanelWidth = 300f, k_Inset = 13f, k_Header = 62f, k_Label = 32f;

    private readonly List<StripPanel> m_Panels = [];

    public StripLayout(List<Pose> poses, int columns)
        : this(poses, columns, 0f, k_Header, k_PanelWidth, k_Label)
    {
    }

    /// <param name="poses">Row by row.</param>
    /// <param name="columns">Panels of a row.</param>
    /// <param name="left">Where the first panel begins.</param>
    /// <param name="top">Where the first panel begins.</param>
    /// <param name="panelWidth">Units of the picture.</param>
    /// <param name="label">What is left below each row.</param>
    public StripLayout(List<Pose> poses, int columns, float left, float top, float panelWidth, float label)
    {
        (float2 min, float2 max) = Bounds(poses, 0, poses.Count);
        float scale = (panelWidth - 2f * k_Inset) / math.max(max.x - min.x, 1e-9f);
        for (int first = 0; first < poses.Count; first += columns)
        {
            (float2 rowMin, float2 rowMax) = Bounds(poses, first, columns);
            float height = math.ceil((rowMax.y - rowMin.y) * scale + 2f * k_Inset);
            var centre = new float2(0.5f * (min.x + max.x), 0.5f * (rowMin.y + rowMax.y));
            for (int k = 0; k < columns; k++)
                m_Panels.Add(new StripPanel(left + k * panelWidth, top, panelWidth, height, scale, centre));
            top += height + label;
        }

        Width = left + columns * panelWidth;
        Height = top;
    }

    public float Width { get; }

    public float Height { get; }

    public StripPanel this[int index] => m_Panels[index];

    private static (float2 Min, float2 Max) Bounds(List<Pose> poses, int first, int count)
    {
        float2 min = float.PositiveInfinity, max = float.NegativeInfinity;
        for (int k = first; k < first + count; k++)
        {
            (float2 low, float2 high) = poses[k].Bounds();
            (min, max) = (math.min(min, low), math.max(max, high));
        }

        return (min, max);
    }
}
