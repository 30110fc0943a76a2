using System;
using System.Linq;
using NUnit.Framework;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace Unity.Tests.Collections;

public sealed unsafe class NativeArrayTests : SafetyFixture
{
    private NativeArray<int> m_Array;

    [SetUp]
    public void CreateArray() => m_Array = new NativeArray<int>([10, 11, 12, 13, 14], Allocator.Persistent);

    [TearDown]
    public void DisposeArray() => m_Array.Dispose();

    [Test]
    public void NewArray_IsClear_AndAlignedToACacheLine()
    {
        using var array = new NativeArray<double>(1000, Allocator.TempJob);
        Assert.That(array, Is.All.EqualTo(0.0));
        Assert.That((long)array.GetUnsafeReadOnlyPtr() % 64, Is.Zero);
    }

    [Test]
    public void Elements_KeepWhatIsWritten()
    {
        m_Array[3] = -7;
        Assert.That(m_Array.ToArray(), Is.EqualTo(new[] { 10, 11, 12, -7, 14 }));
        Assert.That(m_Array.Sum(), Is.EqualTo(40));
        Assert.That(m_Array.AsReadOnly()[3], Is.EqualTo(-7));
    }

    [Test]
    public void EmptyArray_IsCreated()
    {
        using var array = new NativeArray<int>(0, Allocator.Persistent);
        Assert.That(array.IsCreated);
        Assert.That(array.ToArray(), Is.Empty);
    }

    [Test]
    public void SubArray_SharesTheMemory_ButCannotBeDisposed()
    {
        NativeArray<int> part = m_Array.GetSubArray(1, 3);
        part[0] = 99;
        Assert.That(m_Array[1], Is.EqualTo(99));
        Assert.That(part.Length, Is.EqualTo(3));
        Assert.That(() => part.Dispose(), Throws.InvalidOperationException);
        Assert.That(() => m_Array.GetSubArray(3, 3), Throws.InstanceOf<ArgumentOutOfRangeException>());
    }

    [Test]
    public void Reinterpret_SeesTheSameBytes()
    {
        m_Array[0] = math.asint(1.5f);
        Assert.That(m_Array.Reinterpret<float>()[0], Is.EqualTo(1.5f));
        Assert.That(m_Array.GetSubArray(0, 4).Reinterpret<int2>(sizeof(int)).Length, Is.EqualTo(2));
        Assert.That(() => m_Array.Reinterpret<double>(), Throws.InvalidOperationException);
        Assert.That(() => m_Array.Reinterpret<int2>(sizeof(int)), Throws.InvalidOperationException);
    }

    [Test]
    public void Copy_MovesRanges_AndRefusesWhatDoesNotFit()
    {
        int[] managed = new int[5];
        NativeArray<int>.Copy(m_Array, 1, managed, 2, 3);
        Assert.That(managed, Is.EqualTo(new[] { 0, 0, 11, 12, 13 }));
        NativeArray<int>.Copy(managed, 2, m_Array, 0, 2);
        Assert.That(m_Array.ToArray(), Is.EqualTo(new[] { 11, 12, 12, 13, 14 }));
        NativeArray<int>.Copy(m_Array, 0, m_Array, 1, 3);
        Assert.That(m_Array.ToArray(), Is.EqualTo(new[] { 11, 11, 12, 12, 14 }));
        Assert.That(() => m_Array.CopyTo(new int[4]), Throws.ArgumentException);
        Assert.That(() => NativeArray<int>.Copy(m_Array, 3, managed, 0, 3), Throws.ArgumentException);
    }

    [Test]
    public void Spans_SeeTheSameMemory()
    {
        m_Array.AsSpan()[4] = 1;
        Assert.That(m_Array.AsReadOnlySpan()[4], Is.EqualTo(1));
        Assert.That(((int*)m_Array.GetUnsafePtr())[4], Is.EqualTo(1));
    }

    [Test]
    public void Index_OutOfRange_IsRefused([Values(-1, 5, int.MinValue, int.MaxValue)] int index)
    {
        TestBuild.RequireChecks();
        Assert.That(() => m_Array[index], Throws.TypeOf<IndexOutOfRangeException>());
        Assert.That(() => m_Array[index] = 1, Throws.TypeOf<IndexOutOfRangeException>());
        Assert.That(() => m_Array.AsReadOnly()[index], Throws.TypeOf<IndexOutOfRangeException>());
    }

    [Test]
    public void Use_AfterDispose_IsRefused()
    {
        TestBuild.RequireChecks();
        var array = new NativeArray<int>(5, Allocator.Persistent);
        NativeArray<int> copy = array, part = array.GetSubArray(1, 2);
        NativeArray<int>.ReadOnly view = array.AsReadOnly();
        array.Dispose();
        Assert.That(array.IsCreated, Is.False);
        Assert.That(() => array[0], Throws.TypeOf<ObjectDisposedException>());
        Assert.That(() => copy[0], Throws.TypeOf<ObjectDisposedException>());
        Assert.That(() => copy[0] = 1, Throws.TypeOf<ObjectDisposedException>());
        Assert.That(() => part[0], Throws.TypeOf<ObjectDisposedException>());
        Assert.That(() => view[0], Throws.TypeOf<ObjectDisposedException>());
        Assert.That(() => copy.AsSpan(), Throws.TypeOf<ObjectDisposedException>());
        Assert.That(() => copy.ToArray(), Throws.TypeOf<ObjectDisposedException>());
        Assert.That(() => (nint)copy.GetUnsafePtr(), Throws.TypeOf<ObjectDisposedException>());
    }

    [Test]
    public void Use_AfterDispose_IsRefused_EvenIfTheMemoryIsInUseAgain()
    {
        TestBuild.RequireChecks();
        var array = new NativeArray<int>(5, Allocator.Persistent);
        NativeArray<int> copy = array;
        array.Dispose();
        using var next = new NativeArray<int>(5, Allocator.Persistent);
        Assert.That(() => copy[0], Throws.TypeOf<ObjectDisposedException>());
        Assert.That(next[0], Is.Zero);
    }

    [Test]
    public void SecondDispose_IsRefused()
    {
        TestBuild.RequireChecks();
        var array = new NativeArray<int>(5, Allocator.Persistent);
        NativeArray<int> copy = array;
        array.Dispose();
        Assert.That(() => array.Dispose(), Throws.TypeOf<ObjectDisposedException>());
        Assert.That(() => copy.Dispose(), Throws.TypeOf<ObjectDisposedException>());
    }

    [Test]
    public void ArrayThatWasNeverCreated_CanBeDisposed_ButNotUsed()
    {
        TestBuild.RequireChecks();
        NativeArray<int> array = default;
        Assert.That(() => array.Dispose(), Throws.Nothing);
        Assert.That(() => array[0], Throws.TypeOf<NullReferenceException>());
    }

    [Test]
    public void WrongArguments_AreRefused()
    {
        Assert.That(() => new NativeArray<int>(-1, Allocator.Persistent), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => new NativeArray<int>(1, Allocator.None), Throws.ArgumentException);
        Assert.That(() => new NativeArray<int>(null, Allocator.Persistent), Throws.ArgumentNullException);
        Assert.That(() => new NativeArray<(string, int)>(1, Allocator.Persistent), Throws.InvalidOperationException);
    }
}
