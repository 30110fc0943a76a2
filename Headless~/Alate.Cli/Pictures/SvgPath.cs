using System.Collections.Generic;
using System.Globalization;
using System.Text;
using Unity.Mathematics;

namespace Alate.Cli.Pictures;

/// <summary>The data of an SVG path in whole parts of a unit and relative steps, as short as they go.</summary>
/// <param name="fineness">Steps of a path in a unit of the picture.</param>
/// <param name="slack">How far, in steps, a point may lie from the path that leaves it out; 0 leaves out none but those on straight lines.</param>
internal sealed class SvgPath(float fineness, float slack = 0f)
{
    private readonly StringBuilder m_Text = new();
    private readonly List<int2> m_Points = [];
    private int2 m_At;

    /// <summary>True where nothing is left of the added points, because they span less than a step.</summary>
    public bool IsEmpty => m_Text.Length == 0;

    /// <summary>Adds lines through places of the picture.</summary>
    public void Add(List<int> path, IReadOnlyList<float3> picture, bool close)
    {
        m_Points.Clear();
        // A closed path ends where it began, and "z" draws that.
        for (int k = 0; k < (close ? path.Count - 1 : path.Count); k++)
            AddPoint((int2)math.round(fineness * picture[path[k]].xy));
        if (slack > 0f)
            PathThinning.Thin(m_Points, close, slack);
        if (m_Points.Count < (close ? 3 : 2))
            return;
        m_Text.Append('m');
        for (int k = 0; k < m_Points.Count; k++)
        {
            Append(m_Points[k].x - m_At.x, first: k == 0);
            Append(m_Points[k].y - m_At.y, first: false);
            m_At = m_Points[k];
        }

        if (close)
        {
            m_Text.Append('z');
            m_At = m_Points[0];
        }
    }

    public override string ToString() => m_Text.ToString();

    // A point between two others on a straight line is left out.
    private void AddPoint(int2 point)
    {
        int count = m_Points.Count;
        if (count > 0 && math.all(m_Points[count - 1] == point))
            return;
        if (count > 1 && IsStraight(m_Points[count - 2], m_Points[count - 1], point))
            m_Points[count - 1] = point;
        else
            m_Points.Add(point);
    }

    private static bool IsStraight(int2 a, int2 b, int2 c)
    {
        int2 before = b - a, after = c - b;
        return before.x * after.y == before.y * after.x && before.x * after.x + before.y * after.y > 0;
    }

    // A minus sign parts two numbers as well as a space does.
    private void Append(int number, bool first)
    {
        if (!first && number >= 0)
            m_Text.Append(' ');
        m_Text.Append(number.ToString(CultureInfo.InvariantCulture));
    }
}
