using System;
using System.Collections.Generic;
using Alate.Geometry;

namespace Alate.Fitting
{
    /// <summary>
    /// A turned outline without its tails, which would draw the tip and the margin to themselves: where one sticks out, the trimmed
    /// outline runs straight across its root. Arc lengths are those of the full outline. Clefts are only noted.
    /// </summary>
    internal sealed class TrimmedOutline
    {
        private const int k_Places = 1200;

        /// <summary>Sharpness with which the end of a tail is found, per wing reach.</summary>
        private const double k_EndSharpness = 400.0;

        /// <summary>Widest root of a tail and widest mouth of a cleft, over the wing's mean chord.</summary>
        private const double k_Width = 0.25;

        /// <summary>Least way round a tail or a cleft over that width.</summary>
        private const double k_Slenderness = 3.5;

        /// <summary>Largest area of a tail or a cleft over the wing's.</summary>
        private const double k_Area = 0.12;

        private readonly List<OutlineStretch> m_Tails = new List<OutlineStretch>();
        private readonly List<OutlineStretch> m_Clefts = new List<OutlineStretch>();

        /// <param name="full">A turned outline.</param>
        /// <param name="from">Arc length behind the base; no tail reaches before it.</param>
        /// <param name="to">Arc length before the base; no tail reaches beyond it.</param>
        public TrimmedOutline(ClosedCurve full, double from, double to)
        {
            Full = full;
            FindNarrow(from, to);
        }

        public ClosedCurve Full { get; }

        /// <summary>Narrow stretches that stick out: tails, spikes and the ends of pointed tips.</summary>
        public IReadOnlyList<OutlineStretch> Tails => m_Tails;

        /// <summary>Narrow stretches that reach in.</summary>
        public IReadOnlyList<OutlineStretch> Clefts => m_Clefts;

        /// <summary>The point at an arc length; across the root of a tail that has it.</summary>
        public PlanPoint At(double s)
        {
            if (!TryFindTail(s, out OutlineStretch tail))
                return Full.At(s);
            PlanPoint from = Full.At(tail.from), to = Full.At(tail.to);
            return from + (to - from) * ((s - tail.from) / (tail.to - tail.from));
        }

        /// <summary>Finds the tail on which an arc length lies, if any.</summary>
        public bool TryFindTail(double s, out OutlineStretch tail)
        {
            int index = m_Tails.FindIndex(stretch => stretch.Contains(s));
            tail = index >= 0 ? m_Tails[index] : default;
            return index >= 0;
        }

        /// <summary>The end of a tail: its place farthest from its root.</summary>
        public PlanPoint EndOf(in OutlineStretch tail)
        {
            PlanPoint root = (Full.At(tail.from) + Full.At(tail.to)) * 0.5;
            double end = SoftMaximum.Find(
                tail.from, tail.to, k_Places, k_EndSharpness, s => Math.Sqrt((Full.At(s) - root).LengthSquared), out _);
            return Full.At(end);
        }

        /// <summary>Cuts off one more tail, with all that lies on it.</summary>
        public void Cut(OutlineStretch tail)
        {
            Restore(tail);
            m_Tails.Add(tail);
        }

        /// <summary>Restores a cut stretch, with all that lies on it.</summary>
        public void Restore(OutlineStretch stretch)
        {
            m_Tails.RemoveAll(other => other.Overlaps(stretch));
            m_Clefts.RemoveAll(other => other.Overlaps(stretch));
        }

        /// <summary>Stretch of the outline between two arc lengths, both ends included.</summary>
        public List<PlanPoint> Along(double from, double to)
        {
            int steps = Math.Max(1, (int)Math.Ceiling((to - from) / Full.Step));
            var path = new List<PlanPoint>(steps + 1);
            for (int k = 0; k <= steps; k++)
                path.Add(At(from + (to - from) * k / steps));
            return path;
        }

        // Stretches whose ends lie close together: the longest first, none within another.
        private void FindNarrow(double from, double to)
        {
            var points = new PlanPoint[k_Places + 1];
            for (int k = 0; k <= k_Places; k++)
                points[k] = Full.At(from + (to - from) * k / k_Places);
            double area = -Polygon.Area(points), step = (to - from) / k_Places, widest = k_Width * area;
            for (int length = k_Places / 2; length > 1; length--)
            {
                double most = Math.Min(widest, length * step / k_Slenderness);
                for (int first = 0; first + length <= k_Places; first++)
                {
                    if ((points[first + length] - points[first]).LengthSquared > most * most)
                        continue;
                    var stretch = new OutlineStretch(from + first * step, from + (first + length) * step);
                    if (IsTaken(stretch))
                        continue;
                    double share = -Polygon.Area(new ArraySegment<PlanPoint>(points, first, length + 1)) / area;
                    if (Math.Abs(share) < k_Area)
                        (share > 0.0 ? m_Tails : m_Clefts).Add(stretch);
                }
            }
        }

        private bool IsTaken(OutlineStretch stretch) =>
            m_Tails.Exists(other => other.Overlaps(stretch)) || m_Clefts.Exists(other => other.Overlaps(stretch));
    }
}
