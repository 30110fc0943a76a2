using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>Elementary functions of four lanes without calls, tables or branches.</summary>
    internal static class SoaMath
    {
        /// <summary>1 where the argument is zero or positive, −1 where it is negative.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static float4 Sign(float4 a) => math.select(1f, -1f, a < 0f);

        /// <summary>1/a, and 0 where a is below 1e-12; for a ≥ 0.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static float4 SafeReciprocal(float4 a) => math.select(1f / math.max(a, 1e-12f), 0f, a < 1e-12f);

        /// <summary>smooth(x) = 3x² − 2x³ on [0, 1], held outside.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static float4 Smooth(float4 x)
        {
            x = math.min(math.max(x, 0f), 1f);
            return x * x * (3f - 2f * x);
        }

        /// <summary>
        /// Sine and cosine for |a| below about 100 radians, error below 2e-7: reduced by multiples of π/2 in three parts, then
        /// minimax polynomials on ±π/4.
        /// </summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void SinCos(float4 a, out float4 sin, out float4 cos)
        {
            float4 n = math.floor(a * 0.63661977f + 0.5f);
            float4 r = a - n * 1.5703125f - n * 4.8375129699707031e-4f - n * 7.5497899548918822e-8f;
            float4 r2 = r * r;
            float4 r4 = r2 * r2;
            float4 s = r + r * r2 * (-1.6666654611e-1f + r2 * 8.3321608736e-3f + r4 * -1.9515295891e-4f);
            float4 c = 1f + r2 * -0.5f + r4 * (4.166664568298827e-2f + r2 * -1.388731625493765e-3f + r4 * 2.443315711809948e-5f);

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
            float4 p = t + t * t2 * (-3.33329491539e-1f + t2 * 1.99777106478e-1f + t2 * t2 * (-1.38776856032e-1f + t2 * 8.05374449538e-2f));
            float4 angle = math.select(p, 0.78539816f + p, upper);
            return math.select(angle, 1.57079633f - angle, steep);
        }
    }
}
