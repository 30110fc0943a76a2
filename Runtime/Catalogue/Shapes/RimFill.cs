using System;
using Alate.Geometry;

namespace Alate.Catalogue
{
    /// <summary>Fills a rim with an exact number of nearly equilateral triangles.</summary>
    internal static class RimFill
    {
        private const int k_Relaxations = 4;
        private const double k_Widen = 1.05;

        /// <summary>A triangulation with b corners on its rim and i points inside has b + 2 i − 2 triangles, whatever it looks like.</summary>
        public static PlanTriangulation Triangulate(WingRim rim, int triangleCount)
        {
            var isOdd = triangleCount % 2 == 1;
            var spacing = 0.5 * rim.Length / triangleCount;
            var polygon = rim.Polygon(spacing, isOdd);
            spacing = Math.Sqrt(4 / Math.Sqrt(3) * Area(polygon) / triangleCount);
            for (polygon = rim.Polygon(spacing, isOdd); polygon.Length > triangleCount + 2; spacing *= k_Widen)
            {
                polygon = rim.Polygon(spacing, isOdd);
            }

            var triangulation = new PlanTriangulation(polygon);
            foreach (var point in LatticePoints.Inside(polygon, (triangleCount + 2 - polygon.Length) / 2, k_Widen * spacing))
            {
                triangulation.Insert(point);
            }

            for (var round = 0; round < k_Relaxations; round++)
            {
                triangulation.Relax();
            }

            return triangulation;
        }

        private static double Area(PlanPoint[] polygon)
        {
            var doubled = 0.0;
            for (var k = 0; k < polygon.Length; k++)
            {
                doubled -= PlanPoint.Cross(polygon[k], polygon[(k + 1) % polygon.Length]);
            }

            return 0.5 * doubled;
        }
    }
}
