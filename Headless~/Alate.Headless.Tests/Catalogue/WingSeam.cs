using System.Collections.Generic;
using System.Linq;
using Alate.Cli;
using Alate.Geometry;
using Unity.Mathematics;

namespace Alate.Tests.Insects
{
    /// <summary>A fore and a hind wing, and the hind wing's front edge where it lies beneath the fore wing at rest.</summary>
    internal sealed class WingSeam
    {
        private readonly int[] m_ForeTriangles;
        private readonly int[] m_Edge;
        private readonly List<int3> m_Front, m_Rear;

        public WingSeam(RecordedWing fore, RecordedWing hind)
        {
            m_ForeTriangles = fore.Triangles;
            m_Front = FlownSpecies.TrianglesWithin(fore, float.PositiveInfinity);
            m_Rear = FlownSpecies.TrianglesWithin(hind, float.PositiveInfinity).ConvertAll(corners => corners + fore.Rest.Length);
            float2[] rest = hind.Rest.Select(place => hind.Placement.ToBody(place).xz).ToArray();
            float2[] cover = fore.Rest.Select(place => fore.Placement.ToBody(place).xz).ToArray();
            m_Edge = Enumerable.Range(0, rest.Length).Where(k => IsFront(hind, k) && IsCovered(rest[k], cover)).ToArray();
        }

        /// <summary>Vertices of the edge.</summary>
        public int Count => m_Edge.Length;

        /// <summary>The largest distance of the edge from the fore wing's surface, metres.</summary>
        /// <param name="fore">[vertex] The fore wing on the body.</param>
        /// <param name="hind">[vertex] The hind wing on the body.</param>
        public float WidestGap(float3[] fore, float3[] hind)
        {
            float widest = 0f;
            foreach (int vertex in m_Edge)
            {
                float nearest = float.MaxValue;
                for (int k = 0; k < m_ForeTriangles.Length; k += 3)
                {
                    nearest = math.min(nearest, TriangleDistance.Square(
                        hind[vertex], fore[m_ForeTriangles[k]], fore[m_ForeTriangles[k + 1]], fore[m_ForeTriangles[k + 2]]));
                }

                widest = math.max(widest, math.sqrt(nearest));
            }

            return widest;
        }

        /// <summary>Pairs of triangles of both wings that pass through each other.</summary>
        public int Crossings(float3[] fore, float3[] hind) => TriangleCrossing.Count(fore.Concat(hind).ToArray(), m_Front, m_Rear);

        private static bool IsFront(RecordedWing wing, int vertex)
        {
            const float k_Near = 0.02f;
            float2 place = wing.Rest[vertex].xz;
            return !wing.Rest.Any(other => math.abs(other.x - place.x) < k_Near && other.z > place.y + k_Near);
        }

        private bool IsCovered(float2 place, float2[] cover)
        {
            for (int k = 0; k < m_ForeTriangles.Length; k += 3)
            {
                float2 a = cover[m_ForeTriangles[k]], b = cover[m_ForeTriangles[k + 1]], c = cover[m_ForeTriangles[k + 2]];
                float ab = Turn(a, b, place), bc = Turn(b, c, place), ca = Turn(c, a, place);
                if ((ab >= 0f && bc >= 0f && ca >= 0f) || (ab <= 0f && bc <= 0f && ca <= 0f))
                    return true;
            }

            return false;
        }

        private static float Turn(float2 a, float2 b, float2 c) => (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    }
}
