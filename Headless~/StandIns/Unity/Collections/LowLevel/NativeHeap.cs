using System;
using System.Diagnostics;
using System.Runtime.InteropServices;
using StandIns;

namespace Unity.Collections;

/// <summary>Memory for containers: aligned to cache lines; with checks on, guarded at both ends and filled with NaN.</summary>
internal static unsafe class NativeHeap
{
    private const int k_CacheLine = 64;
    private const byte k_Unset = 0xFF;
    private const byte k_Freed = 0xDD;
    private const byte k_Guard = 0xA5;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
    private const int k_GuardSize = k_CacheLine;
#else
    private const int k_GuardSize = 0;
#endif

    public static void* Allocate(long size, int alignment, Allocator allocator, Type type, ContainerSafety safety, bool isTracked = true)
    {
        if (allocator is not (Allocator.Temp or Allocator.TempJob or Allocator.Persistent))
            throw new ArgumentException("Allocator must be Temp, TempJob or Persistent", nameof(allocator));
        ArgumentOutOfRangeException.ThrowIfNegative(size);
        if (alignment > k_CacheLine)
            throw new ArgumentException("alignment must not be above 64", nameof(alignment));
        byte* block = (byte*)NativeMemory.AlignedAlloc((nuint)(Math.Max(size, 1) + 2 * k_GuardSize), k_CacheLine);
        byte* memory = block + k_GuardSize;
        Mark(memory, size);
        NativeMemoryLedger.Add((nint)memory, new NativeMemoryLedger.Entry
        {
            size = size,
            allocator = allocator,
            type = type,
            safety = safety,
            isTracked = isTracked,
            trace = NativeLeakDetection.Mode == NativeLeakDetectionMode.EnabledWithStackTrace ? Environment.StackTrace : null,
        });
        return memory;
    }

    public static void Free(void* memory)
    {
        if (!NativeMemoryLedger.Remove((nint)memory, out NativeMemoryLedger.Entry entry))
            throw new InvalidOperationException("This memory is not allocated: it was freed before, or never was allocated here.");
        Release(memory, entry.size);
    }

    /// <summary>Frees a block of UnsafeUtility, as it was allocated.</summary>
    public static void Free(void* memory, Allocator allocator, bool isTracked)
    {
        if (NativeMemoryLedger.Find((nint)memory) is { } entry && (entry.isTracked != isTracked || entry.allocator != allocator))
        {
            throw new InvalidOperationException($"{entry.Source} of Allocator.{entry.allocator} must be freed by its own method, with the "
                + "allocator it was allocated with.");
        }
        Free(memory);
    }

    public static void Release(void* memory, long size)
    {
        bool intact = Intact((byte*)memory, size);
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        NativeMemory.Fill(memory, (nuint)size, k_Freed);
#endif
        NativeMemory.AlignedFree((byte*)memory - k_GuardSize);
        if (!intact)
            throw new InvalidOperationException($"Memory just outside of an allocation of {size} bytes was written to.");
    }

    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    private static void Mark(byte* memory, long size)
    {
        NativeMemory.Fill(memory - k_GuardSize, k_GuardSize, k_Guard);
        NativeMemory.Fill(memory, (nuint)size, k_Unset);
        NativeMemory.Fill(memory + size, k_GuardSize, k_Guard);
    }

    private static bool Intact(byte* memory, long size) =>
        !new ReadOnlySpan<byte>(memory - k_GuardSize, k_GuardSize).ContainsAnyExcept(k_Guard)
        && !new ReadOnlySpan<byte>(memory + size, k_GuardSize).ContainsAnyExcept(k_Guard);
}
