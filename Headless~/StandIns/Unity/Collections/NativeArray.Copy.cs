using System;
using System.Runtime.CompilerServices;

namespace Unity.Collections;

public unsafe partial struct NativeArray<T>
{
    public readonly T[] ToArray()
    {
        var array = new T[m_Length];
        Copy(this, array, m_Length);
        return array;
    }

    public void CopyFrom(T[] array) => Copy(array, this);

    public void CopyFrom(NativeArray<T> array) => Copy(array, this);

    public readonly void CopyTo(T[] array) => Copy(this, array);

    public readonly void CopyTo(NativeArray<T> array) => Copy(this, array);

    public static void Copy(NativeArray<T> src, NativeArray<T> dst)
    {
        CheckEqual(src.Length, dst.Length);
        Copy(src, 0, dst, 0, src.Length);
    }

    public static void Copy(T[] src, NativeArray<T> dst)
    {
        ArgumentNullException.ThrowIfNull(src);
        CheckEqual(src.Length, dst.Length);
        Copy(src, 0, dst, 0, src.Length);
    }

    public static void Copy(NativeArray<T> src, T[] dst)
    {
        ArgumentNullException.ThrowIfNull(dst);
        CheckEqual(src.Length, dst.Length);
        Copy(src, 0, dst, 0, src.Length);
    }

    public static void Copy(ReadOnly src, NativeArray<T> dst)
    {
        CheckEqual(src.Length, dst.Length);
        Copy(src, 0, dst, 0, src.Length);
    }

    public static void Copy(ReadOnly src, T[] dst)
    {
        ArgumentNullException.ThrowIfNull(dst);
        CheckEqual(src.Length, dst.Length);
        Copy(src, 0, dst, 0, src.Length);
    }

    public static void Copy(NativeArray<T> src, NativeArray<T> dst, int length) => Copy(src, 0, dst, 0, length);

    public static void Copy(T[] src, NativeArray<T> dst, int length) => Copy(src, 0, dst, 0, length);

    public static void Copy(NativeArray<T> src, T[] dst, int length) => Copy(src, 0, dst, 0, length);

    public static void Copy(ReadOnly src, NativeArray<T> dst, int length) => Copy(src, 0, dst, 0, length);

    public static void Copy(ReadOnly src, T[] dst, int length) => Copy(src, 0, dst, 0, length);

    public static void Copy(NativeArray<T> src, int srcIndex, NativeArray<T> dst, int dstIndex, int length)
    {
        src.CheckRead();
        dst.CheckWrite();
        CheckRange(src.Length, srcIndex, dst.Length, dstIndex, length);
        Span(src.m_Buffer, srcIndex, length).CopyTo(Span(dst.m_Buffer, dstIndex, length));
    }

    public static void Copy(T[] src, int srcIndex, NativeArray<T> dst, int dstIndex, int length)
    {
        ArgumentNullException.ThrowIfNull(src);
        dst.CheckWrite();
        CheckRange(src.Length, srcIndex, dst.Length, dstIndex, length);
        src.AsSpan(srcIndex, length).CopyTo(Span(dst.m_Buffer, dstIndex, length));
    }

    public static void Copy(NativeArray<T> src, int srcIndex, T[] dst, int dstIndex, int length)
    {
        ArgumentNullException.ThrowIfNull(dst);
        src.CheckRead();
        CheckRange(src.Length, srcIndex, dst.Length, dstIndex, length);
        Span(src.m_Buffer, srcIndex, length).CopyTo(dst.AsSpan(dstIndex, length));
    }

    public static void Copy(ReadOnly src, int srcIndex, NativeArray<T> dst, int dstIndex, int length)
    {
        src.CheckRead();
        dst.CheckWrite();
        CheckRange(src.Length, srcIndex, dst.Length, dstIndex, length);
        Span(src.m_Buffer, srcIndex, length).CopyTo(Span(dst.m_Buffer, dstIndex, length));
    }

    public static void Copy(ReadOnly src, int srcIndex, T[] dst, int dstIndex, int length)
    {
        ArgumentNullException.ThrowIfNull(dst);
        src.CheckRead();
        CheckRange(src.Length, srcIndex, dst.Length, dstIndex, length);
        Span(src.m_Buffer, srcIndex, length).CopyTo(dst.AsSpan(dstIndex, length));
    }

    private static Span<T> Span(void* buffer, int start, int length) =>
        new((byte*)buffer + (long)start * Unsafe.SizeOf<T>(), length);

    private static void CheckEqual(int source, int destination)
    {
        if (source != destination)
            throw new ArgumentException($"source and destination length must be the same: {source} and {destination}");
    }

    private static void CheckRange(int source, int sourceIndex, int destination, int destinationIndex, int length)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(length);
        if (sourceIndex < 0 || sourceIndex > source || (sourceIndex == source && source > 0))
            throw new ArgumentOutOfRangeException(nameof(sourceIndex), sourceIndex, "srcIndex is outside the range of valid indexes");
        if (destinationIndex < 0 || destinationIndex > destination || (destinationIndex == destination && destination > 0))
        {
            throw new ArgumentOutOfRangeException(
                nameof(destinationIndex), destinationIndex, "dstIndex is outside the range of valid indexes");
        }
        if (sourceIndex + (long)length > source)
            throw new ArgumentException($"length {length} is greater than what the source holds from {sourceIndex} on", nameof(length));
        if (destinationIndex + (long)length > destination)
        {
            throw new ArgumentException(
                $"length {length} is greater than what the destination holds from {destinationIndex} on", nameof(length));
        }
    }
}
