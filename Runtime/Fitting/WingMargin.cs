using System;
using System.Collections.Generic;
using Alate.Geometry;

namespace Alate.Fitting
{
    /// <summary>
    /// The outer margin from the tip to the end of the last chain, with the share of the fan that lies before each of its points: mostly
    /// by length, as wings jointed by hand have it, a little by the angle about the base, so that a tail draws no more chains than its
    /// breadth asks.
    /// </summary>
    internal sealed class WingMargin
    {
        /// <summary>Weight of the length in the share.</summary>
        private const double k_LengthWeight = 0.9;

        private readonly WingLandmarks m_Marks;
        private readonly double[] m_Shares;
        private readonly double m_Turn;

        public WingMargin(WingLandmarks marks)
        {
            m_Marks = marks;
            Points = marks.Trimmed.Along(marks.Tip, marks.Last);
            int count = Points.Count;
            double[] turned = new double[count];
            double angle = 0.0, length = Polyline.LengthOf(Points), walked = 0.0;
            m_Shares = new double[count];
            for (int k = 1; k < count; k++)
            {
                angle += Angle(Points[k - 1], Points[k]);
                turned[k] = Math.Max(turned[k - 1], angle);
            }

            m_Turn = Math.Max(turned[count - 1], 1e-9);
            for (int k = 1; k < count; k++)
            {
                walked += Math.Sqrt((Points[k] - Points[k - 1]).LengthSquared);
                m_Shares[k] = (1.0 - k_LengthWeight) * turned[k] / m_Turn + k_LengthWeight * walked / length;
            }

            m_Shares[count - 1] = 1.0;
        }

        /// <summary>Points of the margin, from the tip.</summary>
        public List<PlanPoint> Points { get; }

        /// <summary>[point] From 0 to 1, rising.</summary>
        public IReadOnlyList<double> Shares => m_Shares;

        /// <summary>The share of the fan before an arc length of the outline.</summary>
        public double ShareAt(double s)
        {
            double at = (s - m_Marks.Tip) / (m_Marks.Last - m_Marks.Tip) * (m_Shares.Length - 1);
            int before = Math.Min(Math.Max((int)at, 0), m_Shares.Length - 2);
            return m_Shares[before] + (m_Shares[before + 1] - m_Shares[before]) * Math.Min(Math.Max(at - before, 0.0), 1.0);
        }

        /// <summary>The share before the ray from the base to the end of a tail.</summary>
        public double ShareTowards(PlanPoint end, in OutlineStretch tail)
        {
            PlanPoint root = m_Marks.Trimmed.At(0.5 * (tail.from + tail.to));
            double share = ShareAt(0.5 * (tail.from + tail.to)) + (1.0 - k_LengthWeight) * Angle(root, end) / m_Turn;
            return Math.Min(Math.Max(share, ShareAt(tail.from)), ShareAt(tail.to));
        }

        /// <summary>The point with a share of the fan before it.</summary>
        public PlanPoint At(double share)
        {
            int after = Array.BinarySearch(m_Shares, share);
            double at = after;
            if (after < 0)
            {
                after = Math.Min(Math.Max(~after, 1), m_Shares.Length - 1);
                at = after - 1 + (share - m_Shares[after - 1]) / (m_Shares[after] - m_Shares[after - 1]);
            }

            return m_Marks.Trimmed.At(m_Marks.Tip + (m_Marks.Last - m_Marks.Tip) * at / (m_Shares.Length - 1));
        }

        // Clockwise about the base.
        private double Angle(PlanPoint from, PlanPoint to)
        {
            PlanPoint a = from - m_Marks.Base, b = to - m_Marks.Base;
            return Elementary.Atan2(PlanPoint.Cross(b, a), PlanPoint.Dot(a, b));
        }
    }
}
