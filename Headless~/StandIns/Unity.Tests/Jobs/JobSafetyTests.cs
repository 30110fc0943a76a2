using System;
using NUnit.Framework;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace Unity.Tests.Jobs;

/// <summary>Plants each misuse of containers in jobs, and sees it caught.</summary>
public sealed unsafe class JobSafetyTests : SafetyFixture
{
    private struct Write : IJobFor
    {
        public NativeArray<int> target;

        public void Execute(int index) => target[index] = index;
    }

    private struct Read : IJob
    {
        [ReadOnly] public NativeArray<int> source;

        public void Execute() => _ = source[0];
    }

    private struct WriteThroughReadOnly : IJob
    {
        [ReadOnly] public NativeArray<int> source;

        public void Execute() => source[0] = 1;
    }

    private struct SpanThroughReadOnly : IJob
    {
        [ReadOnly] public NativeArray<int> source;

        public void Execute() => source.AsSpan()[0] = 1;
    }

    private struct ReadThroughWriteOnly : IJob
    {
        [WriteOnly] public NativeArray<int> target;

        public void Execute() => _ = target[0];
    }

    private struct WriteNext : IJobFor
    {
        public NativeArray<int> target;

        public void Execute(int index) => target[(index + 1) % target.Length] = index;
    }

    private struct WriteNextUnrestricted : IJobFor
    {
        [NativeDisableParallelForRestriction] public NativeArray<int> target;

        public void Execute(int index) => target[(index + 1) % target.Length] = index;
    }

    private struct Copy : IJob
    {
        [ReadOnly] public NativeArray<int> source;
        public NativeArray<int> target;

        public void Execute() => target[0] = source[0];
    }

    private struct Nested : IJob
    {
        public struct Part
        {
            public NativeArray<int> target;
        }

        public int before;
        public Part part;

        public void Execute() => part.target[0] = before;
    }

    private struct DisposeInside : IJob
    {
        public NativeArray<int> target;

        public void Execute() => target.Dispose();
    }

    private struct HasPointer : IJob
    {
        public int* pointer;

        public readonly void Execute() => _ = pointer;
    }

    private struct HasDeclaredPointer : IJob
    {
        [NativeDisableUnsafePtrRestriction] public int* pointer;

        public readonly void Execute() => *pointer = 5;
    }

    private struct HasReference : IJob
    {
        public string text;

        public readonly void Execute() => _ = text;
    }

    private struct ScheduleInside : IJob
    {
        public NativeArray<int> target;

        public void Execute() => new Write { target = target }.Schedule(1, default);
    }

    private NativeArray<int> m_Array;

    [SetUp]
    public void CreateArray()
    {
        TestBuild.RequireChecks();
        m_Array = new NativeArray<int>(100, Allocator.Persistent);
    }

    [TearDown]
    public void DisposeArray()
    {
        if (m_Array.IsCreated)
            m_Array.Dispose();
    }

    [Test]
    public void MainThread_MustNotTouch_WhatAPendingJobWrites()
    {
        JobHandle job = new Write { target = m_Array }.ScheduleParallel(100, 8, default);
        Assert.That(() => m_Array[0], Throws.InvalidOperationException.With.Message.Contains("Complete"));
        Assert.That(() => m_Array[0] = 1, Throws.InvalidOperationException);
        Assert.That(() => m_Array.ToArray(), Throws.InvalidOperationException);
        Assert.That(() => m_Array.AsReadOnly()[0], Throws.InvalidOperationException);
        Assert.That(() => m_Array.Dispose(), Throws.InvalidOperationException);
        job.Complete();
        Assert.That(m_Array[99], Is.EqualTo(99));
    }

    [Test]
    public void MainThread_MayRead_WhatAPendingJobReads()
    {
        JobHandle job = new Read { source = m_Array }.Schedule();
        Assert.That(m_Array[0], Is.Zero);
        Assert.That(() => m_Array[0] = 1, Throws.InvalidOperationException.With.Message.Contains(nameof(Read)));
        Assert.That(() => m_Array.Dispose(), Throws.InvalidOperationException);
        job.Complete();
        m_Array[0] = 1;
    }

    [Test]
    public void FinishedJob_StillHasToBeCompleted()
    {
        JobHandle job = new Write { target = m_Array }.Schedule(100, default);
        while (!job.IsCompleted)
        {
        }

        Assert.That(() => m_Array[0], Throws.InvalidOperationException);
        job.Complete();
        Assert.That(m_Array[5], Is.EqualTo(5));
    }

    [Test]
    public void Jobs_ThatShareWhatOneWrites_MustDependOnEachOther()
    {
        JobHandle first = new Write { target = m_Array }.Schedule(100, default);
        Assert.That(() => new Write { target = m_Array }.Schedule(100, default), Throws.InvalidOperationException);
        Assert.That(() => new Read { source = m_Array }.Schedule(), Throws.InvalidOperationException);
        Assert.That(() => new Read { source = m_Array }.Run(), Throws.InvalidOperationException);
        JobHandle second = new Read { source = m_Array }.Schedule(first);
        Assert.That(() => new Write { target = m_Array }.Schedule(100, first), Throws.InvalidOperationException);
        JobHandle third = new Write { target = m_Array }.Schedule(100, JobHandle.CombineDependencies(first, second));
        third.Complete();
        Assert.That(m_Array[7], Is.EqualTo(7));
    }

