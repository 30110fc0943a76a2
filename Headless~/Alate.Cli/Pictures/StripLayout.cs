using System.Collections.Generic;
using Unity.Mathematics;

namespace Alate.Cli.Pictures;

/// <summary>
/// Where the panels of the strip lie. All have one scale, and the insect keeps its place within a row; a row is as high as its poses need.
/// </summary>
internal sealed class StripLayout
{
    private const float k_PanelWidth = 300f, k_Inset = 13f, k_Header = 62f, k_Label = 32f;

    private readonly List<StripPanel> m_Panels = [];

    public StripLayout(List<Pose> poses, int columns)
    {
        (float2 min, float2 max) = Bounds(poses, 0, poses.Count);
        float scale = (k_PanelWidth - 2f * k_Inset) / math.max(max.x - min.x, 1e-9f);
        float top = k_Header;
        for (int first = 0; first < poses.Count; first += columns)
        {
            (float2 rowMin, float2 rowMax) = Bounds(poses, first, columns);
            float height = math.ceil((rowMax.y - rowMin.y) * scale + 2f * k_Inset);
            var centre = new float2(0.5f * (min.x + max.x), 0.5f * (rowMin.y + rowMax.y));
            for (int k = 0; k < columns; k++)
                m_Panels.Add(new StripPanel(k * k_PanelWidth, top, k_PanelWidth, height, scale, centre));
            top += height + k_Label;
        }

        Width = columns * k_PanelWidth;
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
            foreach (float3[] surface in poses[k].Places)
            {
                foreach (float3 place in surface)
                {
                    min = math.min(min, place.xy);
                    max = math.max(max, place.xy);
                }
            }
        }

        return (min, max);
    }
}
