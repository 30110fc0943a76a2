using System;
using System.Collections.Generic;
using Alate.Geometry;

namespace Alate.Catalogue
{
    /// <summary>
    /// Scallops of a margin: hollows between points that stay on the outline, as between the veins of a hind wing or the rays of a fin. The points lie evenly
    /// along a part of the margin.
    /// </summary>
    internal sealed class RimScallops
    {
        private const int k_StepsPerHollow = 24;

        private readonly double m_From;
        private readonly double m_To;
        private readonly double[] m_Depths;

        /// <param name="from">Where the first hollow begins: share of the margin's length from the leading corner of the base, 0 to 1.</param>
        /// <param name="to">Where the last hollow ends.</param>
        /// <param name="depths">Depth of each hollow in order, wing lengths.</param>
        public RimScallops(double from, double to, params double[] depths)
        {
            m_From = from;
            m_To = to;
            m_Depths = depths;
        }

        /// <summary>The margin with its hollows, parted at the points between them.</summary>
        public List<PlanarPath> Cut(PlanarPath margin)
        {
            var stretches = new List<PlanarPath>();
            Append(stretches, margin, 0, m_From, 0);
            for (var hollow = 0; hollow < m_Depths.Length; hollow++)
            {
                var width = (m_To - m_From) / m_Depths.Length;
                Append(stretches, margin, m_From + hollow * width, m_From + (hollow + 1) * width, m_Depths[hollow]);
            }

            Append(stretches, margin, m_To, 1, 0);
            return stretches;
        }

        private static void Append(List<PlanarPath> stretches, PlanarPath margin, double from, double to, double depth)
        {
            if (to <= from)
            {
                return;
            }

            var stretch = new PlanarPath();
            var steps = depth > 0 ? k_StepsPerHollow : Math.Max(2, (int)Math.Ceiling((to - from) * 1000));
            for (var step = 0; step <= steps; step++)
            {
                var share = (double)step / steps;
                var distance = (from + share * (to - from)) * margin.Length;
                var (x, z) = margin.At(distance);
                var (inwardX, inwardZ) = Inward(margin, distance, 0.5 * (to - from) * margin.Length);
                var hollow = depth * Math.Sin(Math.PI * share);
                stretch.Add(x + hollow * inwardX, z + hollow * inwardZ);
            }

            stretches.Add(stretch);
        }

        private static (double X, double Z) Inward(PlanarPath margin, double distance, double reach)
        {
            var (x0, z0) = margin.At(Math.Max(0, distance - reach));
            var (x1, z1) = margin.At(Math.Min(margin.Length, distance + reach));
            var length = Math.Sqrt((x1 - x0) * (x1 - x0) + (z1 - z0) * (z1 - z0));
            return ((z1 - z0) / length, (x0 - x1) / length);
        }
    }
}