    [Test]
    public void Jobs_MayReadTogether()
    {
        JobHandle first = new Read { source = m_Array }.Schedule();
        JobHandle second = new Read { source = m_Array }.Schedule();
        JobHandle.CompleteAll(ref first, ref second);
        m_Array[0] = 1;
    }

    [Test]
    public void ReadOnlyArray_MustNotBeWritten_InAJob()
    {
        Assert.That(
            () => new WriteThroughReadOnly { source = m_Array }.Schedule().Complete(),
            Throws.InvalidOperationException.With.Message.Contains("WriteThroughReadOnly.source"));
        Assert.That(() => new WriteThroughReadOnly { source = m_Array }.Run(), Throws.InvalidOperationException);
        Assert.That(() => new SpanThroughReadOnly { source = m_Array }.Run(), Throws.InvalidOperationException);
        Assert.That(m_Array[0], Is.Zero);
    }

    [Test]
    public void WriteOnlyArray_MustNotBeRead_InAJob()
    {
        Assert.That(() => new ReadThroughWriteOnly { target = m_Array }.Run(), Throws.InvalidOperationException);
    }

    [Test]
    public void ParallelJob_MustNotLeaveItsIndex()
    {
        Assert.That(
            () => new WriteNext { target = m_Array }.ScheduleParallel(100, 32, default).Complete(),
            Throws.TypeOf<IndexOutOfRangeException>().With.Message.Contains("parallel"));
        Assert.That(() => new WriteNext { target = m_Array }.Schedule(100, default).Complete(), Throws.Nothing);
        Assert.That(() => new WriteNext { target = m_Array }.Run(100), Throws.Nothing);
        new WriteNextUnrestricted { target = m_Array }.ScheduleParallel(100, 32, default).Complete();
        Assert.That(m_Array[0], Is.EqualTo(99));
    }

    [Test]
    public void OneArray_MustNotBePassedTwice_IfItIsWritten()
    {
        Assert.That(() => new Copy { source = m_Array, target = m_Array }.Run(), Throws.InvalidOperationException);
        Assert.That(() => new Copy { source = m_Array.GetSubArray(0, 1), target = m_Array.GetSubArray(1, 1) }.Run(),
            Throws.InvalidOperationException);
    }

    [Test]
    public void Arrays_MustExist_WhenAJobIsScheduled()
    {
        Assert.That(() => new Read().Schedule(), Throws.InvalidOperationException.With.Message.Contains("Read.source"));
        var array = new NativeArray<int>(1, Allocator.TempJob);
        var job = new Read { source = array };
        array.Dispose();
        Assert.That(() => job.Schedule(), Throws.TypeOf<ObjectDisposedException>());
    }

    [Test]
    public void TemporaryArray_MustNotBeScheduled_ButMayBeRun()
    {
        using var array = new NativeArray<int>(1, Allocator.Temp);
        Assert.That(() => new Read { source = array }.Schedule(), Throws.InvalidOperationException);
        Assert.That(() => new Read { source = array }.Run(), Throws.Nothing);
    }

    [Test]
    public void Arrays_InStructsOfAJob_AreGuardedToo()
    {
        JobHandle job = new Nested { before = 3, part = new Nested.Part { target = m_Array } }.Schedule();
        Assert.That(() => m_Array[0], Throws.InvalidOperationException);
        job.Complete();
        Assert.That(m_Array[0], Is.EqualTo(3));
    }

    [Test]
    public void AJob_MustNotDispose_WhatItWasPassed()
    {
        Assert.That(() => new DisposeInside { target = m_Array }.Schedule().Complete(), Throws.InvalidOperationException);
        Assert.That(m_Array[0], Is.Zero);
    }

    [Test]
    public void Pointers_NeedTheirAttribute()
    {
        Assert.That(() => new HasPointer { pointer = null }.Schedule(),
            Throws.InvalidOperationException.With.Message.Contains("HasPointer.pointer"));
        int value = 0;
        new HasDeclaredPointer { pointer = &value }.Run();
        Assert.That(value, Is.EqualTo(5));
    }

    [Test]
    public void References_AreNotAllowedInJobs()
    {
        Assert.That(
            () => new HasReference { text = "" }.Run(), Throws.InvalidOperationException.With.Message.Contains("HasReference.text"));
    }

    [Test]
    public void AJob_MustNotScheduleJobs()
    {
        Assert.That(() => new ScheduleInside { target = m_Array }.Schedule().Complete(), Throws.InvalidOperationException);
    }

    [Test]
    public void DisposeAfterAJob_WaitsForIt_AndEndsTheArrayAtOnce()
    {
        var array = new NativeArray<int>(1000, Allocator.TempJob);
        NativeArray<int> copy = array;
        JobHandle job = new Write { target = array }.ScheduleParallel(1000, 10, default);
        Assert.That(() => copy.Dispose(default), Throws.InvalidOperationException);
        JobHandle disposal = array.Dispose(job);
        Assert.That(array.IsCreated, Is.False);
        Assert.That(() => copy[0], Throws.TypeOf<ObjectDisposedException>());
        Assert.That(() => disposal.Complete(), Throws.Nothing);
        using var next = new NativeArray<int>(1000, Allocator.TempJob);
        Assert.That(next[999], Is.Zero);
    }
}
