using System;
using System.Collections.Generic;

namespace Alate.Geometry
{
    /// <summary>Chooses the vertices of a mesh along its outline: its corners, and between them places at even spacing.</summary>
    internal static class RimSampler
    {
        /// <summary>Deviation, in spacings, from which a bend of the outline is a corner, and the cosine of its least angle.</summary>
        private const double k_CornerDeviation = 0.3, k_CornerCosine = 0.8;

        /// <summary>Chooses the vertices, counterclockwise.</summary>
        /// <param name="outline">Counterclockwise.</param>
        /// <param name="even">Spacing where the wing is wide.</param>
        /// <param name="isOdd">Whether their number shall be odd.</param>
        public static List<PlanPoint> Sample(PlanPoint[] outline, double even, bool isOdd)
        {
            var line = new RimLine(outline);
            var spacing = new RimSpacing(line, even);
            List<double> corners = Corners(outline, line, even);
            var pieces = new int[corners.Count];
            var wanted = new double[corners.Count];
            int total = 0;
            for (int k = 0; k < corners.Count; k++)
            {
                wanted[k] = spacing.Count(corners[k], EndOf(corners, k, line.Length));
                pieces[k] = Math.Max(1, (int)Math.Round(wanted[k]));
                total += pieces[k];
            }

            if (total < 3 || total % 2 != (isOdd ? 1 : 0))
                pieces[Fullest(wanted, pieces)] += total < 3 && total % 2 == (isOdd ? 1 : 0) ? 2 : 1;
            var rim = new List<PlanPoint>();
            for (int k = 0; k < corners.Count; k++)
            {
                for (int piece = 0; piece < pieces[k]; piece++)
                    rim.Add(line.At(spacing.Advance(corners[k], wanted[k] * piece / pieces[k]) % line.Length));
            }

            return rim;
        }

        private static double EndOf(List<double> corners, int corner, double length) =>
            corner + 1 < corners.Count ? corners[corner + 1] : corners[0] + length;

        private static int Fullest(double[] wanted, int[] pieces)
        {
            int fullest = 0;
            for (int k = 1; k < pieces.Length; k++)
            {
                if (wanted[k] / (pieces[k] + 1) > wanted[fullest] / (pieces[fullest] + 1))
                    fullest = k;
            }

            return fullest;
        }

        // Distances along the outline at which it bends for good; its first point stands in where there is none.
        private static List<double> Corners(PlanPoint[] outline, RimLine line, double even)
        {
            PlanPoint[] coarse = Polygon.Simplified(outline, k_CornerDeviation * even);
            var corners = new List<double>();
            int at = 0;
            for (int k = 0; k < coarse.Length; k++)
            {
                while (outline[at].x != coarse[k].x || outline[at].z != coarse[k].z)
                    at++;
                PlanPoint before = coarse[k] - coarse[(k + coarse.Length - 1) % coarse.Length], after = coarse[(k + 1) % coarse.Length] - coarse[k];
                double cosine = PlanPoint.Dot(before, after) / Math.Sqrt(before.LengthSquared * after.LengthSquared);
                if (cosine < k_CornerCosine)
                    corners.Add(line.DistanceTo(at));
            }

            if (corners.Count == 0)
                corners.Add(0.0);
            return corners;
        }
    }
}
