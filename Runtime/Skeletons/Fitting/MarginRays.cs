using System;
using System.Collections.Generic;

namespace Alate
{
    /// <summary>
    /// The ends of the rays that hold a fin or a fan, where its margin tells them: it hangs in hollows from one to the next, on both sides of the tip.
    /// </summary>
    internal static class MarginRays
    {
        /// <summary>Hollows wider than this, or longer along the outline, are none between rays, wing reaches.</summary>
        private const double k_Widest = 0.4;
        private const double k_Longest = 1.0;

        /// <summary>Shallower ones are not seen, shares of their width.</summary>
        private const double k_Shallowest = 0.025;

        /// <summary>The widest of the hollows has at most this many times the width of the narrowest.</summary>
        private const double k_Likeness = 4.0;

        /// <summary>What of a hollow's width may lie between it and the next; a gap as wide as a hollow, to this share, is one without depth.</summary>
        private const double k_Gap = 0.3;

        /// <summary>Hollows there must be; the first begins at the tip or before: a wing whose rear margin is scalloped is no fan.</summary>
        private const int k_Least = 6;

        /// <summary>Arc lengths of the rays' ends, in order; none on a wing that is no such fan.</summary>
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
                    if (IsFan(run, tip))
                        break;
                    run.Clear();
                }

                run.Add(hollow);
            }

            return IsFan(run, tip) ? Ends(run) : new List<double>();
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

        private static bool IsFan(List<OutlineStretch> run, double tip) =>
            run.Count >= k_Least && run[0].from <= tip + 0.5 * run[0].Length;

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
            int count = (int)((to - from) / outline.Step), reach = (int)(k_Longest / outline.Step);
            for (int k = 0; k < count;)
            {
                int next = Next(outline, from, k, Math.Min(k + reach, count));
                if (next > k + 1 && Depth(outline, from, k, next) > k_Shallowest * (next - k) * outline.Step)
                    yield return new OutlineStretch(from + k * outline.Step, from + next * outline.Step);
                k = next;
            }
        }

        // The place seen farthest out.
        private static int Next(ClosedCurve outline, double from, int at, int last)
        {
            PlanPoint here = outline.At(from + at * outline.Step), best = outline.At(from + (at + 1) * outline.Step) - here;
            int next = at + 1;
            for (int k = at + 2; k <= last; k++)
            {
                PlanPoint towards = outline.At(from + k * outline.Step) - here;
                if (towards.LengthSquared > k_Widest * k_Widest || PlanPoint.Cross(best, towards) <= 0.0)
                    continue;
                best = towards;
                next = k;
            }

            return next;
        }

        private static double Depth(ClosedCurve outline, double from, int first, int last)
        {
            PlanPoint start = outline.At(from + first * outline.Step), end = outline.At(from + last * outline.Step);
            double depth = 0.0;
            for (int k = first + 1; k < last; k++)
                depth = Math.Max(depth, PlanPoint.DistanceSquared(outline.At(from + k * outline.Step), start, end));
            return Math.Sqrt(depth);
        }
    }
}
