using System;
using System.Collections.Generic;

namespace Alate
{
    /// <summary>
    /// Joints on a path round a wing, clockwise, so that the straight bones between them follow it well: closer together where it bends, evenly where it
    /// is straight.
    /// </summary>
    internal static class BalancedJoints
    {
        private const int k_Places = 400;
        private const int k_Rounds = 60;

        /// <summary>
        /// A bone's cost is this share of its length and the square of its largest distance from the path over the distance that is
        /// nothing to mind, wing reaches: small bends leave the joints even.
        /// </summary>
        private const double k_LengthShare = 0.05;
        private const double k_Unminded = 0.01;

        /// <summary>Weight of the distance where the path turns in, as the bone cannot stay outside the wing.</summary>
        private const double k_HollowWeight = 2.0;

        /// <summary>Root, joints and tip on the path.</summary>
        /// <param name="path">At least two points.</param>
        /// <param name="count">At least 2.</param>
        public static PlanPoint[] Place(IReadOnlyList<PlanPoint> path, int count)
        {
            PlanPoint[] places = OpenPath.Even(path, k_Places + 1);
            var at = new int[count];
            for (int j = 0; j < count; j++)
                at[j] = (int)Math.Round((double)j * k_Places / (count - 1));
            for (int round = 0; round < k_Rounds; round++)
            {
                bool moved = false;
                for (int j = 1; j + 1 < count; j++)
                {
                    int balanced = Balance(places, at[j - 1], at[j + 1]);
                    moved |= balanced != at[j];
                    at[j] = balanced;
                }

                if (!moved)
                    break;
            }

            return Array.ConvertAll(at, place => places[place]);
        }

        // The bone before costs the more, the bone behind the less, the farther out the joint between them.
        private static int Balance(PlanPoint[] places, int before, int after)
        {
            int low = before + 1, high = after - 1;
            while (low < high)
            {
                int middle = (low + high) / 2;
                if (Cost(places, before, middle) < Cost(places, middle, after))
                    low = middle + 1;
                else
                    high = middle;
            }

            return low;
        }

        private static double Cost(PlanPoint[] places, int from, int to)
        {
            double farthest = 0.0;
            PlanPoint start = places[from], end = places[to];
            for (int k = from + 1; k < to; k++)
            {
                double weight = Polygon.DoubledArea(start, places[k], end) > 0.0 ? k_HollowWeight * k_HollowWeight : 1.0;
                farthest = Math.Max(farthest, weight * PlanPoint.DistanceSquared(places[k], start, end));
            }

            return farthest / k_Unminded + k_LengthShare * Math.Sqrt((end - start).LengthSquared);
        }
    }
}
