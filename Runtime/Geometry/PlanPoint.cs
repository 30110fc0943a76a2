using System;

namespace Alate.Geometry
{
    /// <summary>A point or vector in the plan of a wing, seen from above: x along the span, z across it.</summary>
    internal readonly struct PlanPoint
    {
        public readonly double x;
        public readonly double z;

        public PlanPoint(double x, double z)
        {
            this.x = x;
            this.z = z;
        }

        public double LengthSquared => x * x + z * z;

        public static PlanPoint operator +(PlanPoint a, PlanPoint b) => new PlanPoint(a.x + b.x, a.z + b.z);

        public static PlanPoint operator -(PlanPoint a, PlanPoint b) => new PlanPoint(a.x - b.x, a.z - b.z);

        public static PlanPoint operator *(PlanPoint a, double s) => new PlanPoint(a.x * s, a.z * s);

        /// <summary>Direction of a vector, 1 long.</summary>
        public static PlanPoint Unit(PlanPoint v) => v * (1.0 / Math.Max(1e-12, Math.Sqrt(v.LengthSquared)));

        public static double Dot(PlanPoint a, PlanPoint b) => a.x * b.x + a.z * b.z;

        /// <summary>Twice the signed area of the triangle 0, a, b.</summary>
        public static double Cross(PlanPoint a, PlanPoint b) => a.x * b.z - a.z * b.x;

        /// <summary>Returns true where the segments a–b and c–d cross.</summary>
        public static bool SegmentsCross(PlanPoint a, PlanPoint b, PlanPoint c, PlanPoint d) =>
            Cross(b - a, c - a) > 0.0 != Cross(b - a, d - a) > 0.0 && Cross(d - c, a - c) > 0.0 != Cross(d - c, b - c) > 0.0;

        /// <summary>Share of the segment a–b, in [0, 1], at which its point closest to p lies; ½ when the segment is a point.</summary>
        public static double ClosestOnSegment(PlanPoint p, PlanPoint a, PlanPoint b)
        {
            PlanPoint along = b - a;
            double length = along.LengthSquared;
            return length > 0.0 ? Math.Min(Math.Max(Dot(p - a, along) / length, 0.0), 1.0) : 0.5;
        }

        /// <summary>Squared distance of p from the segment a–b.</summary>
        public static double DistanceSquared(PlanPoint p, PlanPoint a, PlanPoint b) =>
            (a + (b - a) * ClosestOnSegment(p, a, b) - p).LengthSquared;
    }
}
