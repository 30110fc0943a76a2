using System;

namespace Alate
{
    /// <summary>
    /// Masses of the air that the joints carry along across the surface, over ρ: π/4 · c · A of the triangles around them. Over a strip of
    /// the wing they add up to the π/4 c² per span of a thin plate.
    /// </summary>
    internal static class AddedMasses
    {
        /// <summary>Masses of the joints over the density of the air, L³.</summary>
        /// <param name="rest">The skeleton.</param>
        /// <param name="chords">Chords of the wing.</param>
        /// <param name="triangles">The wing.</param>
        /// <param name="weights">[vertex] Cells of the vertices.</param>
        public static float[] OfJoints(RestSkeleton rest, SpanChords chords, SurfaceTriangles triangles, CellPoint[] weights)
        {
            double[] shares = new double[triangles.Count];
            for (int t = 0; t < shares.Length; t++)
                shares[t] = 0.25 * Math.PI * triangles.areas[t] * chords.At(triangles.centres[t].x) / 3.0;
            return Array.ConvertAll(JointMasses.Sums(rest, triangles, weights, shares), mass => (float)mass);
        }
    }
}
