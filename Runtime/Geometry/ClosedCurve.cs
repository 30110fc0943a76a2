using System;
using System.Collections.Generic;

namespace Alate.Geometry
{
    /// <summary>
    /// An outline in plan, counterclockwise, resampled at even steps of its arc length, so that nothing depends on where the mesh has
    /// its vertices. Places on it are arc lengths of the outline, not of the slightly shorter line through the samples, and wrap round.
    /// </summary>
    internal sealed class ClosedCurve
    {
        private readonly PolygonGrid m_Grid;

        /// <param name="corners">At least three.</param>
        /// <param name="samples">How many.</param>
        public ClosedCurve(IReadOnlyList<PlanPoint> corners, int samples)
        {
            Length = Polyline.LengthOf(corners, true);
            Step = Length / samples;
            Line = new Polyline(Polyline.Even(corners, samples, true), true);
            m_Grid = new PolygonGrid(Samples);
        }

        /// <summary>Closed line through the samples.</summary>
        public Polyline Line { get; }

        /// <summary>Points evenly round the curve; the first lies at 0.</summary>
        public IReadOnlyList<PlanPoint> Samples => Line.Points;

        /// <summary>Length once round.</summary>
        public double Length { get; }

        /// <summary>Arc length between two samples.</summary>
        public double Step { get; }

        /// <summary>The point at an arc length.</summary>
        public PlanPoint At(double s)
        {
            double wrapped = s - Length * Math.Floor(s / Length), at = wrapped < Length ? wrapped / Step : 0.0;
            int before = Math.Min((int)at, Samples.Count - 1);
            return Line.Between(before, at - before);
        }

        /// <summary>Returns true where p lies inside.</summary>
        public bool Contains(PlanPoint p) => m_Grid.Contains(p);

        /// <summary>The arc length closest to p.</summary>
        public double Nearest(PlanPoint p)
        {
            int segment = Line.NearestSegment(p, out double share);
            return (segment + share) * Step;
        }
    }
}
