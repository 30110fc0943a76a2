using System;
using System.Collections.Generic;

namespace Alate.Geometry
{
    /// <summary>
    /// An outline in plan, counterclockwise, resampled at even steps of its arc length, so that nothing depends on where the mesh has
    /// its vertices. Places on it are arc lengths, which wrap round.
    /// </summary>
    internal sealed class ClosedCurve
    {
        private readonly PlanPoint[] m_Samples;
        private readonly PolygonGrid m_Grid;

        /// <param name="corners">At least three.</param>
        /// <param name="samples">How many.</param>
        public ClosedCurve(IReadOnlyList<PlanPoint> corners, int samples)
        {
            Length = Polyline.LengthOf(corners, true);
            Step = Length / samples;
            m_Samples = Polyline.Even(corners, samples, true);
            m_Grid = new PolygonGrid(m_Samples);
        }

        /// <summary>Points evenly round the curve; the first lies at 0.</summary>
        public IReadOnlyList<PlanPoint> Samples => m_Samples;

        /// <summary>Length once round.</summary>
        public double Length { get; }

        /// <summary>Arc length between two samples.</summary>
        public double Step { get; }

        /// <summary>The point at an arc length.</summary>
        public PlanPoint At(double s)
        {
            double wrapped = s - Length * Math.Floor(s / Length), at = wrapped < Length ? wrapped / Step : 0.0;
            int before = Math.Min((int)at, m_Samples.Length - 1);
            PlanPoint from = m_Samples[before], to = m_Samples[(before + 1) % m_Samples.Length];
            return from + (to - from) * (at - before);
        }

        /// <summary>Returns true where p lies inside.</summary>
        public bool Contains(PlanPoint p) => m_Grid.Contains(p);

        /// <summary>The arc length closest to p.</summary>
        public double Nearest(PlanPoint p)
        {
            double least = double.MaxValue, reach = double.MaxValue, found = 0.0;
            for (int k = 0; k < m_Samples.Length; k++)
            {
                PlanPoint from = m_Samples[k];
                if ((from - p).LengthSquared >= reach)
                    continue;
                PlanPoint to = m_Samples[(k + 1) % m_Samples.Length];
                double share = PlanPoint.ClosestOnSegment(p, from, to);
                double distance = (from + (to - from) * share - p).LengthSquared;
                if (distance >= least)
                    continue;
                least = distance;
                reach = (Math.Sqrt(least) + Step) * (Math.Sqrt(least) + Step);
                found = (k + share) * Step;
            }

            return found;
        }
    }
}
