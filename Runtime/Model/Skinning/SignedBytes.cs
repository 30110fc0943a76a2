using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Directions as four signed bytes, x in the lowest: what graphics cards read as SNorm8, c / 127. Rounded to the nearest, which turns a
    /// unit vector by 0.4° at most.
    /// </summary>
    internal static class SignedBytes
    {
        private const float k_One = 127f;

        // A float of this size counts in ones: its lowest bits are those of the rounded number that was added to it.
        private const float k_Ones = 12582912f;

        private const int k_Byte = 255;

        /// <summary>Packs four vectors.</summary>
        /// <param name="v">Components from −1 to 1.</param>
        /// <param name="w">Fourth component.</param>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static int4 Pack(in SoaFloat3 v, float4 w) => Pack(v) | Ones(w) << 24;

        /// <summary>Packs four vectors whose fourth component is 0.</summary>
        /// <param name="v">Components from −1 to 1.</param>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static int4 Pack(in SoaFloat3 v) => (Ones(v.x) & k_Byte) | (Ones(v.y) & k_Byte) << 8 | (Ones(v.z) & k_Byte) << 16;

        /// <summary>Packs eight vectors whose fourth component is 0, as bits of floats.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static TwoFloat4 Pack(in TwoFloat3 v) => TwoFloat4.LowestByte(Ones(v.x), 0) | TwoFloat4.LowestByte(Ones(v.y), 8)
            | TwoFloat4.LowestByte(Ones(v.z), 16);

        /// <summary>Vector of four packed components.</summary>
        public static float4 Unpack(int packed) =>
            math.max(new float4((sbyte)packed, (sbyte)(packed >> 8), (sbyte)(packed >> 16), (sbyte)(packed >> 24)) / k_One, -1f);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static int4 Ones(float4 value) => math.asint(value * k_One + k_Ones);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static TwoFloat4 Ones(TwoFloat4 value) => value * TwoFloat4.All(k_One) + TwoFloat4.All(k_Ones);
    }
}
