using System;
using System.Collections.Generic;
using Alate.Geometry;

namespace Alate.Fitting
{
    /// <summary>
    /// Chooses joints on a path round a wing, clockwise, so that the straight bones between them follow it well: closer together where it
    /// bends, evenly where it is straight. Of all choices, takes the one with the least sum of the bones' costs.
    /// </summary>
    internal static class BalancedJoints
    {
        /// <summary>
        /// Places on the path among which the joints are chosen first, and steps between two of those in which they are then moved.
        /// </summary>
        private const int k_Places = 120;
        private const int k_Steps = 16;

        /// <summary>
        /// A bone's cost is the cube of the sum of this share of its length and of its largest distance from the path, squared, over the
        /// distance that is nothing to mind, wing reaches: small bends leave the joints even.
        /// </summary>
        private const double k_LengthShare = 0.05;
        private const double k_Unminded = 0.01;

        /// <summary>Weight of the distance where the path turns in, as the bone cannot stay outside the wing.</summary>
        private const double k_HollowWeight = 4.0;

        /// <summary>Weight of the distance at the root, where a wing hardly moves; it rises to 1 over the inner third.</summary>
        private const double k_RootWeight = 0.4;
        private const double k_Inner = 1.0 / 3.0;

        /// <summary>Root, joints and tip on the path.</summary>
        /// <param name="path">At least two points.</param>
        /// <param name="count">At least 2.</param>
        public static PlanPoint[] Place(IReadOnlyList<PlanPoint> path, int count)
        {
            PlanPoint[] places = Polyline.Even(path, k_Places * k_Steps + 1);
            int[] at = Choose(places, count);
            for (int step = k_Steps / 2; step > 0; step /= 2)
                Move(places, at, step);
            return Array.ConvertAll(at, place => places[place]);
        }

        // Dynamic programming: the least cost with which the first joints reach each place.
        private static int[] Choose(PlanPoint[] places, int count)
        {
            double[,] costs = new double[count, k_Places + 1];
            int[,] before = new int[count, k_Places + 1];
            for (int j = 0; j < count; j++)
            {
                for (int k = 0; k <= k_Places; k++)
                    costs[j, k] = j + k == 0 ? 0.0 : double.PositiveInfinity;
            }

            for (int from = 0; from < k_Places; from++)
            {
                for (int to = from + 1; to <= k_Places; to++)
                {
                    double cost = Cost(places, from * k_Steps, to * k_Steps, k_Steps);
                    for (int j = 1; j < count; j++)
                    {
                        if (costs[j - 1, from] + cost >= costs[j, to])
                            continue;
                        costs[j, to] = costs[j - 1, from] + cost;
                        before[j, to] = from;
                    }
                }
            }

            int[] at = new int[count];
            for (int j = count - 1, k = k_Places; j >= 0; k = before[j, k], j--)
                at[j] = k * k_Steps;
            return at;
        }

        private static void Move(PlanPoint[] places, int[] at, int step)
        {
            for (bool moved = true; moved;)
            {
                moved = false;
                for (int j = 1; j + 1 < at.Length; j++)
                {
                    double here = Around(at[j]);
                    foreach (int to in new[] { at[j] - step, at[j] + step })
                    {
                        if (to <= at[j - 1] || to >= at[j + 1] || Around(to) >= here)
                            continue;
                        at[j] = to;
                        moved = true;
                        break;
                    }

                    double Around(int place) => Cost(places, at[j - 1], place, 1) + Cost(places, place, at[j + 1], 1);
                }
            }
        }

        private static double Cost(PlanPoint[] places, int from, int to, int step)
        {
            double farthest = 0.0;
            PlanPoint start = places[from], end = places[to];
            for (int k = from + step; k < to; k += step)
            {
                bool isHollow = Polygon.DoubledArea(start, places[k], end) > 0.0;
                double weight = isHollow
                    ? k_HollowWeight
                    : Math.Min(1.0, k_RootWeight + (1.0 - k_RootWeight) * k / (k_Inner * places.Length));
                farthest = Math.Max(farthest, weight * weight * PlanPoint.DistanceSquared(places[k], start, end));
            }

            double cost = farthest / k_Unminded + k_LengthShare * Math.Sqrt((end - start).LengthSquared);
            return cost * cost * cost;
        }
    }
}
