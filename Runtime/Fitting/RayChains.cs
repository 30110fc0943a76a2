using System;
using Alate.Geometry;

namespace Alate.Fitting
{
    /// <summary>
    /// Lays straight chains that fan out from a wing's base at even angles, for wings on which chains along the edges cross. Straight rays
    /// from one place never meet.
    /// </summary>
    internal static class RayChains
    {
        /// <summary>Least and largest angle of the fan, radians.</summary>
        private const double k_LeastTurn = 0.6;
        private const double k_MostTurn = 5.0;

        /// <summary>Reach of a ray that leaves the wing at once, wing reaches, and of the longest ray over the first.</summary>
        private const double k_LeastReach = 0.03;
        private const double k_MostReach = 1.2;

        /// <summary>Distance of a ray's end from the margin, as a share of its reach.</summary>
        private const double k_Inset = 0.01;

        /// <summary>Number of tries, and the last of those that begin on the base; each later one begins deeper in the wing.</summary>
        public const int Tries = 10;
        private const int k_OnBase = 2;
        private const double k_Depth = 0.06;

        /// <summary>Lays the chains, in the wing's view.</summary>
        /// <param name="outline">The turned outline.</param>
        /// <param name="marks">Of the wing.</param>
        /// <param name="chains">How many.</param>
        /// <param name="joints">Of each chain.</param>
        /// <param name="attempt">From 0: roots all along the base, closer together, in one place, and deeper in the wing.</param>
        /// <returns>[chain][joint]</returns>
        public static PlanPoint[][] Lay(ClosedCurve outline, WingLandmarks marks, int chains, int joints, int attempt)
        {
            double rootShare = Math.Max(0.0, 1.0 - 0.5 * attempt);
            PlanPoint from = Inside(outline, marks.Base, k_Depth * Math.Max(0, attempt - k_OnBase)), first = outline.At(marks.Tip) - from;
            double begin = Elementary.Atan2(first.z, first.x), turn = Turn(outline, marks, from);
            PlanPoint front = outline.At(marks.LeadingRoot), rear = outline.At(marks.TrailingRoot);
            var made = new PlanPoint[chains][];
            double most = double.MaxValue;
            for (int i = 0; i < chains; i++)
            {
                double share = (double)i / (chains - 1), angle = begin - turn * share;
                var direction = new PlanPoint(Elementary.Cos(angle), Elementary.Sin(angle));
                double reach = Math.Min(Math.Max(Reach(outline.Line, from, direction), k_LeastReach), most);
                if (i == 0)
                    most = k_MostReach * reach;
                PlanPoint root = from + (front + (rear - front) * share - marks.Base) * rootShare, tip = from + direction * reach;
                made[i] = new PlanPoint[joints];
                for (int j = 0; j < joints; j++)
                    made[i][j] = root + (tip - root) * ((double)j / (joints - 1));
            }

            return made;
        }

        /// <summary>Middle of the lines from the roots to the tips.</summary>
        public static PlanPoint Middle(PlanPoint[][] chains)
        {
            PlanPoint sum = default;
            foreach (PlanPoint[] chain in chains)
                sum += chain[chain.Length - 1] - chain[0];
            return PlanPoint.Unit(sum);
        }

        // The base, or a place on the way to the wing's centre; a little into the wing where that lies on the outline or beside it.
        private static PlanPoint Inside(ClosedCurve outline, PlanPoint place, double depth)
        {
            var inward = PlanPoint.Unit(Polygon.Centroid(outline.Samples) - place);
            place += inward * depth;
            for (int k = 1; k < 40 && !outline.Contains(place); k++)
                place += inward * 0.01;
            return place;
        }

        // Clockwise from the tip to the end of the last chain along the margin.
        private static double Turn(ClosedCurve outline, WingLandmarks marks, PlanPoint from)
        {
            const int steps = 400;
            double turn = 0.0;
            PlanPoint before = outline.At(marks.Tip) - from;
            for (int k = 1; k <= steps; k++)
            {
                PlanPoint at = outline.At(marks.Tip + (marks.Last - marks.Tip) * k / steps) - from;
                turn += Elementary.Atan2(PlanPoint.Cross(at, before), PlanPoint.Dot(before, at));
                before = at;
            }

            return Math.Min(Math.Max(turn, k_LeastTurn), k_MostTurn);
        }

        // To where a ray first leaves the wing.
        private static double Reach(Polyline rim, PlanPoint from, PlanPoint direction)
        {
            double reach = rim.RayDistance(from, direction, -1, out int met);
            return met < 0 ? 0.0 : reach * (1.0 - k_Inset);
        }
    }
}
