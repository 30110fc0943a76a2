using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Processor = System.Runtime.Intrinsics.X86;

namespace Unity.Burst.Intrinsics;

/// <summary>Instructions of x86 processors.</summary>
public static unsafe class X86
{
    /// <summary>Instructions on 256 bits.</summary>
    public static class Avx
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static v256 mm256_add_ps(v256 a, v256 b) => new(a.lanes + b.lanes);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static v256 mm256_sub_ps(v256 a, v256 b) => new(a.lanes - b.lanes);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static v256 mm256_mul_ps(v256 a, v256 b) => new(a.lanes * b.lanes);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static v256 mm256_div_ps(v256 a, v256 b) => new(a.lanes / b.lanes);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static v256 mm256_min_ps(v256 a, v256 b) => new(Processor.Avx.Min(a.lanes, b.lanes));

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static v256 mm256_max_ps(v256 a, v256 b) => new(Processor.Avx.Max(a.lanes, b.lanes));

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static v256 mm256_unpacklo_ps(v256 a, v256 b) => new(Processor.Avx.UnpackLow(a.lanes, b.lanes));

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static v256 mm256_unpackhi_ps(v256 a, v256 b) => new(Processor.Avx.UnpackHigh(a.lanes, b.lanes));

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static v256 mm256_unpacklo_pd(v256 a, v256 b) =>
            new(Processor.Avx.UnpackLow(a.lanes.AsDouble(), b.lanes.AsDouble()).AsSingle());

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static v256 mm256_unpackhi_pd(v256 a, v256 b) =>
            new(Processor.Avx.UnpackHigh(a.lanes.AsDouble(), b.lanes.AsDouble()).AsSingle());

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static v256 mm256_set1_ps(float a) => new(Vector256.Create(a));

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static v256 mm256_set1_epi32(int a) => new(Vector256.Create(a).AsSingle());

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static v256 mm256_broadcast_ps(void* ptr) => new(Processor.Avx.BroadcastVector128ToVector256((float*)ptr));

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static v256 mm256_loadu2_m128(void* hiaddr, void* loaddr) =>
            new(Vector256.Create(Vector128.Load((float*)loaddr), Vector128.Load((float*)hiaddr)));

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void mm256_storeu2_m128(void* hiaddr, void* loaddr, v256 val)
        {
            val.lanes.GetLower().Store((float*)loaddr);
            val.lanes.GetUpper().Store((float*)hiaddr);
        }
    }

    /// <summary>Instructions on whole numbers of 256 bits.</summary>
    public static class Avx2
    {
        public static bool IsAvx2Supported
        {
            [MethodImpl(MethodImplOptions.AggressiveInlining)]
            get => Processor.Avx2.IsSupported;
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static v256 mm256_and_si256(v256 a, v256 b) => new(a.lanes & b.lanes);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static v256 mm256_or_si256(v256 a, v256 b) => new(a.lanes | b.lanes);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static v256 mm256_slli_epi32(v256 a, int imm8) => new((a.lanes.AsInt32() << imm8).AsSingle());
    }
}
