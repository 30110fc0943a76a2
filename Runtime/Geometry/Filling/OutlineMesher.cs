using System;
using System.Collections.Generic;

namespace Alate.Geometry
{
    /// <summary>Fills any outline that does not cross itself with an exact number of nearly equilateral triangles.</summary>
    internal static class OutlineMesher
    {
        /// <summary>Share of the sides of an even mesh that may lie on the rim before the rim is made coarser.</summary>
        private const double k_MostRim = 0.8;

        /// <summary>Factor by which the rim gets coarser each time, and number of times.</summary>
        private const double k_Coarser = 1.12;
        private const int k_Tries = 24;

        /// <summary>
        /// Cosine of the turn from which on a point of the rim counts as a bend, where the corners between smooth stretches are given.
        /// </summary>
        private const double k_BendCosine = 0.9;

        /// <summary>Random shift of the vertices, in spacings, so that no three lie exactly in a line.</summary>
        private const double k_Jitter = 1e-5;

        private static readonly List<PlanPoint> s_None = new List<PlanPoint>();

        /// <summary>Fills an outline with triangles; the first points are the rim, counterclockwise.</summary>
        /// <param name="outline">Counterclockwise; simple.</param>
        /// <param name="triangleCount">Exact.</param>
        /// <param name="rimCount">How many points are the rim.</param>
        /// <param name="corners">Indices of points of the outline that are to be vertices, rising; null to find those at which it
        /// bends.</param>
        /// <exception cref="ArgumentException">So few triangles cannot fill the outline.</exception>
        public static TriangleLinks Mesh(PlanPoint[] outline, int triangleCount, out int rimCount, IReadOnlyList<int> corners = null)
        {
            double even = Math.Sqrt(4.0 * Polygon.Area(outline) / (Math.Sqrt(3.0) * triangleCount));
            for (int attempt = 0; attempt < k_Tries; attempt++, even *= k_Coarser)
            {
                // A triangulation of i points inside a rim of r has 2 i + r − 2 triangles.
                List<PlanPoint> points = RimSampler.Sample(outline, even, triangleCount % 2 != 0, corners);
                rimCount = points.Count;
                int inside = (triangleCount + 2 - rimCount) / 2;
                if (rimCount > k_MostRim * (triangleCount + 2) && attempt + 1 < k_Tries && rimCount > 4)
                    continue;
                if (inside < 0 || !Polygon.IsSimple(points))
                    continue;
                List<PlanPoint> lattice = InteriorPoints.Place(points, corners == null ? s_None : Bends(points), inside);
                if (lattice.Count < inside)
                    continue;
                points.AddRange(lattice);
                TriangleLinks mesh = DelaunayTriangulation.Inside(Jittered(points, k_Jitter * even), rimCount);
                TriangleSmoothing.Run(mesh, rimCount);
                return mesh;
            }

            throw new ArgumentException($"The wing's outline cannot be filled with {triangleCount} triangles; ask for more.");
        }

        private static List<PlanPoint> Bends(List<PlanPoint> rim)
        {
            var bends = new List<PlanPoint>();
            for (int k = 0; k < rim.Count; k++)
            {
                if (Polygon.TurnCosine(rim, k) < k_BendCosine)
                    bends.Add(rim[k]);
            }

            return bends;
        }

        private static PlanPoint[] Jittered(List<PlanPoint> points, double shift)
        {
            var random = new Random(1);
            return points
                .ConvertAll(p => new PlanPoint(p.x + shift * (random.NextDouble() - 0.5), p.z + shift * (random.NextDouble() - 0.5)))
                .ToArray();
        }
    }
}
