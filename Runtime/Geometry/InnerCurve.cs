using System.Collections.Generic;

namespace Alate.Geometry
{
    /// <summary>
    /// Smooth closed curve just inside a polygon: it touches the sides in their middles and rounds the corners off, and passes through
    /// those that point inwards.
    /// </summary>
    internal static class InnerCurve
    {
        /// <summary>Pieces from the middle of a side to that of the next.</summary>
        public const int PiecesOfACorner = 8;

        /// <summary>Rounds of the solution; the error of each is a third of the one before.</summary>
        private const int k_Rounds = 32;

        /// <summary>Tells the corners of a polygon that point outwards.</summary>
        /// <param name="corners">Of a polygon, counterclockwise, three or more.</param>
        public static bool[] Bulges(IReadOnlyList<PlanPoint> corners)
        {
            int count = corners.Count;
            bool[] bulges = new bool[count];
            for (int k = 0; k < count; k++)
            {
                PlanPoint at = corners[k];
                bulges[k] = PlanPoint.Cross(at - corners[(k + count - 1) % count], corners[(k + 1) % count] - at) > 0.0;
            }

            return bulges;
        }

        /// <summary>Points of the curve, a quadratic B-spline.</summary>
        /// <param name="corners">Of the polygon, counterclockwise, three or more.</param>
        public static PlanPoint[] Of(IReadOnlyList<PlanPoint> corners) => Of(corners, Bulges(corners));

        /// <summary>Points of the curve as the corners have moved.</summary>
        /// <param name="corners">Where they are.</param>
        /// <param name="bulges">[corner] Whether it pointed outwards before.</param>
        public static PlanPoint[] Of(IReadOnlyList<PlanPoint> corners, bool[] bulges)
        {
            PlanPoint[] control = Control(corners, bulges);
            var curve = new PlanPoint[PiecesOfACorner * control.Length];
            for (int k = 0; k < curve.Length; k++)
            {
                int corner = k / PiecesOfACorner;
                double share = (k % PiecesOfACorner + 0.5) / PiecesOfACorner;
                PlanPoint from = Middle(control, corner, -1), to = Middle(control, corner, 1);
                curve[k] = from * ((1.0 - share) * (1.0 - share)) + control[corner] * (2.0 * share * (1.0 - share)) + to * (share * share);
            }

            return curve;
        }

        // Points whose spline passes through each corner that points inwards, and as near to each other one as the corners' own spline.
        private static PlanPoint[] Control(IReadOnlyList<PlanPoint> corners, bool[] bulges)
        {
            int count = corners.Count;
            var passed = new PlanPoint[count];
            var control = new PlanPoint[count];
            for (int k = 0; k < count; k++)
            {
                PlanPoint at = corners[k];
                passed[k] = bulges[k] ? (corners[(k + count - 1) % count] + at * 6.0 + corners[(k + 1) % count]) * 0.125 : at;
                control[k] = at;
            }

            for (int round = 0; round < k_Rounds; round++)
            {
                for (int k = 0; k < count; k++)
                    control[k] = (passed[k] * 8.0 - control[(k + count - 1) % count] - control[(k + 1) % count]) * (1.0 / 6.0);
            }

            return control;
        }

        private static PlanPoint Middle(PlanPoint[] control, int corner, int way) =>
            (control[corner] + control[(corner + way + control.Length) % control.Length]) * 0.5;
    }
}
