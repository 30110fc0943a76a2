using System.Collections.Generic;
using System.Globalization;
using System.Text;
using Unity.Mathematics;

namespace Alate.Cli.Pictures;

/// <summary>The data of an SVG path in whole tenths of a unit and relative steps, as short as they go.</summary>
internal sealed class SvgPath
{
    /// <summary>Steps of a path in a unit of the picture.</summary>
    public const float Fineness = 10f;

    private readonly StringBuilder m_Text = new();
    private int2 m_At;

    /// <summary>Adds lines through places of the picture.</summary>
    public void Add(List<int> path, IReadOnlyList<float3> picture, bool close)
    {
        int2 start = Place(picture[path[0]]);
        m_Text.Append('m');
        Append(start - m_At, first: true);
        m_At = start;
        // A closed path ends where it began, and "z" draws that.
        int count = close ? path.Count - 1 : path.Count;
        for (int k = 1; k < count; k++)
        {
            int2 place = Place(picture[path[k]]);
            if (math.all(place == m_At))
                continue;
            Append(place - m_At, first: false);
            m_At = place;
        }

        if (close)
        {
            m_Text.Append('z');
            m_At = start;
        }
    }

    public override string ToString() => m_Text.ToString();

    private void Append(int2 step, bool first)
    {
        Append(step.x, first);
        Append(step.y, false);
    }

    // A minus sign parts two numbers as well as a space does.
    private void Append(int number, bool first)
    {
        if (!first && number >= 0)
            m_Text.Append(' ');
        m_Text.Append(number.ToString(CultureInfo.InvariantCulture));
    }

    private static int2 Place(float3 point) => (int2)math.round(Fineness * point.xy);
}
