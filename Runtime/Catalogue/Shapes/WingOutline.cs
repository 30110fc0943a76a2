using System;
using System.Collections.Generic;
using Alate.Geometry;
using UnityEngine.Scripting.APIUpdating;

namespace Alate.Catalogue
{
    /// <summary>
    /// The contour of a right wing at rest, lying in the plane y = 0: a leading and a trailing edge over the span. Inside, lengths are in
    /// wing lengths; the origin lies on the hinge line at the wing base, X runs to the tip and Z forward.
    /// </summary>
    [MovedFrom(true, "Alate", "Alate")]
    public sealed class WingOutline
    {
        private const int k_CapPanels = 64, k_PinchSteps = 16;

        private readonly double[] m_Spans;
        private readonly MonotoneCurve m_Leading;
        private readonly MonotoneCurve m_Trailing;
        private readonly double m_CapStart;

        private WingOutline(double[] spans, MonotoneCurve leading, MonotoneCurve trailing, double capStart, double length)
        {
            m_Spans = spans;
            m_Leading = leading;
            m_Trailing = trailing;
            m_CapStart = capStart;
            Length = length;
        }

        /// <summary>L: the largest span coordinate, metres.</summary>
        public double Length { get; }

        /// <summary>The span coordinates of the landmarks, wing lengths, from 0 to 1, rising.</summary>
        public IReadOnlyList<double> LandmarkSpans => m_Spans;

        /// <summary>The foremost point ahead of the hinge line, wing lengths.</summary>
        public double Front => m_Leading.Largest;

        /// <summary>The rearmost point ahead of the hinge line, wing lengths; mostly negative.</summary>
        public double Rear => m_Trailing.Smallest;

        /// <summary>The area of the surface inside, square wing lengths.</summary>
        public double Area => MeasureArea();

        /// <summary>True where the tip ends in a point of a rounded cap, false where it ends in a straight edge.</summary>
        public bool HasRoundedTip => m_CapStart < 1;

        /// <summary>An outline with straight edges through landmarks in millimetres.</summary>
        /// <param name="span">Distance from the base along the span, rising from 0; its last value is the wing length.</param>
        /// <param name="leading">Leading edge ahead of the hinge line, one for each span.</param>
        /// <param name="trailing">Trailing edge ahead of the hinge line (so mostly negative), one for each span. The two edges may meet at
        /// the tip only.</param>
        /// <exception cref="ArgumentException">The three differ in length, hold fewer than two landmarks, or their order is
        /// broken.</exception>
        public static WingOutline FromMillimetres(double[] span, double[] leading, double[] trailing)
        {
            CheckLandmarks(span, leading, trailing);
            double length = span[span.Length - 1];
            return new WingOutline(
                Scaled(span, length),
                MonotoneCurve.Straight(Scaled(span, length), Scaled(leading, length)),
                MonotoneCurve.Straight(Scaled(span, length), Scaled(trailing, length)),
                1,
                length * 1e-3);
        }

        /// <summary>
        /// Outline through the landmarks by monotone cubics, its tip closed by an elliptic cap inside them, as long as the tip edge is
        /// wide. Wing length and the bounds of the landmarks are kept. Edges that would pinch the wing to less than half its straight chord
        /// between two landmarks stay straight.
        /// </summary>
        public WingOutline Smoothed()
        {
            int last = m_Spans.Length - 1;
            double tipEdge = m_Leading.ValueAtLandmark(last) - m_Trailing.ValueAtLandmark(last);
            double capStart = 1 - Math.Min(tipEdge, 0.25);
            var smooth = new WingOutline(m_Spans, m_Leading.Smoothed(), m_Trailing.Smoothed(), 1, Length);
            WingOutline edges = IsPinched(smooth) ? this : smooth;
            return new WingOutline(m_Spans, edges.m_Leading, edges.m_Trailing, capStart, Length);
        }

        /// <summary>The same shape at another wing length.</summary>
        /// <param name="length">Metres.</param>
        internal WingOutline At(double length) => new WingOutline(m_Spans, m_Leading, m_Trailing, m_CapStart, length);

        /// <summary>The leading edge ahead of the hinge line at a span from 0 to 1, wing lengths.</summary>
        public double LeadingAt(double span) => Capped(span, m_Leading.At(span));

        /// <summary>The trailing edge ahead of the hinge line at a span from 0 to 1, wing lengths.</summary>
        public double TrailingAt(double span) => Capped(span, m_Trailing.At(span));

        /// <summary>The chord at a span from 0 to 1, wing lengths.</summary>
        public double ChordAt(double span) => Math.Max(0, LeadingAt(span) - TrailingAt(span));

        private bool IsPinched(WingOutline smooth)
        {
            for (int i = 0; i + 1 < m_Spans.Length; i++)
            {
                for (int step = 1; step < k_PinchSteps; step++)
                {
                    double span = m_Spans[i] + (m_Spans[i + 1] - m_Spans[i]) * step / k_PinchSteps;
                    if (smooth.ChordAt(span) < 0.5 * ChordAt(span))
                        return true;
                }
            }

            return false;
        }

        private double Capped(double span, double edge)
        {
            if (span <= m_CapStart)
                return edge;

            double middle = 0.5 * (m_Leading.At(span) + m_Trailing.At(span));
            double into = Math.Min(1, (span - m_CapStart) / (1 - m_CapStart));
            return middle + (edge - middle) * Math.Sqrt(1 - into * into);
        }

        private double MeasureArea()
        {
            double area = 0.0;
            for (int i = 0; i + 1 < m_Spans.Length; i++)
            {
                double from = m_Spans[i];
                double to = m_Spans[i + 1];
                int panels = to > m_CapStart ? k_CapPanels : 1;
                for (int panel = 0; panel < panels; panel++)
                {
                    double start = from + (to - from) * panel / panels;
                    double end = from + (to - from) * (panel + 1) / panels;
                    area += (end - start) / 6 * (ChordAt(start) + 4 * ChordAt(0.5 * (start + end)) + ChordAt(end));
                }
            }

            return area;
        }

        private static double[] Scaled(double[] values, double length) => Array.ConvertAll(values, value => value / length);

        private static void CheckLandmarks(double[] span, double[] leading, double[] trailing)
        {
            if (span == null || leading == null || trailing == null)
                throw new ArgumentNullException(span == null ? nameof(span) : leading == null ? nameof(leading) : nameof(trailing));

            if (span.Length < 2 || span.Length != leading.Length || span.Length != trailing.Length)
            {
                throw new ArgumentException(
                    "An outline needs two or more landmarks, each with a span, a leading and a trailing edge; given "
                    + $"{span.Length}, {leading.Length}, {trailing.Length}.");
            }

            for (int i = 0; i < span.Length; i++)
            {
                bool isTip = i == span.Length - 1;
                bool rises = i == 0 ? span[i] == 0 : span[i] > span[i - 1];
                if (!rises || !double.IsFinite(leading[i]) || !double.IsFinite(trailing[i]) || !double.IsFinite(span[i])
                    || !(isTip ? leading[i] >= trailing[i] : leading[i] > trailing[i]))
                {
                    throw new ArgumentException(FormattableString.Invariant(
                        $"Landmark {i} (span {span[i]}, leading {leading[i]}, trailing {trailing[i]}) breaks the order: ")
                        + "span rises from 0, the leading edge lies ahead of the trailing edge.");
                }
            }
        }
    }
}
