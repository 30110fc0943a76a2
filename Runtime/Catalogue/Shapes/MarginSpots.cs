using System;

namespace Alate.Catalogue
{
    /// <summary>Places along a margin half way between the ends of neighbouring veins, for a spot in each cell.</summary>
    internal sealed class MarginSpots
    {
        private readonly double[] m_Middles;

        /// <param name="margin">The margin.</param>
        /// <param name="tips">Ends of the veins in their order, x, z, x, z, …; two or more.</param>
        public MarginSpots(StrokeSet margin, double[] tips)
        {
            m_Middles = new double[tips.Length / 2 - 1];
            margin.Distance(tips[0], tips[1], out double before);
            for (int k = 0; k < m_Middles.Length; k++)
            {
                margin.Distance(tips[2 * k + 2], tips[2 * k + 3], out double next);
                m_Middles[k] = 0.5 * (before + next);
                before = next;
            }
        }

        /// <summary>Share of the spots at a place.</summary>
        /// <param name="along">Where along the margin.</param>
        /// <param name="edge">Distance from it.</param>
        /// <param name="depth">Of the middles of the spots below the margin.</param>
        /// <param name="radiusAlong">Half their length.</param>
        /// <param name="radiusAcross">Half their width.</param>
        /// <param name="softness">Width of their edges.</param>
        public float At(double along, double edge, double depth, double radiusAlong, double radiusAcross, double softness)
        {
            float inside = 0f;
            foreach (double middle in m_Middles)
                inside = Math.Max(inside, Ink.Ellipse(along - middle, edge - depth, radiusAlong, radiusAcross, softness));
            return inside;
        }
    }
}
