using Unity.Mathematics;

namespace Alate
{
    /// <summary>Chords of a wing along its span: what of it lies across the span at a place.</summary>
    internal sealed class SpanChords
    {
        /// <summary>Places along the span where the chord is measured.</summary>
        private const int k_Stations = 64;

        private readonly double[] m_Chords;
        private readonly float m_From, m_To;

        /// <param name="points">Vertices of the wing, wing frame.</param>
        /// <param name="triangles">The wing.</param>
        public SpanChords(float3[] points, SurfaceTriangles triangles)
        {
            m_From = float.PositiveInfinity;
            m_To = float.NegativeInfinity;
            foreach (int3 corner in triangles.corners)
            {
                var x = new float3(points[corner.x].x, points[corner.y].x, points[corner.z].x);
                m_From = math.min(m_From, math.cmin(x));
                m_To = math.max(m_To, math.cmax(x));
            }

            m_Chords = Chords(points, triangles, m_From, m_To);
        }

        /// <summary>Returns the chord at a place along the span, wing lengths.</summary>
        public double At(float x)
        {
            double place = math.clamp((x - m_From) / (m_To - m_From) * k_Stations - 0.5, 0.0, k_Stations - 1.0);
            int before = math.min((int)place, k_Stations - 2);
            return math.lerp(m_Chords[before], m_Chords[before + 1], place - before);
        }

        // Chord in the middle of each station: the strip's area over its width.
        private static double[] Chords(float3[] points, SurfaceTriangles triangles, float from, float to)
        {
            double[] chords = new double[k_Stations];
            for (int t = 0; t < triangles.Count; t++)
            {
                int3 corner = triangles.corners[t];
                float3 a = points[corner.x], b = points[corner.y], c = points[corner.z];
                double whole = 0.5 * math.length(math.cross(b - a, c - a)), side = triangles.areas[t] / whole;
                int first = Station(math.min(a.x, math.min(b.x, c.x)), from, to),
                    last = Station(math.max(a.x, math.max(b.x, c.x)), from, to);
                for (int k = first; k <= last; k++)
                    chords[k] += side * Section(a, b, c, from + (k + 0.5f) / k_Stations * (to - from));
            }

            return chords;
        }

        private static int Station(float x, float from, float to) =>
            math.clamp((int)((x - from) / (to - from) * k_Stations), 0, k_Stations - 1);

        // Length of a triangle's cut across the span.
        private static float Section(float3 a, float3 b, float3 c, float x)
        {
            float3 first = default, last = default;
            int count = 0;
            Cut(a, b, x, ref first, ref last, ref count);
            Cut(b, c, x, ref first, ref last, ref count);
            Cut(c, a, x, ref first, ref last, ref count);
            return count == 2 ? math.distance(first, last) : 0f;
        }

        private static void Cut(float3 a, float3 b, float x, ref float3 first, ref float3 last, ref int count)
        {
            if (a.x < x == b.x < x)
                return;
            float3 at = math.lerp(a, b, (x - a.x) / (b.x - a.x));
            first = count == 0 ? at : first;
            last = at;
            count++;
        }
    }
}
