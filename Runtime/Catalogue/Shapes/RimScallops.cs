using System;
using System.Collections.Generic;
using Alate.Geometry;

namespace Alate.Catalogue
{
    /// <summary>
    /// Scallops of a margin: hollows between points that stay on the outline, as between the veins of a hind wing or the rays of a fin. The
    /// points lie evenly along a part of the margin.
    /// </summary>
    internal sealed class RimScallops
    {
        private const int k_StepsPerHollow = 24;

        private readonly double m_From;
        private readonly double m_To;
        private readonly double[] m_Depths;

        /// <param name="from">Where the first hollow begins: share of the margin's length from the leading corner of the base, 0 to
        /// 1.</param>
        /// <param name="to">Where the last hollow ends.</param>
        /// <param name="depths">Depth of each hollow in order, wing lengths.</param>
        public RimScallops(double from, double to, params double[] depths)
        {
            m_From = from;
            m_To = to;
            m_Depths = depths;
        }

        /// <summary>The margin with its hollows, parted at the points between them.</summary>
        public List<Polyline> Cut(Polyline margin)
        {
            var stretches = new List<Polyline>();
            Append(stretches, margin, 0, m_From, 0);
            for (int hollow = 0; hollow < m_Depths.Length; hollow++)
            {
                double width = (m_To - m_From) / m_Depths.Length;
                Append(stretches, margin, m_From + hollow * width, m_From + (hollow + 1) * width, m_Depths[hollow]);
            }

            Append(stretches, margin, m_To, 1, 0);
            return stretches;
        }

        private static void Append(List<Polyline> stretches, Polyline margin, double from, double to, double depth)
        {
            if (to <= from)
                return;

            int steps = depth > 0 ? k_StepsPerHollow : Math.Max(2, (int)Math.Ceiling((to - from) * 1000));
            stretches.Add(Polyline.Trace(steps, share =>
            {
                double distance = (from + share * (to - from)) * margin.Length;
                return margin.At(distance)
                    + Inward(margin, distance, 0.5 * (to - from) * margin.Length) * (depth * Elementary.Sin(Math.PI * share));
            }));
        }

        private static PlanPoint Inward(Polyline margin, double distance, double reach)
        {
            // The margin ends where a reach is beyond it.
            PlanPoint along = margin.At(distance + reach) - margin.At(distance - reach);
            return new PlanPoint(along.z, -along.x) * (1.0 / Math.Sqrt(along.LengthSquared));
        }
    }
}
