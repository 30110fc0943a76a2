using System;
using Alate.Geometry;

namespace Alate.Fitting
{
    /// <summary>
    /// Parts chains that meet. The paths under them never do, but few straight bones or a deep notch may bring two together; then the
    /// joints of the chains about that place are spread evenly between their neighbours'; the tips too where nothing else helps.
    /// </summary>
    internal static class ChainOrder
    {
        /// <summary>Bones closer than this meet, wing reaches.</summary>
        private const double k_Touch = 3e-4;

        /// <summary>Moves joints until no chain meets another.</summary>
        /// <returns>Whether it came to that.</returns>
        public static bool Untangle(PlanPoint[][] chains)
        {
            int last = chains.Length - 1;
            for (int round = 1; round <= 2 * last; round++)
            {
                if (!TryFindMeeting(chains, out int first, out int second))
                    return true;
                bool withTips = round > last;
                int reach = withTips ? round - last : round;
                Spread(chains, Math.Max(first - reach, 0), Math.Min(second + reach, last), withTips);
            }

            return !Cross(chains);
        }

        /// <summary>Returns true where a chain meets another.</summary>
        public static bool Cross(PlanPoint[][] chains) => TryFindMeeting(chains, out _, out _);

        private static void Spread(PlanPoint[][] chains, int low, int high, bool withTips)
        {
            for (int i = low + 1; i < high; i++)
            {
                double share = (double)(i - low) / (high - low);
                for (int j = 1; j < chains[i].Length - (withTips ? 0 : 1); j++)
                    chains[i][j] = chains[low][j] + (chains[high][j] - chains[low][j]) * share;
            }
        }

        private static bool TryFindMeeting(PlanPoint[][] chains, out int first, out int second)
        {
            for (second = 1; second < chains.Length; second++)
            {
                for (first = 0; first < second; first++)
                {
                    if (Cross(chains[first], chains[second]))
                        return true;
                }
            }

            first = 0;
            return false;
        }

        // The first bones may begin in one place.
        private static bool Cross(PlanPoint[] a, PlanPoint[] b)
        {
            for (int j = 0; j + 1 < a.Length; j++)
            {
                for (int k = 0; k + 1 < b.Length; k++)
                {
                    bool crossing = PlanPoint.SegmentsCross(a[j], a[j + 1], b[k], b[k + 1]);
                    if (crossing && !(j == 0 && k == 0 && IsNear(a[0], b[0])))
                        return true;
                    if (Touches(a[j + 1], b[k], b[k + 1]) || Touches(b[k + 1], a[j], a[j + 1]))
                        return true;
                }
            }

            return false;
        }

        private static bool Touches(PlanPoint p, PlanPoint a, PlanPoint b) => PlanPoint.DistanceSquared(p, a, b) < k_Touch * k_Touch;

        private static bool IsNear(PlanPoint a, PlanPoint b) => (a - b).LengthSquared < k_Touch * k_Touch;
    }
}
