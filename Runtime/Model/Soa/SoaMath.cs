using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Elementary functions of four lanes without calls, tables or branches, by what every processor rounds alike; the polynomials are our
    /// own fits.
    /// </summary>
    internal static class SoaMath
    {
        /// <summary>1 where the argument is zero or positive, −1 where it is negative.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static float4 Sign(float4 a) => math.select(1f, -1f, a < 0f);

        /// <summary>1/a, and 0 where a is below 1e-12; for a ≥ 0.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static float4 SafeReciprocal(float4 a) => math.select(1f / math.max(a, 1e-12f), 0f, a < 1e-12f);

        /// <summary>
        /// Share of a value, 0 where less than 1e-9 is left: numbers that fade for ever end as the smallest that there are, with which
        /// processors take a hundred times as long.
        /// </summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static float4 Faded(float4 value, float4 kept)
        {
            float4 left = value * kept;
            return math.select(left, 0f, math.abs(left) < 1e-9f);
        }

        /// <summary>Share of each component, as <see cref="Faded(float4, float4)"/>.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static SoaFloat3 Faded(in SoaFloat3 value, float4 kept) =>
            new SoaFloat3(Faded(value.x, kept), Faded(value.y, kept), Faded(value.z, kept));

        /// <summary>smooth(x) = 3x² − 2x³ on [0, 1], held outside.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static float4 Smooth(float4 x)
        {
            x = math.min(math.max(x, 0f), 1f);
            return x * x * (3f - 2f * x);
        }

        /// <summary>
        /// Sine and cosine for |a| below about 100 radians, error below 2e-7: reduced by multiples of π/2 in three parts, then
        /// polynomials on ±π/4.
        /// </summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void SinCos(float4 a, out float4 sin, out float4 cos)
        {
            float4 n = math.floor(a * 0.63661977f + 0.5f);
            float4 r = a - n * 1.5703125f - n * 4.838109016418457e-4f - n * 1.5893254712295857e-8f;
            float4 r2 = r * r;
            float4 r4 = r2 * r2;
            float4 s = r + r * r2 * (-0.166666552f + r2 * 0.00833219197f + r4 * -0.000195187822f);
            float4 c = 1f + r2 * -0.5f + r4 * (0.0416666456f + r2 * -0.00138873013f + r4 * 2.44306739e-5f);

            float4 half = math.floor(n * 0.5f);
            float4 odd = n - 2f * half;
            float4 signSin = 1f - 2f * (half - 2f * math.floor(half * 0.5f));
            float4 signCos = signSin * (1f - 2f * odd);
            bool4 swap = odd > 0.5f;
            sin = signSin * math.select(s, c, swap);
            cos = signCos * math.select(c, s, swap);
        }

        /// <summary>The angle of (x ≥ 0, y ≥ 0) above the x axis, in [0, π/2]; 0 at the origin. Error below 3e-7.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static float4 QuadrantAngle(float4 y, float4 x)
        {
            bool4 steep = y > x;
            float4 large = math.max(math.select(x, y, steep), 1e-30f), small = math.select(y, x, steep);

            // atan on [0, 1] from atan on ±tan(π/8): atan(q) = π/4 + atan((q−1)/(q+1)) above tan(π/8).
            bool4 upper = small > 0.41421356f * large;
            float4 t = math.select(small, small - large, upper) / math.select(large, small + large, upper);
            float4 t2 = t * t;
            float4 p = t + t * t2 * (-0.333329558f + t2 * 0.199779436f + t2 * t2 * (-0.138800085f + t2 * 0.0806074962f));
            float4 angle = math.select(p, 0.78539816f + p, upper);
            return math.select(angle, 1.57079633f - angle, steep);
        }

        /// <summary>e to a power, within 2 units in the last place; infinite above 88.7, 0 below −104.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static float4 Exp(float4 power)
        {
            power = math.select(power, 89f, power > 89f);
            power = math.select(power, -104f, power < -104f);
            float4 n = math.floor(power * 1.44269504f + 0.5f);
            float4 r = power - n * 0.693115234375f - n * 3.19461833e-5f;
            float4 p = 0.5f + r * (0.166665182f + r * (0.0416662022f + r * (0.00836895406f + r * 0.00139506487f)));
            float4 half = math.floor(0.5f * n);
            return (1f + (r + r * r * p)) * PowerOfTwo(half) * PowerOfTwo(n - half);
        }

        /// <summary>Natural logarithm of normal numbers above 0, within 2 units in the last place.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static float4 Log(float4 x)
        {
            // Powers of two are counted from the root of a half, so that what is left lies about 1.
            const int rootOfHalf = 0x3f3504f3;
            int4 bits = math.asint(x), powers = (bits - rootOfHalf) >> 23;
            float4 n = powers, f = math.asfloat(bits - (powers << 23)) - 1f;
            float4 s = f / (2f + f), z = s * s, half = 0.5f * f * f;
            float4 r = z * (0.666667759f + z * (0.399775803f + z * 0.298709363f));
            return n * 0.693115234375f - ((half - (s * (half + r) + n * 3.19461833e-5f)) - f);
        }

        /// <summary>Normal numbers above 0 to a power, within 2 + 2 |y ln x| units in the last place; 0 of what is not above 0.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static float4 Pow(float4 x, float4 y) => math.select(Exp(y * Log(x)), 0f, x <= 0f);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static float4 PowerOfTwo(float4 exponent) => math.asfloat(((int4)exponent + 127) << 23);
    }
}
