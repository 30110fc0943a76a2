using System;

namespace Alate.Samples
{
    /// <summary>Student's t distribution.</summary>
    internal static class StudentT
    {
        private const int k_MostTerms = 500;
        private const double k_Precision = 1e-15, k_Tiny = 1e-300;

        // Lanczos' approximation of the gamma function for g = 7: its error is below 1e-15.
        private const double k_LanczosG = 7;
        private static readonly double[] s_Lanczos =
        {
            0.99999999999980993, 676.5203681218851, -1259.1392167224028, 771.32342877765313,
            -176.61502916214059, 12.507343278686905, -0.13857109526572012,
            9.9843695780195716e-6, 1.5056327351493116e-7,
        };

        /// <summary>Probability of a value at least as far from 0 as t, on either side.</summary>
        /// <param name="t">Any number; ± infinity gives 0.</param>
        /// <param name="degreesOfFreedom">Above 0.</param>
        /// <exception cref="ArgumentOutOfRangeException">t is not a number, or there are no degrees of freedom.</exception>
        public static double TwoTailed(double t, double degreesOfFreedom)
        {
            if (double.IsNaN(t))
                throw new ArgumentOutOfRangeException(nameof(t), t, "Must be a number.");
            if (!(degreesOfFreedom > 0))
                throw new ArgumentOutOfRangeException(nameof(degreesOfFreedom), degreesOfFreedom, "Must be above 0.");
            return double.IsInfinity(t) ? 0 : IncompleteBeta(0.5 * degreesOfFreedom, 0.5, degreesOfFreedom / (degreesOfFreedom + t * t));
        }

        // The regularised incomplete beta function; its fraction converges fast below the mean, so the other side is taken from there.
        private static double IncompleteBeta(double a, double b, double x)
        {
            if (x <= 0 || x >= 1)
                return x <= 0 ? 0 : 1;
            if (x > (a + 1) / (a + b + 2))
                return 1 - IncompleteBeta(b, a, 1 - x);
            double front = Math.Exp(LogGamma(a + b) - LogGamma(a) - LogGamma(b) + a * Math.Log(x) + b * Math.Log(1 - x)) / a;
            return front / Fraction(a, b, x);
        }

        // The continued fraction 1 + d1/(1 + d2/(1 + …)) by Lentz' method.
        private static double Fraction(double a, double b, double x)
        {
            double value = 1, c = 1, d = 0;
            for (int k = 1; k <= k_MostTerms; k++)
            {
                double term = Term(a, b, x, k);
                d = 1 / NotZero(1 + term * d);
                c = NotZero(1 + term / c);
                value *= c * d;
                if (Math.Abs(c * d - 1) < k_Precision)
                    break;
            }

            return value;
        }

        private static double Term(double a, double b, double x, int k)
        {
            int m = k / 2;
            return k % 2 == 0
                ? m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m))
                : -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
        }

        private static double NotZero(double value) => Math.Abs(value) < k_Tiny ? k_Tiny : value;

        private static double LogGamma(double z)
        {
            if (z < 0.5)
                return Math.Log(Math.PI / Math.Sin(Math.PI * z)) - LogGamma(1 - z);
            double sum = s_Lanczos[0];
            for (int k = 1; k < s_Lanczos.Length; k++)
                sum += s_Lanczos[k] / (z - 1 + k);
            double shifted = z - 1 + k_LanczosG + 0.5;
            return 0.5 * Math.Log(2 * Math.PI) + (z - 0.5) * Math.Log(shifted) - shifted + Math.Log(sum);
        }
    }
}
