using System;
using System.Runtime.CompilerServices;

namespace Unity.Collections;

public unsafe partial struct NativeArray<T>
{
    public readonly Span<T> AsSpan()
    {
        CheckWrite();
        return new Span<T>(m_Buffer, m_Length);
    }

    public readonly ReadOnlySpan<T> AsReadOnlySpan()
    {
        CheckRead();
        return new ReadOnlySpan<T>(m_Buffer, m_Length);
    }

    public static implicit operator Span<T>(in NativeArray<T> source) => source.AsSpan();

    public static implicit operator ReadOnlySpan<T>(in NativeArray<T> source) => source.AsReadOnlySpan();

    /// <summary>Part of the same memory, which only the whole array can dispose of.</summary>
    public readonly NativeArray<T> GetSubArray(int start, int length)
    {
        if (start < 0)
            throw new ArgumentOutOfRangeException(nameof(start), start, "start must be >= 0");
        if (length < 0 || start + (long)length > m_Length)
        {
            throw new ArgumentOutOfRangeException(
                nameof(length), length, $"sub array range {start}-{start + (long)length - 1} is outside the range 0-{m_Length - 1}");
        }
        NativeArray<T> part = this;
        part.m_Buffer = (byte*)m_Buffer + (long)start * Unsafe.SizeOf<T>();
        part.m_Length = length;
        part.m_AllocatorLabel = Allocator.None;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        CheckRead();
        part.m_First = 0;
        part.m_Count = length;
#endif
        return part;
    }

    /// <summary>Memory as elements of another type of equal size.</summary>
    public readonly NativeArray<U> Reinterpret<U>() where U : struct
    {
        if (Unsafe.SizeOf<T>() != Unsafe.SizeOf<U>())
        {
            throw new InvalidOperationException(
                $"Types {typeof(T)} and {typeof(U)} are different sizes - direct reinterpretation is not possible.");
        }
        return View<U>(m_Length);
    }

    /// <summary>Memory as elements of another type; the sizes in bytes must be equal.</summary>
    /// <param name="expectedTypeSize">The size of the present element, in bytes.</param>
    public readonly NativeArray<U> Reinterpret<U>(int expectedTypeSize) where U : struct
    {
        if (expectedTypeSize != Unsafe.SizeOf<T>())
        {
            throw new InvalidOperationException(
                $"Type {typeof(T)} was expected to be {expectedTypeSize} but is {Unsafe.SizeOf<T>()} bytes");
        }
        long bytes = (long)m_Length * Unsafe.SizeOf<T>();
        if (bytes % Unsafe.SizeOf<U>() != 0)
            throw new InvalidOperationException($"{bytes} bytes cannot be divided into elements of the type {typeof(U)}");
        return View<U>((int)(bytes / Unsafe.SizeOf<U>()));
    }

    private readonly NativeArray<U> View<U>(int length) where U : struct
    {
        NativeArray<T> view = this;
        view.m_Length = length;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        view.m_First = 0;
        view.m_Count = length;
#endif
        return Unsafe.As<NativeArray<T>, NativeArray<U>>(ref view);
    }

    public readonly ReadOnly AsReadOnly() => new(this);
}
