using System;
using System.Collections.Generic;
using Alate.Geometry;

namespace Alate.Fitting
{
    /// <summary>
    /// Finds the ends of the rays that hold a fin or a fan where its margin shows them: hollows from one to the next, beginning at the tip
    /// or before.
    /// </summary>
    internal static class MarginRays
    {
        /// <summary>Largest width, and length along the outline, of a hollow between rays, wing reaches.</summary>
        private const double k_Widest = 0.4;
        private const double k_Longest = 1.0;

        /// <summary>Least depth of a hollow, as a share of its width.</summary>
        private const double k_Shallowest = 0.025;

        /// <summary>Least mean depth of the hollows, wing reaches; more than the steps that pixels make.</summary>
        private const double k_MeanDepth = 0.015;

        /// <summary>Largest width of a hollow over the narrowest.</summary>
        private const double k_Likeness = 4.0;

        /// <summary>
        /// Largest gap between a hollow and the next, as a share of the hollow's width, below that of a hollow without depth.
        /// </summary>
        private const double k_Gap = 0.3;

        /// <summary>Least number of rays.</summary>
        public const int Least = 7;

        /// <summary>Finds the arc lengths of the rays' ends, in order; none on a wing without such a margin.</summary>
        /// <param name="outline">The turned outline.</param>
        /// <param name="from">Where the leading edge begins.</param>
        /// <param name="to">Where the trailing edge ends.</param>
        /// <param name="tip">Of the wing.</param>
        public static List<double> Find(ClosedCurve outline, double from, double to, double tip)
        {
            var run = new List<OutlineStretch>();
            foreach (OutlineStretch hollow in Hollows(outline, from, to))
            {
                if (run.Count > 0 && !TryBridge(run, hollow))
                {
                    if (IsFan(outline, run, tip))
                        break;
                    run.Clear();
                }

                run.Add(hollow);
            }

            return IsFan(outline, run, tip) ? Ends(run) : new List<double>();
        }

        // Whether a hollow is the next of the run; one between them that has no depth is added.
        private static bool TryBridge(List<OutlineStretch> run, OutlineStretch hollow)
        {
            var between = new OutlineStretch(run[run.Count - 1].to, hollow.from);
            double width = 0.5 * (run[run.Count - 1].Length + hollow.Length);
            if (!IsAlike(run, hollow))
                return false;
            if (Math.Abs(between.Length - width) <= k_Gap * width)
                run.Add(between);
            else if (between.Length > k_Gap * width)
                return false;
            return true;
        }

        private static List<double> Ends(List<OutlineStretch> run)
        {
            var ends = new List<double> { run[0].from };
            for (int k = 1; k < run.Count; k++)
                ends.Add(0.5 * (run[k - 1].to + run[k].from));
            ends.Add(run[run.Count - 1].to);
            return ends;
        }

        private static bool IsFan(ClosedCurve outline, List<OutlineStretch> run, double tip)
        {
            if (run.Count + 1 < Least || run[0].from > tip + 0.5 * run[0].Length)
                return false;
            double depth = 0.0;
            foreach (OutlineStretch hollow in run)
                depth += Depth(outline, hollow);
            return depth >= k_MeanDepth * run.Count;
        }

        private static bool IsAlike(List<OutlineStretch> run, OutlineStretch next)
        {
            double narrowest = next.Length, widest = next.Length;
            foreach (OutlineStretch hollow in run)
            {
                narrowest = Math.Min(narrowest, hollow.Length);
                widest = Math.Max(widest, hollow.Length);
            }

            return widest <= k_Likeness * narrowest;
        }

        // A thread drawn round the wing bridges the hollows.
        private static IEnumerable<OutlineStretch> Hollows(ClosedCurve outline, double from, double to)
        {
            var places = new PlanPoint[1 + (int)((to - from) / outline.Step)];
            for (int k = 0; k < places.Length; k++)
                places[k] = outline.At(from + k * outline.Step);
            int reach = (int)(k_Longest / outline.Step);
            for (int k = 0; k + 1 < places.Length;)
            {
                int next = Next(places, k, Math.Min(k + reach, places.Length - 1));
                var hollow = new OutlineStretch(from + k * outline.Step, from + next * outline.Step);
                if (Depth(outline, hollow) > k_Shallowest * hollow.Length)
                    yield return hollow;
                k = next;
            }
        }

        // The place seen farthest out.
        private static int Next(PlanPoint[] places, int at, int last)
        {
            PlanPoint best = places[at + 1] - places[at];
            int next = at + 1;
            for (int k = at + 2; k <= last; k++)
            {
                PlanPoint towards = places[k] - places[at];
                if (towards.LengthSquared > k_Widest * k_Widest || PlanPoint.Cross(best, towards) <= 0.0)
                    continue;
                best = towards;
                next = k;
            }

            return next;
        }

        private static double Depth(ClosedCurve outline, in OutlineStretch hollow)
        {
            PlanPoint start = outline.At(hollow.from), end = outline.At(hollow.to);
            double depth = 0.0;
            for (double s = hollow.from + outline.Step; s < hollow.to; s += outline.Step)
                depth = Math.Max(depth, PlanPoint.DistanceSquared(outline.At(s), start, end));
            return Math.Sqrt(depth);
        }
    }
}
