using System;
using System.Collections.Generic;
using Alate.Geometry;

namespace Alate.Authoring
{
    /// <summary>Chooses the vein that each chain follows, in order from the leading to the trailing edge (dynamic programming).</summary>
    internal static class VeinChoice
    {
        /// <summary>Largest movement of a chain's tip to meet a vein, in mean distances between tips.</summary>
        private const double k_Reach = 1.4;

        /// <summary>Least distance between the tips of chains on veins, in mean distances between tips.</summary>
        private const double k_Apart = 0.45;

        /// <summary>
        /// Furthest from the leading edge that a vein may run for the first chain to follow it, a share of the wing's length.
        /// </summary>
        private const double k_LeadingEdge = 0.025;

        /// <summary>[chain] The vein it follows, or null.</summary>
        /// <param name="chains">As fitted to the outline.</param>
        /// <param name="veins">In any order.</param>
        /// <param name="order">Of places on the outline.</param>
        /// <param name="length">Of the wing.</param>
        public static RadialVein[] Choose(PlanPoint[][] chains, List<RadialVein> veins, RimOrder order, double length)
        {
            var sorted = new List<RadialVein>(veins);
            sorted.Sort((a, b) => order.Of(a.RimDistance).CompareTo(order.Of(b.RimDistance)));
            double[] tips = Array.ConvertAll(chains, chain => order.Of(chain[chain.Length - 1]));
            double[] places = sorted.ConvertAll(vein => order.Of(vein.RimDistance)).ToArray();
            double mean = (tips[tips.Length - 1] - tips[0]) / (tips.Length - 1);
            int columns = sorted.Count;
            // best[i, k]: the most gained by the first i chains where the last chosen of the sorted veins is k − 1, or none when k is 0.
            double[,] best = new double[chains.Length + 1, columns + 1];
            int[,] chosen = new int[chains.Length + 1, columns + 1];
            for (int k = 1; k <= columns; k++)
                best[0, k] = double.NegativeInfinity;
            for (int i = 1; i <= chains.Length; i++)
            {
                for (int k = 0; k <= columns; k++)
                {
                    best[i, k] = best[i - 1, k];
                    chosen[i, k] = -1;
                    if (k == 0)
                        continue;
                    double gain = i == 1
                        ? LeadingGain(chains[0], sorted[k - 1], length)
                        : Gain((places[k - 1] - tips[i - 1]) / mean, sorted[k - 1]);
                    for (int before = 0; before < k && gain > 0.0; before++)
                    {
                        bool apart = before == 0 || places[k - 1] - places[before - 1] > k_Apart * mean;
                        if (!apart || best[i - 1, before] + gain <= best[i, k])
                            continue;
                        best[i, k] = best[i - 1, before] + gain;
                        chosen[i, k] = before;
                    }
                }
            }

            return Trace(sorted, best, chosen, chains.Length);
        }

        private static RadialVein[] Trace(List<RadialVein> sorted, double[,] best, int[,] chosen, int chains)
        {
            int last = 0;
            for (int k = 1; k <= sorted.Count; k++)
                last = best[chains, k] > best[chains, last] ? k : last;
            var followed = new RadialVein[chains];
            for (int i = chains; i > 0; i--)
            {
                if (chosen[i, last] < 0)
                    continue;
                followed[i - 1] = sorted[last - 1];
                last = chosen[i, last];
            }

            return followed;
        }

        private static double Gain(double offset, RadialVein vein) => vein.Coverage * (k_Reach * k_Reach - offset * offset);

        // The first chain leaves the leading edge for no vein.
        private static double LeadingGain(PlanPoint[] chain, RadialVein vein, double length)
        {
            PlanPoint[] even = Polyline.Even(vein.Path, 24);
            double most = 0.0;
            for (int k = 4; k < even.Length; k++)
                most = Math.Max(most, Polyline.Distance(chain, even[k]));
            return most < k_LeadingEdge * length ? k_Reach * k_Reach * vein.Coverage : 0.0;
        }
    }
}
