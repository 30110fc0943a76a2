using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace Alate.Geometry
{
    /// <summary>
    /// Elementary functions by sums, products, quotients and roots alone, which every processor rounds alike; those of the systems'
    /// libraries differ in their last bits.
    /// Angles in radians. The polynomials were fitted for this class by Remez' exchange, to less than a quarter of the last bit.
    /// </summary>
    internal static partial class Elementary
    {
        /// <summary>
        /// Angle up to which multiples of a quarter turn are subtracted without rounding, radians; larger ones lose whole turns first.
        /// </summary>
        private const double k_LargestExact = 1e6;

        private const double k_TwoOverPi = 0.6366197723675814, k_TwoPi = 6.283185307179586;

        /// <summary>A quarter turn in three parts; the first two have 33 bits, so that their multiples up to a million are exact.</summary>
        private const double k_Quarter0 = 1.5707963267341256, k_Quarter1 = 6.077100506303966e-11, k_Quarter2 = 2.0222662487959506e-21;

        /// <summary>π/4, π/2 and π, and what their rounding leaves out.</summary>
        private const double k_EighthTurn = 0.7853981633974483, k_EighthTurnRest = 3.061616997868383e-17;
        private const double k_QuarterTurn = 1.5707963267948966, k_QuarterTurnRest = 6.123233995736766e-17;
        private const double k_HalfTurn = 3.141592653589793, k_HalfTurnRest = 1.2246467991473532e-16;

        private const double k_TangentOfSixteenthTurn = 0.41421356237309503;

        /// <summary>
        /// Size above which the arguments of <see cref="Atan2(double, double)"/> are scaled, so that their sum is finite.
        /// </summary>
        private const double k_Huge = 1e300, k_ToModest = 1e-20;

        /// <summary>
        /// Sine and cosine; within 1.5 units in the last place up to a million radians; beyond, those of an angle that differs by less than
        /// its own last bit.
        /// </summary>
        public static void SinCos(double angle, out double sin, out double cos)
        {
            if (math.abs(angle) > k_LargestExact)
                angle %= k_TwoPi;
            double n = math.floor(angle * k_TwoOverPi + 0.5);
            double first = angle - n * k_Quarter0, second = n * k_Quarter1, rest = first - second;
            double third = n * k_Quarter2 - ((first - rest) - second);
            double r = rest - third, low = (rest - r) - third;

            double z = r * r, half = 0.5 * z, most = 1.0 - half;
            double s = -0.16666666666666632 + z * (0.008333333333322486 + z * (-0.00019841269829853295
                + z * (2.7557313704993448e-06 + z * (-2.505075987233226e-08 + z * 1.5896885252118968e-10))));
            double c = 0.0416666666666666 + z * (-0.0013888888888874472 + z * (2.4801587289669077e-05
                + z * (-2.755731440003642e-07 + z * (2.0875729110046324e-09 + z * -1.1359923600635407e-11))));
            s = r + (r * z * s + low * most);
            c = most + (((1.0 - most) - half) + (z * z * c - r * low));

            Turn((int)n, s, c, out sin, out cos);
        }

        /// <summary>Sine.</summary>
        public static double Sin(double angle)
        {
            SinCos(angle, out double sin, out _);
            return sin;
        }

        /// <summary>Cosine.</summary>
        public static double Cos(double angle)
        {
            SinCos(angle, out _, out double cos);
            return cos;
        }

        /// <summary>Tangent.</summary>
        public static double Tan(double angle)
        {
            SinCos(angle, out double sin, out double cos);
            return sin / cos;
        }

        /// <summary>Angle of a vector above the x axis, −π to π, with the signs of zeros as the standard library has them.</summary>
        public static double Atan2(double y, double x)
        {
            if (math.isnan(x) || math.isnan(y))
                return x + y;
            double across = math.abs(x), up = math.abs(y);
            bool steep = up > across;
            double large = steep ? up : across, small = steep ? across : up;
            double angle = large == 0.0 ? 0.0 : Octant(small, large);
            bool behind = math.aslong(x) < 0;
            if (steep)
                angle = behind ? k_QuarterTurn + (angle + k_QuarterTurnRest) : k_QuarterTurn - (angle - k_QuarterTurnRest);
            else if (behind)
                angle = k_HalfTurn - (angle - k_HalfTurnRest);
            return math.aslong(y) < 0 ? -angle : angle;
        }

        /// <summary>Angle with a sine, −π/2 to π/2; not a number beyond ±1.</summary>
        public static double Asin(double sine) => Atan2(sine, math.sqrt((1.0 - sine) * (1.0 + sine)));

        /// <summary>Angle with a cosine, 0 to π; not a number beyond ±1.</summary>
        public static double Acos(double cosine) => 2.0 * Atan2(math.sqrt(1.0 - cosine), math.sqrt(1.0 + cosine));

        // Sine and cosine of an angle and so many quarter turns.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static void Turn(int quarters, double s, double c, out double sin, out double cos)
        {
            bool swapped = (quarters & 1) != 0;
            sin = swapped ? c : s;
            cos = swapped ? s : c;
            sin = (quarters & 2) != 0 ? -sin : sin;
            cos = ((quarters + 1) & 2) != 0 ? -cos : cos;
        }

        // The angle whose tangent is small over large, 0 to π/4.
        private static double Octant(double small, double large)
        {
            if (math.isinf(large))
                return math.isinf(small) ? k_EighthTurn : 0.0;
            double scale = large > k_Huge ? k_ToModest : 1.0;
            small *= scale;
            large *= scale;
            bool upper = small > k_TangentOfSixteenthTurn * large;
            double t = upper ? (small - large) / (small + large) : small / large;
            double z = t * t;
            double p = t * z * (-0.333333333333332 + z * (0.19999999999953819 + z * (-0.1428571428022437
                + z * (0.11111110785450777 + z * (-0.0909089784172586 + z * (0.0769206228545807 + z * (-0.0666313449630701
                + z * (0.05848159512950501 + z * (-0.05040722535937646 + z * (0.03810504070762359 + z * -0.017955670110116225))))))))));
            return upper ? k_EighthTurn + (t + (p + k_EighthTurnRest)) : t + p;
        }
    }
}
