using System;
using System.Reflection;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace Unity.Collections.LowLevel.Unsafe;

using Unsafe = System.Runtime.CompilerServices.Unsafe;

public static unsafe class UnsafeUtility
{
    private struct AlignmentOf<T> where T : struct
    {
        public byte first;
        public T value;
    }

    /// <summary>Memory that Unity's leak detection does not see.</summary>
    public static void* Malloc(long size, int alignment, Allocator allocator) =>
        NativeHeap.Allocate(size, alignment, allocator, null, null, isTracked: false);

    public static void Free(void* memory, Allocator allocator) => NativeHeap.Free(memory, allocator, isTracked: false);

    public static void* MallocTracked(long size, int alignment, Allocator allocator, int callstacksToSkip) =>
        NativeHeap.Allocate(size, alignment, allocator, null, null);

    public static void FreeTracked(void* memory, Allocator allocator) => NativeHeap.Free(memory, allocator, isTracked: true);

    public static void MemClear(void* destination, long size) => NativeMemory.Clear(destination, (nuint)size);

    public static void MemSet(void* destination, byte value, long size) => NativeMemory.Fill(destination, (nuint)size, value);

    public static void MemCpy(void* destination, void* source, long size) => Buffer.MemoryCopy(source, destination, size, size);

    public static void MemMove(void* destination, void* source, long size) => Buffer.MemoryCopy(source, destination, size, size);

    public static int MemCmp(void* ptr1, void* ptr2, long size) =>
        new ReadOnlySpan<byte>(ptr1, checked((int)size)).SequenceCompareTo(new ReadOnlySpan<byte>(ptr2, checked((int)size)));

    /// <summary>In bytes from the start of the struct that declares it.</summary>
    public static int GetFieldOffset(FieldInfo field) => FieldOffsets.Of(field);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int SizeOf<T>() where T : struct => Unsafe.SizeOf<T>();

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int AlignOf<T>() where T : struct => Unsafe.SizeOf<AlignmentOf<T>>() - Unsafe.SizeOf<T>();

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void* AddressOf<T>(ref T output) where T : struct => Unsafe.AsPointer(ref output);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static ref T AsRef<T>(void* ptr) where T : struct => ref Unsafe.AsRef<T>(ptr);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static ref T ArrayElementAsRef<T>(void* ptr, int index) where T : struct => ref Unsafe.Add(ref Unsafe.AsRef<T>(ptr), index);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static T ReadArrayElement<T>(void* source, int index) => Unsafe.Read<T>((byte*)source + (long)index * Unsafe.SizeOf<T>());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void WriteArrayElement<T>(void* destination, int index, T value) =>
        Unsafe.Write((byte*)destination + (long)index * Unsafe.SizeOf<T>(), value);
}
