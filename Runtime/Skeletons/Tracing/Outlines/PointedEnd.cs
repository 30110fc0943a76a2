using System;
using System.Collections.Generic;

namespace Alate
{
    /// <summary>Guesses the hinge of a wing from its outline alone: of the two ends of its longest direction, the one that is more pointed.</summary>
    internal readonly struct PointedEnd
    {
        /// <summary>Confidence that it is the hinge where both ends are alike, and where one is far more pointed.</summary>
        private const double k_EvenConfidence = 0.25, k_PointedConfidence = 0.6;

        /// <summary>Rays by which the room around an end is measured, and their longest reach as a share of the outline's extent.</summary>
        private const int k_Rays = 72;
        private const double k_Reach = 0.25;

        private PointedEnd(PlanPoint place, double confidence)
        {
            Place = place;
            Confidence = confidence;
        }

        /// <summary>The end, on the outline.</summary>
        public PlanPoint Place { get; }

        /// <summary>That it is the hinge, 0 to 1.</summary>
        public double Confidence { get; }

        public static PointedEnd Of(PlanPoint[] outline)
        {
            PlanPoint along = Longest(outline);
            PlanPoint first = outline[0], last = outline[0];
            foreach (PlanPoint point in outline)
            {
                first = PlanPoint.Dot(point, along) < PlanPoint.Dot(first, along) ? point : first;
                last = PlanPoint.Dot(point, along) > PlanPoint.Dot(last, along) ? point : last;
            }

            var rim = new RimLine(outline);
            double reach = k_Reach * ClosedPath.Extent(outline), room = Room(rim, first, along, reach), other = Room(rim, last, along * -1.0, reach);
            double difference = Math.Abs(room - other) / Math.Max(room, other);
            return new PointedEnd(room <= other ? first : last, k_EvenConfidence + (k_PointedConfidence - k_EvenConfidence) * difference);
        }

        // Within a circle about an end: the mean square of how far one sees.
        private static double Room(RimLine rim, PlanPoint end, PlanPoint inward, double reach)
        {
            double sum = 0.0;
            PlanPoint from = end + inward * (1e-3 * reach);
            for (int k = 0; k < k_Rays; k++)
            {
                double angle = 2.0 * Math.PI * k / k_Rays, seen = Math.Min(reach, rim.Meet(from, new PlanPoint(Math.Cos(angle), Math.Sin(angle)), -1, out _));
                sum += seen * seen;
            }

            return sum;
        }

        // From the second moments of evenly spread places on the outline.
        private static PlanPoint Longest(PlanPoint[] outline)
        {
            const int places = 400;
            var rim = new RimLine(outline);
            var even = new List<PlanPoint>();
            PlanPoint centre = default;
            for (int k = 0; k < places; k++)
            {
                even.Add(rim.At(rim.Length * k / places));
                centre += even[k] * (1.0 / places);
            }

            double xx = 0.0, xz = 0.0, zz = 0.0;
            foreach (PlanPoint place in even)
            {
                PlanPoint p = place - centre;
                xx += p.x * p.x;
                xz += p.x * p.z;
                zz += p.z * p.z;
            }

            double angle = 0.5 * Math.Atan2(2.0 * xz, xx - zz);
            return new PlanPoint(Math.Cos(angle), Math.Sin(angle));
        }
    }
}
