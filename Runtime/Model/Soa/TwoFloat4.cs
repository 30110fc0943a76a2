using System.Runtime.CompilerServices;
using Unity.Burst.Intrinsics;
using Unity.Mathematics;
using static Unity.Burst.Intrinsics.X86.Avx;
using static Unity.Burst.Intrinsics.X86.Avx2;

namespace Alate
{
    /// <summary>
    /// Two <see cref="float4"/> side by side in one register of eight lanes; each lane is computed as in a <see cref="float4"/>, to the
    /// same bits. To be used where <see cref="X86.Avx2.IsAvx2Supported"/> holds, which Burst decides as it compiles; without Burst it does
    /// not.
    /// </summary>
    internal readonly unsafe struct TwoFloat4
    {
        private readonly v256 m_Lanes;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private TwoFloat4(v256 lanes) => m_Lanes = lanes;

        /// <summary>Reads one from each place.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static TwoFloat4 Load(float4* first, float4* second) => new TwoFloat4(mm256_loadu2_m128(second, first));

        /// <summary>Reads one, for both.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static TwoFloat4 Both(float4* value) => new TwoFloat4(mm256_broadcast_ps(value));

        /// <summary>Writes one to each place.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void Store(float4* first, float4* second) => mm256_storeu2_m128(second, first, m_Lanes);

        /// <summary>The lesser of both; <paramref name="bound"/> where <paramref name="a"/> is no number.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static TwoFloat4 Lower(TwoFloat4 a, TwoFloat4 bound) => new TwoFloat4(mm256_min_ps(a.m_Lanes, bound.m_Lanes));

        /// <summary>The greater of both; <paramref name="bound"/> where <paramref name="a"/> is no number.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static TwoFloat4 Higher(TwoFloat4 a, TwoFloat4 bound) => new TwoFloat4(mm256_max_ps(a.m_Lanes, bound.m_Lanes));

        /// <summary>Exchanges rows and columns of two matrices of four by four, whose rows are the arguments.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void Transpose(ref TwoFloat4 a, ref TwoFloat4 b, ref TwoFloat4 c, ref TwoFloat4 d)
        {
            v256 ab = mm256_unpacklo_ps(a.m_Lanes, b.m_Lanes), cd = mm256_unpacklo_ps(c.m_Lanes, d.m_Lanes);
            v256 abHigh = mm256_unpackhi_ps(a.m_Lanes, b.m_Lanes), cdHigh = mm256_unpackhi_ps(c.m_Lanes, d.m_Lanes);
            a = new TwoFloat4(mm256_unpacklo_pd(ab, cd));
            b = new TwoFloat4(mm256_unpackhi_pd(ab, cd));
            c = new TwoFloat4(mm256_unpacklo_pd(abHigh, cdHigh));
            d = new TwoFloat4(mm256_unpackhi_pd(abHigh, cdHigh));
        }

        /// <summary>The lowest byte of each lane's bits, moved up by a number of bits.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static TwoFloat4 LowestByte(TwoFloat4 value, int up) =>
            new TwoFloat4(mm256_slli_epi32(mm256_and_si256(value.m_Lanes, mm256_set1_epi32(255)), up));

        /// <summary>Bits of either.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static TwoFloat4 operator |(TwoFloat4 a, TwoFloat4 b) => new TwoFloat4(mm256_or_si256(a.m_Lanes, b.m_Lanes));

        /// <summary>The same number in all lanes.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static TwoFloat4 All(float value) => new TwoFloat4(mm256_set1_ps(value));

        /// <summary>Sum.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static TwoFloat4 operator +(TwoFloat4 a, TwoFloat4 b) => new TwoFloat4(mm256_add_ps(a.m_Lanes, b.m_Lanes));

        /// <summary>Difference.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static TwoFloat4 operator -(TwoFloat4 a, TwoFloat4 b) => new TwoFloat4(mm256_sub_ps(a.m_Lanes, b.m_Lanes));

        /// <summary>Product.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static TwoFloat4 operator *(TwoFloat4 a, TwoFloat4 b) => new TwoFloat4(mm256_mul_ps(a.m_Lanes, b.m_Lanes));

        /// <summary>Quotient.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static TwoFloat4 operator /(TwoFloat4 a, TwoFloat4 b) => new TwoFloat4(mm256_div_ps(a.m_Lanes, b.m_Lanes));
    }
}
