using Unity.Mathematics;

namespace Alate.Geometry
{
    // In double precision with polynomials as long as a float needs, and rounded once: within 0.51 units in the last place.
    internal static partial class Elementary
    {
        /// <summary>Powers beyond which e to a power is no normal float.</summary>
        private const float k_OrdinaryExponent = 87f;

        /// <summary>Sine and cosine.</summary>
        public static void SinCos(float angle, out float sin, out float cos)
        {
            double a = angle, s, c;
            if (math.abs(a) <= k_LargestExact)
            {
                double n = math.floor(a * k_TwoOverPi + 0.5), r = a - n * k_Quarter0 - n * k_Quarter1, z = r * r;
                double sine = r + r * z
                    * (-0.16666666641609462 + z * (0.008333329383540157 + z * (-0.0001983933393202123 + z * 2.7183017846687054e-06)));
                double cosine = 1.0 - 0.5 * z
                    + z * z
                    * (0.04166666662279479 + z * (-0.0013888883750463835 + z * (2.4799519208811633e-05 + z * -2.721017001625523e-07)));
                Turn((int)n, sine, cosine, out s, out c);
            }
            else
            {
                SinCos(a, out s, out c);
            }

            sin = (float)s;
            cos = (float)c;
        }

        /// <summary>Sines and cosines of three angles.</summary>
        public static void SinCos(float3 angles, out float3 sin, out float3 cos)
        {
            SinCos(angles.x, out sin.x, out cos.x);
            SinCos(angles.y, out sin.y, out cos.y);
            SinCos(angles.z, out sin.z, out cos.z);
        }

        /// <summary>Sine.</summary>
        public static float Sin(float angle)
        {
            SinCos(angle, out float sin, out _);
            return sin;
        }

        /// <summary>Cosine.</summary>
        public static float Cos(float angle)
        {
            SinCos(angle, out _, out float cos);
            return cos;
        }

        /// <summary>Tangent.</summary>
        public static float Tan(float angle) => (float)Tan((double)angle);

        /// <summary>Angle of a vector above the x axis, −π to π.</summary>
        public static float Atan2(float y, float x) => (float)Atan2((double)y, (double)x);

        /// <summary>Angle with a sine, −π/2 to π/2; not a number beyond ±1.</summary>
        public static float Asin(float sine) => (float)Asin((double)sine);

        /// <summary>Angle with a cosine, 0 to π; not a number beyond ±1.</summary>
        public static float Acos(float cosine) => (float)Acos((double)cosine);

        /// <summary>e to a power.</summary>
        public static float Exp(float power)
        {
            if (!(math.abs(power) <= k_OrdinaryExponent))
                return (float)Exp((double)power);
            double n = math.floor(power * k_InverseOfLn2 + 0.5), r = power - n * k_Ln2;
            double p = 0.5000000078334953 + r * (0.16666666860621554 + r * (0.04166626848831685
                + r * (0.008333264362947073 + r * (0.001394617777963282 + r * 0.00019918388780843814))));
            return (float)((1.0 + (r + r * r * p)) * PowerOfTwo((int)n));
        }

        /// <summary>Natural logarithm; −∞ at 0, not a number below.</summary>
        public static float Log(float x) => (float)Log((double)x);

        /// <summary>A number to a power; of a negative number to whole powers only.</summary>
        public static float Pow(float x, float y) => (float)Pow((double)x, (double)y);
    }
}
