using System;
using System.Collections.Generic;

namespace Alate
{
    /// <summary>
    /// The outer margin from the tip to the end of the last chain, with the share of the fan that lies before each of its points: mostly
    /// by the angle about the base, so that neither tails nor clefts draw more chains than their breadth asks, a little by length.
    /// </summary>
    internal sealed class WingMargin
    {
        /// <summary>Weight of the length in the share.</summary>
        private const double k_LengthWeight = 0.15;

        private readonly double[] m_Shares;

        public WingMargin(ClosedCurve outline, WingLandmarks marks)
        {
            Points = OpenPath.Along(outline, marks.Tip, marks.Last);
            int count = Points.Count;
            var turned = new double[count];
            double angle = 0.0, length = OpenPath.Length(Points), walked = 0.0;
            m_Shares = new double[count];
            for (int k = 1; k < count; k++)
            {
                PlanPoint before = Points[k - 1] - marks.Base, at = Points[k] - marks.Base;
                angle += Math.Atan2(PlanPoint.Cross(at, before), PlanPoint.Dot(at, before));
                turned[k] = Math.Max(turned[k - 1], angle);
            }

            double whole = Math.Max(turned[count - 1], 1e-9);
            for (int k = 1; k < count; k++)
            {
                walked += Math.Sqrt((Points[k] - Points[k - 1]).LengthSquared);
                m_Shares[k] = (1.0 - k_LengthWeight) * turned[k] / whole + k_LengthWeight * walked / length;
            }

            m_Shares[count - 1] = 1.0;
        }

        /// <summary>From the tip.</summary>
        public List<PlanPoint> Points { get; }

        /// <summary>[point] From 0 to 1, rising.</summary>
        public IReadOnlyList<double> Shares => m_Shares;

        /// <summary>The point with a share of the fan before it.</summary>
        public PlanPoint At(double share)
        {
            int after = Array.BinarySearch(m_Shares, share);
            if (after >= 0)
                return Points[after];
            after = Math.Min(Math.Max(~after, 1), m_Shares.Length - 1);
            double rise = m_Shares[after] - m_Shares[after - 1];
            return Points[after - 1] + (Points[after] - Points[after - 1]) * ((share - m_Shares[after - 1]) / rise);
        }
    }
}
