using System;
using System.Diagnostics;
using System.Runtime.CompilerServices;
using Unity.Jobs;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
using System.Diagnostics.CodeAnalysis;
#endif

namespace Unity.Collections;

public unsafe partial struct NativeArray<T>
{
    private static string Name => NativeArrayName<T>.Value;

    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private readonly void CheckReadAt(int index)
    {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        if ((uint)(index - m_First) >= (uint)m_Count || m_Safety.RefusesRead)
            ThrowAt(index, m_Length, m_First, m_Count, m_Safety, false);
#endif
    }

    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private readonly void CheckWriteAt(int index)
    {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        if ((uint)(index - m_First) >= (uint)m_Count || m_Safety.RefusesWrite)
            ThrowAt(index, m_Length, m_First, m_Count, m_Safety, true);
#endif
    }

    /// <summary>Checks that all of the array may be read.</summary>
    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    internal readonly void CheckRead()
    {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        if (m_Safety.cell != null && m_Safety.RefusesRead)
            throw SafetyErrors.Of(m_Safety, Name, false);
#endif
    }

    /// <summary>Checks that all of the array may be written, or handed out for writing.</summary>
    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    internal readonly void CheckWrite()
    {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        if (m_Safety.cell != null && m_Safety.RefusesWrite)
            throw SafetyErrors.Of(m_Safety, Name, true);
#endif
    }

    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    private readonly void CheckDispose(JobHandle dependency = default)
    {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        if (m_Safety.cell != null)
            SafetyErrors.CheckRelease(m_Safety, Name, dependency);
#endif
    }

    private readonly void CheckOwned()
    {
        if (m_AllocatorLabel <= Allocator.None)
            throw new InvalidOperationException($"This {Name} does not own its memory, so it cannot be disposed.");
    }

    private ContainerSafety CreateSafety()
    {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        var safety = ContainerSafety.Create(Name, m_AllocatorLabel);
        m_Safety = safety.Handle();
        m_Count = m_Length;
        return safety;
#else
        return null;
#endif
    }

    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    private readonly void ReleaseSafety()
    {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        ContainerSafety.Of(m_Safety).Release();
#endif
    }

    private readonly ContainerSafety DetachSafety()
    {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        var safety = ContainerSafety.Of(m_Safety);
        safety.ReleaseMain();
        return safety;
#else
        return null;
#endif
    }

#if ENABLE_UNITY_COLLECTIONS_CHECKS
    // Static, and nothing but a throw: the compiler sees that it never returns, and keeps the caller's array in registers.
    [DoesNotReturn]
    private static void ThrowAt(int index, int length, int first, int count, SafetyHandle safety, bool writes) =>
        throw ErrorAt(index, length, first, count, safety, writes);

    private static Exception ErrorAt(int index, int length, int first, int count, SafetyHandle safety, bool writes)
    {
        if (safety.cell == null)
            return new NullReferenceException($"This {Name} has not been created.");
        if ((uint)index < (uint)length && (uint)(index - first) >= (uint)count)
        {
            return new IndexOutOfRangeException(
                $"Index {index} is outside of what this index of the parallel job may use [{first}..{first + count - 1}] of the {Name}. "
                + "Mark the field with [ReadOnly], or with [NativeDisableParallelForRestriction] if no two indices write "
                + "the same element.");
        }

        return safety.Exists && (uint)index >= (uint)length
            ? new IndexOutOfRangeException($"Index {index} is out of the range of the {Name} of length {length}.")
            : SafetyErrors.Of(safety, Name, writes);
    }
#endif
}
