using System;
using System.Collections.Generic;
using Alate.Geometry;

namespace Alate.Catalogue
{
    /// <summary>
    /// Spots along a margin, half way between the ends of neighbouring veins: one in each cell. Each is a whole ellipse, however sharply
    /// the margin bends beside it.
    /// </summary>
    internal sealed class MarginSpots
    {
        /// <summary>Half the length of the margin by which the direction at a spot is measured, wing lengths.</summary>
        private const double k_Reach = 0.02;

        private readonly (PlanPoint Middle, PlanPoint Along, PlanPoint Inward)[] m_Spots;

        /// <param name="margin">Points of the margin, x, z, x, z, …</param>
        /// <param name="tips">Ends of the veins in their order, x, z, x, z, …; two or more.</param>
        /// <param name="within">A place on the wing, towards which the spots lie.</param>
        public MarginSpots(IReadOnlyList<double> margin, double[] tips, PlanPoint within)
        {
            StrokeSet line = new StrokeSet().Add(margin);
            m_Spots = new (PlanPoint, PlanPoint, PlanPoint)[tips.Length / 2 - 1];
            line.Distance(tips[0], tips[1], out double before);
            for (int k = 0; k < m_Spots.Length; k++)
            {
                line.Distance(tips[2 * k + 2], tips[2 * k + 3], out double next);
                double at = 0.5 * (before + next);
                PlanPoint middle = On(margin, at), along = PlanPoint.Unit(On(margin, at + k_Reach) - On(margin, at - k_Reach));
                var inward = new PlanPoint(-along.z, along.x);
                m_Spots[k] = (middle, along, PlanPoint.Dot(inward, within - middle) < 0.0 ? inward * -1.0 : inward);
                before = next;
            }
        }

        /// <summary>Share of the spots at a place.</summary>
        /// <param name="span">Along the span.</param>
        /// <param name="forward">Ahead of the hinge line.</param>
        /// <param name="depth">Of the middles of the spots below the margin.</param>
        /// <param name="radiusAlong">Half their length.</param>
        /// <param name="radiusAcross">Half their width.</param>
        /// <param name="softness">Width of their edges.</param>
        public float At(double span, double forward, double depth, double radiusAlong, double radiusAcross, double softness)
        {
            float inside = 0f;
            foreach ((PlanPoint middle, PlanPoint along, PlanPoint inward) in m_Spots)
            {
                PlanPoint off = new PlanPoint(span, forward) - middle - inward * depth;
                inside = Math.Max(
                    inside, Ink.Ellipse(PlanPoint.Dot(off, along), PlanPoint.Dot(off, inward), radiusAlong, radiusAcross, softness));
            }

            return inside;
        }

        private static PlanPoint On(IReadOnlyList<double> points, double along)
        {
            (double x, double z) = Ink.On(points, Math.Max(along, 0.0));
            return new PlanPoint(x, z);
        }
    }
}
