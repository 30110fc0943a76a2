using System;

namespace Alate.Tests
{
    /// <summary>
    /// Outline of the monarch as measured by Kang and others (2020), millimetres, and what follows from it in double precision: apart from
    /// the package's own outline, mesher and skeleton generator.
    /// </summary>
    internal static class MonarchLandmarks
    {
        private static readonly double[] s_Span = { 0.0, 4.5, 9.0, 13.4, 17.9, 22.4, 26.9, 31.3, 35.8, 40.3, 44.8, 49.2, 53.7, 58.2, 61.0 };
        private static readonly double[] s_Leading = { 0.3, 2.3, 4.0, 5.3, 6.6, 7.7, 8.8, 9.7, 10.3, 10.7, 10.8, 10.8, 10.9, 9.6, 7.6 };
        private static readonly double[] s_Trailing = { -1.4, -4.6, -9.3, -14.4, -19.6, -24.7, -27.8, -25.4, -21.1, -16.1, -8.1, -4.6,
            -1.8, 2.2, 4.3 };

        /// <summary>Area of a grid with straight edges between its columns, wing lengths squared.</summary>
        public static double GridArea(int columns)
        {
            double sum = 0.0;
            for (int k = 0; k < columns; k++)
                sum += 0.5 * (Chord((double)k / columns) + Chord((k + 1.0) / columns)) / columns;
            return sum;
        }

        /// <summary>
        /// Middle of the middle chain of five, wing lengths: half-way from the middle of the base to the point that halves the margin
        /// between the tip's leading corner and the last chain's tip at 26.9 mm of span. The margin is measured in 400 even steps of span,
        /// as the package does, which cuts its corners by 5·10⁻⁶ of it.
        /// </summary>
        public static (double x, double z) MiddleJoint()
        {
            const int steps = 400;
            double length = s_Span[s_Span.Length - 1], tip = At(s_Leading, length) - At(s_Trailing, length), whole = tip;
            for (int k = 0; k < steps; k++)
                whole += Side(k, steps);
            double left = 0.5 * whole - tip;
            int at = 0;
            for (; left > Side(at, steps); at++)
                left -= Side(at, steps);
            double share = left / Side(at, steps), from = Span(at, steps), to = Span(at + 1, steps);
            double z = At(s_Trailing, from) + share * (At(s_Trailing, to) - At(s_Trailing, from)),
                root = 0.5 * (s_Leading[0] + s_Trailing[0]);
            return (0.5 * (from + share * (to - from)) / length, 0.5 * (root + z) / length);
        }

        private static double Span(int step, int steps) => 61.0 + (26.9 - 61.0) * step / steps;

        private static double Side(int step, int steps)
        {
            double from = Span(step, steps), to = Span(step + 1, steps), rise = At(s_Trailing, to) - At(s_Trailing, from);
            return Math.Sqrt((to - from) * (to - from) + rise * rise);
        }

        private static double Chord(double span)
        {
            double length = s_Span[s_Span.Length - 1];
            return (At(s_Leading, span * length) - At(s_Trailing, span * length)) / length;
        }

        private static double At(double[] edge, double span)
        {
            int k = 1;
            while (s_Span[k] < span && k + 1 < s_Span.Length)
                k++;
            return edge[k - 1] + (span - s_Span[k - 1]) / (s_Span[k] - s_Span[k - 1]) * (edge[k] - edge[k - 1]);
        }
    }
}
