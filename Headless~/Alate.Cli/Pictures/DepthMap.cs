using System;
using System.Collections.Generic;
using Unity.Mathematics;

namespace Alate.Cli.Pictures;

/// <summary>The nearest solid depth at the points of a grid, to leave out what nobody sees.</summary>
internal sealed class DepthMap
{
    private readonly float[] m_Nearest;
    private readonly int m_Width, m_Height;

    public DepthMap(int width, int height)
    {
        m_Width = width;
        m_Height = height;
        m_Nearest = new float[width * height];
        Array.Fill(m_Nearest, float.PositiveInfinity);
    }

    /// <summary>Adds what solid things cover, with their depths in z.</summary>
    public void Add(List<float3> covered)
    {
        foreach (float3 point in covered)
        {
            var place = (int2)math.floor(point.xy);
            if (place.x >= 0 && place.x < m_Width && place.y >= 0 && place.y < m_Height)
                m_Nearest[place.y * m_Width + place.x] = math.min(m_Nearest[place.y * m_Width + place.x], point.z);
        }
    }

    /// <summary>
    /// Returns true where something solid lies before the whole box from one corner to the other, at every point in it and right beside it.
    /// </summary>
    public bool Hides(float3 min, float3 max)
    {
        int2 from = math.max((int2)math.floor(min.xy - 0.5f), 0);
        int2 to = math.min((int2)math.floor(max.xy + 0.5f), new int2(m_Width - 1, m_Height - 1));
        for (int y = from.y; y <= to.y; y++)
        {
            for (int x = from.x; x <= to.x; x++)
            {
                if (m_Nearest[y * m_Width + x] >= min.z)
                    return false;
            }
        }

        return true;
    }
}
