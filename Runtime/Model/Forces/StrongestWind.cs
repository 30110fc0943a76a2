using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Wind as felt by the wing: unchanged up to the strongest wind that bends the wing freely, growing with the fourth root beyond. Soft
    /// sheets in a stream curl up and offer less and less area (Vogel 1989, leaves), which a wing that keeps its area and its joints'
    /// limits cannot do.
    /// </summary>
    internal static unsafe class StrongestWind
    {
        /// <summary>Largest speed of the air along each axis, L/s: the square of a larger one would overflow.</summary>
        private const float k_Most = 1e15f;

        /// <summary>Bounds the wind of a step: air relative to the body, L/s.</summary>
        public static void Derive(in WingPack pack)
        {
            var wind = SoaFloat3.Clamp(pack.surroundings->wind, -k_Most, k_Most);
            pack.surroundings->boundWind = pack.options.coupling == MembraneCoupling.OneWay
                ? wind
                : wind * FeltShare(math.sqrt(SoaFloat3.LengthSquared(wind)) / pack.parameters->strongestWind);
        }

        /// <summary>Speed of the bounded wind, L/s.</summary>
        public static float4 Speed(in WingPack pack) => math.sqrt(SoaFloat3.LengthSquared(pack.surroundings->boundWind));

        /// <summary>Share of a wind that is felt.</summary>
        /// <param name="x">Its speed over that of the strongest wind.</param>
        // (1 + x¹⁶)^(−0.75/16), which is 1 below 0.8 to a thousandth; as t^−0.75 (t^−16 + (x/t)¹⁶)^(−0.75/16) with t = max(x, 1), so that
        // no speed overflows.
        public static float4 FeltShare(float4 x)
        {
            float4 t = math.max(x, 1f), inverse = 1f / t;
            return 1f / (ThreeQuarters(t) * ThreeQuarters(Root16(Power16(inverse) + Power16(x * inverse))));
        }

        // x^0.75.
        private static float4 ThreeQuarters(float4 x)
        {
            float4 root = math.sqrt(x);
            return root * math.sqrt(root);
        }

        private static float4 Root16(float4 x) => math.sqrt(math.sqrt(math.sqrt(math.sqrt(x))));

        private static float4 Power16(float4 x)
        {
            x *= x;
            x *= x;
            x *= x;
            return x * x;
        }
    }
}
