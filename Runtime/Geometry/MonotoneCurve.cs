using System;
using System.Linq;

namespace Alate.Geometry
{
    /// <summary>
    /// One edge of a wing as a function of span: straight between its landmarks, or the monotone cubic of Fritsch and Carlson (1980)
    /// through them, which nowhere leaves the band between two neighbouring landmarks.
    /// </summary>
    internal sealed class MonotoneCurve
    {
        private readonly double[] m_Spans;
        private readonly double[] m_Values;
        private readonly double[] m_Slopes;

        private MonotoneCurve(double[] spans, double[] values, double[] slopes)
        {
            m_Spans = spans;
            m_Values = values;
            m_Slopes = slopes;
        }

        public double Largest => m_Values.Max();

        public double Smallest => m_Values.Min();

        public static MonotoneCurve Straight(double[] spans, double[] values) => new MonotoneCurve(spans, values, null);

        public MonotoneCurve Smoothed() => new MonotoneCurve(m_Spans, m_Values, MonotoneSlopes(m_Spans, m_Values));

        public double ValueAtLandmark(int landmark) => m_Values[landmark];

        public double At(double span)
        {
            int interval = IntervalOf(span);
            double width = m_Spans[interval + 1] - m_Spans[interval];
            double t = Math.Clamp((span - m_Spans[interval]) / width, 0.0, 1.0);
            double rise = m_Values[interval + 1] - m_Values[interval];
            if (m_Slopes == null)
                return m_Values[interval] + t * rise;

            double first = m_Slopes[interval] * width;
            double second = m_Slopes[interval + 1] * width;
            return m_Values[interval] + t * (first + t * (3 * rise - 2 * first - second + t * (first + second - 2 * rise)));
        }

        private int IntervalOf(double span)
        {
            int found = Array.BinarySearch(m_Spans, span);
            int interval = found >= 0 ? found : ~found - 1;
            return Math.Clamp(interval, 0, m_Spans.Length - 2);
        }

        private static double[] MonotoneSlopes(double[] spans, double[] values)
        {
            int last = spans.Length - 1;
            double[] secants = new double[last];
            for (int i = 0; i < last; i++)
                secants[i] = (values[i + 1] - values[i]) / (spans[i + 1] - spans[i]);

            double[] slopes = new double[last + 1];
            slopes[0] = secants[0];
            slopes[last] = secants[last - 1];
            for (int i = 1; i < last; i++)
                slopes[i] = secants[i - 1] * secants[i] > 0 ? 0.5 * (secants[i - 1] + secants[i]) : 0;

            for (int i = 0; i < last; i++)
                LimitToMonotone(secants[i], ref slopes[i], ref slopes[i + 1]);

            return slopes;
        }

        private static void LimitToMonotone(double secant, ref double first, ref double second)
        {
            // Beside a level stretch the slopes are 0 already.
            if (secant == 0)
                return;

            double a = first / secant;
            double b = second / secant;
            double excess = a * a + b * b;
            if (excess > 9)
            {
                double scale = 3 / Math.Sqrt(excess);
                first = scale * a * secant;
                second = scale * b * secant;
            }
        }
    }
}
