using System;
using NUnit.Framework;
using StandIns;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace Unity.Tests.Collections;

public sealed unsafe class NativeMemoryTests : SafetyFixture
{
    private struct Mixed
    {
        public bool first;
        public double second;
        public byte third;
    }

    [Test]
    public void Ledger_CountsWhatIsNotFreed_AndSaysWhatItIs()
    {
        int before = NativeMemoryLedger.LiveCount;
        var array = new NativeArray<double>(10, Allocator.Persistent);
        void* memory = UnsafeUtility.Malloc(1234, 16, Allocator.TempJob);
        Assert.That(NativeMemoryLedger.LiveCount, Is.EqualTo(before + 2));
        Assert.That(NativeMemoryLedger.Describe(), Does.Contain("NativeArray<Double>, 80 bytes, Allocator.Persistent"));
        Assert.That(NativeMemoryLedger.Describe(), Does.Contain("1234 bytes, Allocator.TempJob"));
        array.Dispose();
        UnsafeUtility.Free(memory, Allocator.TempJob);
        Assert.That(NativeMemoryLedger.LiveCount, Is.EqualTo(before));
    }

    [Test]
    public void Ledger_NamesTheCaller_WithStackTraces()
    {
        NativeLeakDetection.Mode = NativeLeakDetectionMode.EnabledWithStackTrace;
        try
        {
            using var array = new NativeArray<int>(1, Allocator.Persistent);
            Assert.That(NativeMemoryLedger.Describe(), Does.Contain(nameof(Ledger_NamesTheCaller_WithStackTraces)));
        }
        finally
        {
            NativeLeakDetection.Mode = NativeLeakDetectionMode.Enabled;
        }
    }

    [Test]
    public void Temp_NeedsNoDispose_AndEndsWithTheFrame()
    {
        int before = NativeMemoryLedger.LiveCount;
        var array = new NativeArray<int>(3, Allocator.Temp);
        Assert.That(NativeMemoryLedger.LiveCount, Is.EqualTo(before));
        NativeMemoryLedger.EndFrame();
        TestBuild.RequireChecks();
        Assert.That(() => array[0], Throws.TypeOf<ObjectDisposedException>());
    }

    [Test]
    public void SecondFree_IsRefused()
    {
        void* memory = UnsafeUtility.Malloc(8, 8, Allocator.Persistent);
        UnsafeUtility.Free(memory, Allocator.Persistent);
        Assert.That(() => UnsafeUtility.Free(memory, Allocator.Persistent), Throws.InvalidOperationException);
    }

    [Test]
    public void TrackedMemory_IsSeenByLeakDetection_AndHasAFreeOfItsOwn()
    {
        int unseen = NativeMemoryLedger.UntrackedCount;
        void* tracked = UnsafeUtility.MallocTracked(8, 8, Allocator.Persistent, 0),
            plain = UnsafeUtility.Malloc(8, 8, Allocator.Persistent);
        Assert.That(NativeMemoryLedger.UntrackedCount, Is.EqualTo(unseen + 1));
        Assert.That(() => UnsafeUtility.Free(tracked, Allocator.Persistent), Throws.InvalidOperationException);
        Assert.That(() => UnsafeUtility.FreeTracked(plain, Allocator.Persistent), Throws.InvalidOperationException);
        Assert.That(() => UnsafeUtility.FreeTracked(tracked, Allocator.TempJob), Throws.InvalidOperationException);
        UnsafeUtility.FreeTracked(tracked, Allocator.Persistent);
        UnsafeUtility.Free(plain, Allocator.Persistent);
        Assert.That(NativeMemoryLedger.UntrackedCount, Is.EqualTo(unseen));
    }

    [Test]
    public void WriteBeyondTheEnd_IsFoundWhenTheMemoryIsFreed()
    {
        TestBuild.RequireChecks();
        byte* memory = (byte*)UnsafeUtility.Malloc(8, 8, Allocator.Persistent);
        memory[8] = 1;
        Assert.That(() => UnsafeUtility.Free(memory, Allocator.Persistent), Throws.InvalidOperationException);
        memory = (byte*)UnsafeUtility.Malloc(8, 8, Allocator.Persistent);
        memory[-1] = 1;
        Assert.That(() => UnsafeUtility.Free(memory, Allocator.Persistent), Throws.InvalidOperationException);
    }

    [Test]
    public void UninitialisedFloats_AreNaN()
    {
        TestBuild.RequireChecks();
        using var array = new NativeArray<float>(5, Allocator.Persistent, NativeArrayOptions.UninitializedMemory);
        Assert.That(array, Is.All.NaN);
    }

    [Test]
    public void MemoryFunctions_DoWhatTheirNamesSay()
    {
        byte* a = stackalloc byte[8], b = stackalloc byte[8];
        UnsafeUtility.MemSet(a, 7, 8);
        UnsafeUtility.MemClear(b, 8);
        UnsafeUtility.MemCpy(b, a, 4);
        Assert.That(UnsafeUtility.MemCmp(a, b, 4), Is.Zero);
        Assert.That(UnsafeUtility.MemCmp(a, b, 8), Is.Positive);
        for (byte i = 0; i < 8; i++)
            a[i] = i;
        UnsafeUtility.MemMove(a + 1, a, 7);
        Assert.That(a[7], Is.EqualTo(6));
        Assert.That(UnsafeUtility.AsRef<byte>(a + 1), Is.Zero);
    }

    [Test]
    public void FieldOffsets_AreThoseOfTheRuntime()
    {
        var mixed = new Mixed { first = true };
        byte* start = (byte*)UnsafeUtility.AddressOf(ref mixed);
        Assert.That(UnsafeUtility.GetFieldOffset(typeof(Mixed).GetField("second")), Is.EqualTo((int)((byte*)&mixed.second - start)));
        Assert.That(UnsafeUtility.GetFieldOffset(typeof(Mixed).GetField("third")), Is.EqualTo((int)(&mixed.third - start)));
        Assert.That(UnsafeUtility.SizeOf<Mixed>(), Is.EqualTo(sizeof(Mixed)));
        Assert.That(UnsafeUtility.AlignOf<Mixed>(), Is.EqualTo(8));
    }
}
