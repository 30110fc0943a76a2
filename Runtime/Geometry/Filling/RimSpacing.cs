using System;

namespace Alate.Geometry
{
    /// <summary>Distance between the vertices along an outline: even, but less where the wing is narrow.</summary>
    internal sealed class RimSpacing
    {
        /// <summary>Number of steps in an even distance in which the outline is looked at, and most steps.</summary>
        private const int k_StepsInSpacing = 4, k_MostSteps = 6000;

        /// <summary>Least spacing over the even one.</summary>
        private const double k_Narrowest = 0.2;

        /// <summary>Spacing over the width of the wing where that is less.</summary>
        private const double k_OverWidth = 0.9;

        /// <summary>Largest change of the spacing per distance along the outline.</summary>
        private const double k_Growth = 0.4;

        /// <summary>Cosine of the angle between two sides beyond which they count as facing each other.</summary>
        private const double k_Facing = -0.7;

        private readonly Polyline m_Rim;
        private readonly double[] m_Spacing;
        private readonly double m_Step;

        /// <param name="rim">Counterclockwise.</param>
        /// <param name="even">Spacing where the wing is wide.</param>
        public RimSpacing(Polyline rim, double even)
        {
            m_Rim = rim;
            int steps = Math.Min(k_MostSteps, Math.Max(16, (int)(k_StepsInSpacing * rim.Length / even)));
            m_Step = rim.Length / steps;
            m_Spacing = new double[steps];
            for (int k = 0; k < steps; k++)
                m_Spacing[k] = Math.Max(k_Narrowest * even, Math.Min(even, k_OverWidth * WidthAt((k + 0.5) * m_Step)));
            LimitGrowth();
        }

        /// <summary>Number of spacings between two distances, the second of which may lie beyond the end and wrap round.</summary>
        public double Count(double from, double to)
        {
            double count = 0.0;
            for (double at = from; at < to;)
            {
                double next = Math.Min(to, (Math.Floor(at / m_Step + 1e-9) + 1.0) * m_Step);
                count += (next - at) / SpacingAt(at);
                at = next;
            }

            return count;
        }

        /// <summary>Distance that lies a number of spacings behind another.</summary>
        public double Advance(double from, double spacings)
        {
            for (double at = from; ;)
            {
                double next = (Math.Floor(at / m_Step + 1e-9) + 1.0) * m_Step, count = (next - at) / SpacingAt(at);
                if (count >= spacings)
                    return at + spacings * SpacingAt(at);
                spacings -= count;
                at = next;
            }
        }

        private double SpacingAt(double distance) => m_Spacing[(int)Math.Floor(distance / m_Step + 1e-9) % m_Spacing.Length];

        private double WidthAt(double distance)
        {
            int segment = m_Rim.SegmentAt(distance);
            PlanPoint along = m_Rim.Direction(segment);
            double reach = m_Rim.RayDistance(m_Rim.At(distance), new PlanPoint(-along.z, along.x), segment, out int met);
            return met >= 0 && PlanPoint.Dot(along, m_Rim.Direction(met)) < k_Facing ? reach : double.MaxValue;
        }

        private void LimitGrowth()
        {
            int count = m_Spacing.Length;
            for (int k = 0; k < 2 * count; k++)
                m_Spacing[(k + 1) % count] = Math.Min(m_Spacing[(k + 1) % count], m_Spacing[k % count] + k_Growth * m_Step);
            for (int k = 2 * count; k > 0; k--)
                m_Spacing[(k - 1) % count] = Math.Min(m_Spacing[(k - 1) % count], m_Spacing[k % count] + k_Growth * m_Step);
        }
    }
}
