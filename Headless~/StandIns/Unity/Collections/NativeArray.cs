using System;
using System.Collections;
using System.Collections.Generic;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace Unity.Collections;

/// <summary>An array in native memory. With ENABLE_UNITY_COLLECTIONS_CHECKS each access is checked as in Unity's editor.</summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe partial struct NativeArray<T> : IDisposable, IEnumerable<T>, IEquatable<NativeArray<T>>
    where T : struct
{
    internal void* m_Buffer;
    internal int m_Length;
    internal Allocator m_AllocatorLabel;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
    // The indices that this copy may use: all of them, except in a parallel job.
    internal int m_First;
    internal int m_Count;
    internal SafetyHandle m_Safety;
#endif

    public NativeArray(int length, Allocator allocator, NativeArrayOptions options = NativeArrayOptions.ClearMemory)
    {
        this = default;
        Allocate(length, allocator);
        if ((options & NativeArrayOptions.ClearMemory) != 0)
            NativeMemory.Clear(m_Buffer, (nuint)((long)length * Unsafe.SizeOf<T>()));
    }

    public NativeArray(T[] array, Allocator allocator)
    {
        ArgumentNullException.ThrowIfNull(array);
        this = default;
        Allocate(array.Length, allocator);
        Copy(array, this);
    }

    public NativeArray(NativeArray<T> array, Allocator allocator)
    {
        this = default;
        Allocate(array.m_Length, allocator);
        Copy(array, this);
    }

    public readonly int Length
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => m_Length;
    }

    public readonly bool IsCreated => m_Buffer != null;

    public T this[int index]
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        readonly get
        {
            CheckReadAt(index);
            return Unsafe.Add(ref Unsafe.AsRef<T>(m_Buffer), index);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        set
        {
            CheckWriteAt(index);
            Unsafe.Add(ref Unsafe.AsRef<T>(m_Buffer), index) = value;
        }
    }

    public void Dispose()
    {
        CheckDispose();
        if (!IsCreated)
            return;
        CheckOwned();
        ReleaseSafety();
        NativeHeap.Free(m_Buffer);
        m_Buffer = null;
        m_AllocatorLabel = Allocator.Invalid;
    }

    /// <summary>Frees the memory after the jobs of the handle; the array itself can no longer be used.</summary>
    public JobHandle Dispose(JobHandle inputDeps)
    {
        CheckDispose(inputDeps);
        if (!IsCreated)
            return inputDeps;
        CheckOwned();
        JobHandle handle = DisposeJob.Schedule(m_Buffer, DetachSafety(), inputDeps);
        m_Buffer = null;
        m_AllocatorLabel = Allocator.Invalid;
        return handle;
    }

    public readonly Enumerator GetEnumerator()
    {
        NativeArray<T> array = this;
        return new Enumerator(ref array);
    }

    readonly IEnumerator<T> IEnumerable<T>.GetEnumerator() => GetEnumerator();

    readonly IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();

    public readonly bool Equals(NativeArray<T> other) => m_Buffer == other.m_Buffer && m_Length == other.m_Length;

    public override readonly bool Equals(object obj) => obj is NativeArray<T> other && Equals(other);

    public override readonly int GetHashCode() => HashCode.Combine((nint)m_Buffer, m_Length);

    public static bool operator ==(NativeArray<T> left, NativeArray<T> right) => left.Equals(right);

    public static bool operator !=(NativeArray<T> left, NativeArray<T> right) => !left.Equals(right);

    private void Allocate(int length, Allocator allocator)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(length);
        if (RuntimeHelpers.IsReferenceOrContainsReferences<T>())
            throw new InvalidOperationException($"{typeof(T)} holds references, so it cannot be the element of a NativeArray.");
        m_Length = length;
        m_AllocatorLabel = allocator;
        m_Buffer = NativeHeap.Allocate((long)length * Unsafe.SizeOf<T>(), UnsafeUtility.AlignOf<T>(), allocator, typeof(T), CreateSafety());
    }
}
