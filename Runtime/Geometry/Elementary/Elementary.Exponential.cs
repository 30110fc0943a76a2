using Unity.Mathematics;

namespace Alate.Geometry
{
    internal static partial class Elementary
    {
        /// <summary>Arguments beyond which the exponential is infinite or 0.</summary>
        private const double k_LargestExponent = 709.782712893384, k_SmallestExponent = -745.2;

        private const double k_SmallestNormal = 2.2250738585072014e-308, k_TwoTo54 = 18014398509481984.0;
        private const int k_RaisedBy = 54;

        private const double k_InverseOfLn2 = 1.4426950408889634;

        /// <summary>ln 2 in two parts of 42 bits, so that multiples of the first by whole numbers up to two thousand are exact.</summary>
        private const double k_Ln2 = 0.6931471805598903, k_Ln2Rest = 5.49792301870721e-14;

        private const double k_RootOfHalf = 0.7071067811865476;

        /// <summary>e to a power; within 1.5 units in the last place.</summary>
        public static double Exp(double power)
        {
            if (!(power <= k_LargestExponent))
                return math.isnan(power) ? power : double.PositiveInfinity;
            if (power < k_SmallestExponent)
                return 0.0;
            double n = math.floor(power * k_InverseOfLn2 + 0.5);
            double first = power - n * k_Ln2, second = n * k_Ln2Rest;
            double r = first - second, low = (first - r) - second;
            double p = 0.5 + r * (0.16666666666666685 + r * (0.04166666666666673 + r * (0.00833333333331662
                + r * (0.0013888888888858287 + r * (0.0001984126989735992 + r * (2.480158737401126e-05 + r * (2.7557233931232947e-06
                + r * (2.7557233151104744e-07 + r * (2.5112347919589596e-08 + r * 2.0927002289566424e-09)))))))));
            double value = 1.0 + (r + (r * r * p + low * (1.0 + r)));
            // In two steps: neither factor overflows, and a result below the normal numbers is rounded once.
            int whole = (int)n, half = whole / 2;
            return value * PowerOfTwo(half) * PowerOfTwo(whole - half);
        }

        /// <summary>Natural logarithm; within 1.5 units in the last place; −∞ at 0, not a number below.</summary>
        public static double Log(double x)
        {
            if (!(x > 0.0))
                return x == 0.0 ? double.NegativeInfinity : double.NaN;
            if (math.isinf(x))
                return x;
            bool isSmall = x < k_SmallestNormal;
            long bits = math.aslong(isSmall ? x * k_TwoTo54 : x);
            long powers = (bits - math.aslong(k_RootOfHalf)) >> 52;
            double n = powers - (isSmall ? k_RaisedBy : 0);
            double f = math.asdouble(bits - (powers << 52)) - 1.0, s = f / (2.0 + f), z = s * s, half = 0.5 * f * f;
            double r = z * (0.6666666666666734 + z * (0.3999999999941642 + z * (0.28571428742112537 + z * (0.22222198593445988
                + z * (0.18183563586447524 + z * (0.15314063066448955 + z * 0.14795877772098265))))));
            return n * k_Ln2 - ((half - (s * (half + r) + n * k_Ln2Rest)) - f);
        }

        /// <summary>
        /// A number to a power, of x above 0 within 1 + 2 |y ln x| units in the last place; of a negative number to whole powers only.
        /// </summary>
        public static double Pow(double x, double y)
        {
            if (y == 0.0 || x == 1.0)
                return 1.0;
            double size = Exp(y * Log(math.abs(x)));
            if (x >= 0.0)
                return size;
            if (math.floor(y) != y)
                return double.NaN;
            return math.floor(0.5 * y) != 0.5 * y ? -size : size;
        }

        private static double PowerOfTwo(int exponent) => math.asdouble((long)(exponent + 1023) << 52);
    }
}
