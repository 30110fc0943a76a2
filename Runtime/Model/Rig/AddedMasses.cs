using System;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Masses of the air that the joints carry along across the surface, over ρ: π/4 · c · A of the triangles around them. Over a strip of
    /// the wing they add up to the π/4 c² per span of a thin plate.
    /// </summary>
    internal static class AddedMasses
    {
        /// <summary>Places along the span where the chord is measured.</summary>
        private const int k_Stations = 64;

        /// <summary>Masses of the joints over the density of the air, L³.</summary>
        /// <param name="rest">The skeleton.</param>
        /// <param name="points">Vertices of the wing, wing frame.</param>
        /// <param name="triangles">The wing.</param>
        /// <param name="weights">[vertex] Cells of the vertices.</param>
        public static float[] OfJoints(RestSkeleton rest, float3[] points, SurfaceTriangles triangles, CellPoint[] weights)
        {
            float from = float.PositiveInfinity, to = float.NegativeInfinity;
            foreach (int3 corner in triangles.corners)
            {
                var x = new float3(points[corner.x].x, points[corner.y].x, points[corner.z].x);
                from = math.min(from, math.cmin(x));
                to = math.max(to, math.cmax(x));
            }

            double[] chords = Chords(points, triangles, from, to), shares = new double[triangles.Count];
            for (int t = 0; t < shares.Length; t++)
                shares[t] = 0.25 * Math.PI * triangles.areas[t] * At(chords, (triangles.centres[t].x - from) / (to - from)) / 3.0;
            return Array.ConvertAll(JointMasses.Sums(rest, triangles, weights, shares), mass => (float)mass);
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

        private static double At(double[] chords, double share)
        {
            double place = math.clamp(share * k_Stations - 0.5, 0.0, k_Stations - 1.0);
            int before = math.min((int)place, k_Stations - 2);
            return math.lerp(chords[before], chords[before + 1], place - before);
        }
    }
}
