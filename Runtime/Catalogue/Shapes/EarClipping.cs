using System;
using System.Collections.Generic;
using Alate.Geometry;

namespace Alate.Catalogue
{
    /// <summary>Cuts a simple polygon into triangles that use its corners only, none of them flat.</summary>
    internal static class EarClipping
    {
        /// <summary>Three corner indices a triangle, one triangle fewer than two less than the corners; clockwise as the polygon is.</summary>
        public static List<int> Triangles(IReadOnlyList<PlanPoint> polygon)
        {
            var left = new List<int>();
            for (var corner = 0; corner < polygon.Count; corner++)
            {
                left.Add(corner);
            }

            var triangles = new List<int>(3 * polygon.Count);
            var at = 0;
            for (var tried = 0; left.Count > 2; tried++)
            {
                if (tried > left.Count)
                {
                    throw new ArgumentException("The rim crosses itself.", nameof(polygon));
                }

                at = (at + 1) % left.Count;
                if (IsEar(polygon, left, at))
                {
                    triangles.Add(left[Before(left, at)]);
                    triangles.Add(left[at]);
                    triangles.Add(left[After(left, at)]);
                    left.RemoveAt(at);
                    tried = 0;
                }
            }

            return triangles;
        }

        private static bool IsEar(IReadOnlyList<PlanPoint> polygon, List<int> left, int at)
        {
            var a = polygon[left[Before(left, at)]];
            var b = polygon[left[at]];
            var c = polygon[left[After(left, at)]];
            if (Turn(a, b, c) <= 0)
            {
                return false;
            }

            for (var other = 0; other < left.Count; other++)
            {
                if (other == at || other == Before(left, at) || other == After(left, at))
                {
                    continue;
                }

                var p = polygon[left[other]];
                if (Turn(a, b, p) >= 0 && Turn(b, c, p) >= 0 && Turn(c, a, p) >= 0)
                {
                    return false;
                }
            }

            return true;
        }

        /// <summary>Positive where the way from a over b to c turns clockwise.</summary>
        private static double Turn(PlanPoint a, PlanPoint b, PlanPoint c) => PlanPoint.Cross(c - a, b - a);

        private static int Before(List<int> left, int at) => at == 0 ? left.Count - 1 : at - 1;

        private static int After(List<int> left, int at) => at == left.Count - 1 ? 0 : at + 1;
    }
}
