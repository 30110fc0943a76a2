using System;
using System.Collections.Generic;
using System.Linq;

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
        /// <param name="corners">Indices of the outline's corners, rising; null to find those at which it bends.</param>
        public static List<PlanPoint> Sample(PlanPoint[] outline, double even, bool isOdd, IReadOnlyList<int> corners)
        {
            var line = new Polyline(outline, true);
            var spacing = new RimSpacing(line, even);
            var starts = (corners ?? Corners(outline, even)).Select(line.DistanceTo).ToList();
            int[] pieces = new int[starts.Count];
            double[] wanted = new double[starts.Count];
            int total = 0;
            for (int k = 0; k < starts.Count; k++)
            {
                wanted[k] = spacing.Count(starts[k], EndOf(starts, k, line.Length));
                pieces[k] = Math.Max(1, (int)Math.Round(wanted[k]));
                total += pieces[k];
            }

            if (total < 3 || total % 2 != (isOdd ? 1 : 0))
                pieces[Longest(wanted, pieces, corners == null ? 1 : 0)] += total < 3 && total % 2 == (isOdd ? 1 : 0) ? 2 : 1;
            var rim = new List<PlanPoint>();
            for (int k = 0; k < starts.Count; k++)
            {
                for (int piece = 0; piece < pieces[k]; piece++)
                    rim.Add(line.At(spacing.Advance(starts[k], wanted[k] * piece / pieces[k]) % line.Length));
            }

            return rim;
        }

        private static double EndOf(List<double> corners, int corner, double length) =>
            corner + 1 < corners.Count ? corners[corner + 1] : corners[0] + length;

        // The stretch whose pieces are longest, with some more of them: between corners that were found, a short stretch stays whole.
        private static int Longest(double[] wanted, int[] pieces, int more)
        {
            int longest = 0;
            for (int k = 1; k < pieces.Length; k++)
            {
                if (wanted[k] / (pieces[k] + more) > wanted[longest] / (pieces[longest] + more))
                    longest = k;
            }

            return longest;
        }

        // Points at which the outline bends for good; its first one stands in where there is none.
        private static List<int> Corners(PlanPoint[] outline, double even)
        {
            PlanPoint[] coarse = Polygon.Simplified(outline, k_CornerDeviation * even);
            var corners = new List<int>();
            int at = 0;
            for (int k = 0; k < coarse.Length; k++)
            {
                while (outline[at].x != coarse[k].x || outline[at].z != coarse[k].z)
                    at++;
                if (Polygon.TurnCosine(coarse, k) < k_CornerCosine)
                    corners.Add(at);
            }

            if (corners.Count == 0)
                corners.Add(0);
            return corners;
        }
    }
}
