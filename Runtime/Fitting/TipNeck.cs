using System;
using System.Collections.Generic;
using Alate.Geometry;

namespace Alate.Fitting
{
    /// <summary>
    /// Tells a tail from a tip. Where the leading edge, before it comes to the tip, draws in to a neck as no wing tip does, the part beyond
    /// the neck is a tail, and the wing's tip lies before it.
    /// </summary>
    internal static class TipNeck
    {
        private const int k_Places = 800;

        /// <summary>Depth by which the edge draws in, wing reaches.</summary>
        private const double k_Depth = 0.03;

        /// <summary>Largest width of a neck over the mean chord, and largest area beyond it over the wing's area.</summary>
        private const double k_Width = 0.5;
        private const double k_Area = 0.15;

        /// <summary>Finds the tail beyond the neck, if there is one.</summary>
        /// <param name="outline">A turned outline.</param>
        /// <param name="root">Where its leading edge begins.</param>
        /// <param name="tip">Its outermost place.</param>
        /// <param name="end">Where its trailing edge ends.</param>
        /// <param name="tail">What lies beyond the neck.</param>
        public static bool TryFind(ClosedCurve outline, double root, double tip, double end, out OutlineStretch tail)
        {
            tail = default;
            double area = Math.Abs(Polygon.Area(outline.Samples));
            List<int> hull = Hull(outline, root, tip);
            for (int k = hull.Count - 1; k > 0; k--)
            {
                double neck = Deepest(outline, Place(hull[k - 1]), Place(hull[k]), out double depth);
                if (depth < k_Depth)
                    continue;
                double across = Closest(outline, outline.At(neck), tip, end, out double width);
                if (width > k_Width * area || Beyond(outline, neck, across) > k_Area * area)
                    return false;
                tail = new OutlineStretch(neck, across);
                return true;
            }

            return false;

            double Place(int k) => root + (tip - root) * k / k_Places;
        }

        // The places of the leading edge, as numbers up to k_Places, between which a taut string over it runs free.
        private static List<int> Hull(ClosedCurve outline, double root, double tip)
        {
            var points = new PlanPoint[k_Places + 1];
            var hull = new List<int>();
            for (int k = 0; k <= k_Places; k++)
            {
                points[k] = outline.At(root + (tip - root) * k / k_Places);
                while (hull.Count > 1 && Polygon.DoubledArea(points[hull[hull.Count - 2]], points[hull[hull.Count - 1]], points[k]) >= 0.0)
                    hull.RemoveAt(hull.Count - 1);
                hull.Add(k);
            }

            return hull;
        }

        private static double Deepest(ClosedCurve outline, double from, double to, out double depth)
        {
            PlanPoint start = outline.At(from), end = outline.At(to);
            double found = from, most = 0.0;
            int steps = Math.Max(1, (int)((to - from) / outline.Step));
            for (int k = 1; k < steps; k++)
            {
                double s = from + (to - from) * k / steps;
                double off = PlanPoint.DistanceSquared(outline.At(s), start, end);
                if (off <= most)
                    continue;
                most = off;
                found = s;
            }

            depth = Math.Sqrt(most);
            return found;
        }

        private static double Closest(ClosedCurve outline, PlanPoint p, double from, double to, out double distance)
        {
            double found = from, least = double.MaxValue;
            for (int k = 0; k <= k_Places; k++)
            {
                double s = from + (to - from) * k / k_Places, off = (outline.At(s) - p).LengthSquared;
                if (off >= least)
                    continue;
                least = off;
                found = s;
            }

            distance = Math.Sqrt(least);
            return found;
        }

        private static double Beyond(ClosedCurve outline, double from, double to)
        {
            var points = new PlanPoint[k_Places + 1];
            for (int k = 0; k <= k_Places; k++)
                points[k] = outline.At(from + (to - from) * k / k_Places);
            return Math.Abs(Polygon.Area(points));
        }
    }
}
