using System;
using Alate.Geometry;

namespace Alate.Fitting
{
    /// <summary>The narrower of the two ends of an outline along its longest direction.</summary>
    internal sealed class NarrowEnd
    {
        /// <summary>Distance from the ends at which widths are compared, as a share of the length.</summary>
        private const double k_Inset = 0.15;

        /// <summary>Confidence that the narrower end is the base: where both are equally wide, and where one comes to a point.</summary>
        private const double k_EvenConfidence = 0.6;
        private const double k_PointedConfidence = 0.98;

        /// <summary>Difference of the widths, over the larger, at which one end counts as a point.</summary>
        private const double k_ClearDifference = 0.6;

        private readonly ClosedCurve m_Outline;
        private readonly PlanPoint m_Along;
        private readonly double m_Low = double.MaxValue;
        private readonly double m_High = double.MinValue;

        public NarrowEnd(ClosedCurve outline, PlanPoint centre)
        {
            m_Outline = outline;
            m_Along = Polygon.LongestDirection(outline.Samples, centre);
            int first = 0, last = 0;
            for (int k = 0; k < outline.Samples.Count; k++)
            {
                double at = PlanPoint.Dot(outline.Samples[k], m_Along);
                if (at < m_Low)
                {
                    m_Low = at;
                    first = k;
                }

                if (at > m_High)
                {
                    m_High = at;
                    last = k;
                }
            }

            double low = Width(m_Low + k_Inset * (m_High - m_Low)), high = Width(m_High - k_Inset * (m_High - m_Low));
            Place = (low <= high ? first : last) * outline.Step;
            Confidence = k_EvenConfidence
                + (k_PointedConfidence - k_EvenConfidence) * Math.Min(1.0, Math.Abs(low - high) / Math.Max(low, high) / k_ClearDifference);
        }

        /// <summary>Arc length of the end.</summary>
        public double Place { get; }

        /// <summary>Confidence that this end is the base, 0 to 1.</summary>
        public double Confidence { get; }

        // Between the outermost crossings of the line at right angles.
        private double Width(double at)
        {
            var across = new PlanPoint(-m_Along.z, m_Along.x);
            double low = double.MaxValue, high = double.MinValue;
            int count = m_Outline.Samples.Count;
            for (int k = 0; k < count; k++)
            {
                PlanPoint from = m_Outline.Samples[k], to = m_Outline.Samples[(k + 1) % count];
                double before = PlanPoint.Dot(from, m_Along) - at, after = PlanPoint.Dot(to, m_Along) - at;
                if (before > 0.0 == after > 0.0)
                    continue;
                double z = PlanPoint.Dot(from + (to - from) * (before / (before - after)), across);
                low = Math.Min(low, z);
                high = Math.Max(high, z);
            }

            return high - low;
        }
    }
}
