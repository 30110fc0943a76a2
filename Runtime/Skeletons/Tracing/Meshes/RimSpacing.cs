using System;

namespace Alate
{
    /// <summary>How far apart the vertices along an outline may lie: an even distance, but less where the wing is narrow.</summary>
    internal sealed class RimSpacing
    {
        /// <summary>Steps in which the outline is looked at, in an even distance, and their most.</summary>
        private const int k_StepsInSpacing = 4, k_MostSteps = 6000;

        /// <summary>Least spacing over the even one.</summary>
        private const double k_Narrowest = 0.2;

        /// <summary>Spacing over the width of the wing where that is less.</summary>
        private const double k_OverWidth = 0.9;

        /// <summary>How fast the spacing may change along the outline.</summary>
        private const double k_Growth = 0.4;

        /// <summary>The other side counts as across only where it faces this one: the cosine of the angle between them.</summary>
        private const double k_Facing = -0.7;

        private readonly PlanPoint[] m_Outline;
        private readonly double[] m_Lengths;
        private readonly double[] m_Spacing;
        private readonly double m_Step;

        /// <param name="outline">Counterclockwise.</param>
        /// <param name="even">Spacing where the wing is wide.</param>
        public RimSpacing(PlanPoint[] outline, double even)
        {
            m_Outline = outline;
            m_Lengths = new double[outline.Length + 1];
            for (int k = 0; k < outline.Length; k++)
                m_Lengths[k + 1] = m_Lengths[k] + Math.Sqrt((outline[(k + 1) % outline.Length] - outline[k]).LengthSquared);
            int steps = Math.Min(k_MostSteps, Math.Max(16, (int)(k_StepsInSpacing * Length / even)));
            m_Step = Length / steps;
            m_Spacing = new double[steps];
            for (int k = 0; k < steps; k++)
                m_Spacing[k] = Math.Max(k_Narrowest * even, Math.Min(even, k_OverWidth * WidthAt((k + 0.5) * m_Step)));
            LimitGrowth();
        }

        /// <summary>Length of the outline.</summary>
        public double Length => m_Lengths[m_Outline.Length];

        /// <summary>Distance along the outline of one of its points.</summary>
        public double DistanceTo(int point) => m_Lengths[point];

        /// <summary>The place at a distance along the outline, from 0 to its length.</summary>
        public PlanPoint At(double distance)
        {
            int found = Array.BinarySearch(m_Lengths, distance);
            int segment = Math.Min(m_Outline.Length - 1, Math.Max(0, found >= 0 ? found : ~found - 1));
            PlanPoint a = m_Outline[segment], b = m_Outline[(segment + 1) % m_Outline.Length];
            return a + (b - a) * ((distance - m_Lengths[segment]) / Math.Max(m_Lengths[segment + 1] - m_Lengths[segment], double.Epsilon));
        }

        /// <summary>How many spacings lie between two distances, the second of which may be beyond the end and begin again.</summary>
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

        /// <summary>The distance that lies that many spacings behind another.</summary>
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
            int found = Array.BinarySearch(m_Lengths, distance);
            int segment = Math.Min(m_Outline.Length - 1, Math.Max(0, found >= 0 ? found : ~found - 1));
            PlanPoint from = At(distance), along = Direction(segment), inward = new PlanPoint(-along.z, along.x);
            double width = double.MaxValue;
            for (int k = 0; k < m_Outline.Length; k++)
            {
                PlanPoint a = m_Outline[k] - from, b = m_Outline[(k + 1) % m_Outline.Length] - from;
                double sideA = PlanPoint.Cross(inward, a), sideB = PlanPoint.Cross(inward, b);
                if (k == segment || sideA > 0.0 == sideB > 0.0)
                    continue;
                double reach = PlanPoint.Dot(inward, a + (b - a) * (sideA / (sideA - sideB)));
                if (reach > 0.0 && reach < width)
                    width = PlanPoint.Dot(along, Direction(k)) < k_Facing ? reach : width;
            }

            return width;
        }

        private PlanPoint Direction(int segment)
        {
            PlanPoint along = m_Outline[(segment + 1) % m_Outline.Length] - m_Outline[segment];
            return along * (1.0 / Math.Max(Math.Sqrt(along.LengthSquared), double.Epsilon));
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
