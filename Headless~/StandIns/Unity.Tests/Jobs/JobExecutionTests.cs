using System;
using System.Threading;
using NUnit.Framework;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Jobs.LowLevel.Unsafe;
using Unity.StandIns;

namespace Unity.Tests.Jobs;

public sealed class JobExecutionTests : SafetyFixture
{
    private const int k_Length = 5000;

    private struct Accumulate : IJobFor
    {
        [ReadOnly] public NativeArray<float> source;
        public NativeArray<float> target;
        public float factor;

        public void Execute(int index)
        {
            float sum = target[index];
            for (int i = 0; i < 20; i++)
                sum += source[index] * factor / (i + 1);
            target[index] = sum;
        }
    }

    private struct CountVisits : IJobFor
    {
        [NativeDisableParallelForRestriction] public NativeArray<int> visits;

        public void Execute(int index) => Interlocked.Increment(ref visits.AsSpan()[index]);
    }

    private struct RecordOrder : IJobFor
    {
        [NativeDisableParallelForRestriction] public NativeArray<int> order;
        public int next;

        public void Execute(int index) => order[next++] = index;
    }

    private struct RecordThread : IJobFor
    {
        public NativeArray<int> threads;
        [NativeSetThreadIndex] public int thread;

        public RecordThread(NativeArray<int> threads)
        {
            this.threads = threads;
            thread = -1;
        }

        public void Execute(int index)
        {
            threads[index] = thread;
            Thread.SpinWait(2000);
        }
    }

    private struct Throw : IJobFor
    {
        public int at;

        public readonly void Execute(int index)
        {
            if (index == at)
                throw new ArithmeticException($"index {index}");
        }
    }

    private struct AddOne : IJob
    {
        public NativeArray<int> value;

        public void Execute() => value[0] = 2 * value[0] + 1;
    }

    private struct SetFlag : IJob
    {
        public static volatile bool s_IsSet;

        public readonly void Execute() => s_IsSet = true;
    }

    private struct CountInField : IJobFor
    {
        public int count;

        public void Execute(int index) => count++;
    }

    private static float[] RunAccumulate(Func<Accumulate, JobHandle> schedule)
    {
        using var source = new NativeArray<float>(k_Length, Allocator.TempJob);
        using var target = new NativeArray<float>(k_Length, Allocator.TempJob);
        NativeArray<float> write = source;
        for (int i = 0; i < k_Length; i++)
            write[i] = MathF.Sin(i);
        JobHandle handle = schedule(new Accumulate { source = source, target = target, factor = 0.7f });
        handle = new Accumulate { source = source, target = target, factor = -0.2f }.ScheduleParallel(k_Length, 17, handle);
        handle.Complete();
        return target.ToArray();
    }

    [Test]
    public void Workers_GiveWhatOneThreadGives_InAnyOrder()
    {
        float[] expected = RunAccumulate(job =>
        {
            job.Run(k_Length);
            return default;
        });
        Assert.That(RunAccumulate(job => job.ScheduleParallel(k_Length, 64, default)), Is.EqualTo(expected));
        Assert.That(RunAccumulate(job => job.Schedule(k_Length, default)), Is.EqualTo(expected));
        JobExecution.Order = JobOrder.Shuffled;
        Assert.That(RunAccumulate(job => job.ScheduleParallel(k_Length, 64, default)), Is.EqualTo(expected));
        JobsUtility.JobWorkerCount = 0;
        Assert.That(RunAccumulate(job => job.ScheduleParallel(k_Length, 64, default)), Is.EqualTo(expected));
    }

    [Test]
    public void AJob_RunsOnAWorker_WhenJobsAreSentOff_OrAFrameEnds([Values] bool byFrame)
    {
        if (JobsUtility.JobWorkerCount == 0)
            Assert.Ignore("There is no worker.");
        new SetFlag().Schedule().Complete();
        Thread.Sleep(50);
        SetFlag.s_IsSet = false;
        JobHandle job = new SetFlag().Schedule();
        if (byFrame)
            PlayerLoop.Tick(0.02f);
        else
            JobHandle.ScheduleBatchedJobs();

        Assert.That(SpinWait.SpinUntil(() => SetFlag.s_IsSet, 5000), Is.True);
        job.Complete();
    }

    [Test]
    public void EachIndex_IsVisitedOnce(
        [Values(0, 1, 2, 63, 64, 65, 1000)] int length, [Values(-1, 1, 7, 64, int.MaxValue)] int batch, [Values] JobOrder order)
    {
        JobExecution.Order = order;
        using var visits = new NativeArray<int>(length + 1, Allocator.TempJob);
        for (int i = 0; i < 20; i++)
            new CountVisits { visits = visits }.ScheduleParallel(length, batch, default).Complete();
        for (int i = 0; i < length; i++)
            Assert.That(visits[i], Is.EqualTo(20), $"index {i}");
        Assert.That(visits[length], Is.Zero);
    }

    [Test]
    public void ShuffledOrder_IsAnotherOrder_AndAscendingIsNot()
    {
        JobsUtility.JobWorkerCount = 0;
        using var order = new NativeArray<int>(50, Allocator.TempJob);
        new RecordOrder { order = order }.ScheduleParallel(50, 50, default).Complete();
        Assert.That(order.ToArray(), Is.Ordered);
        JobExecution.Order = JobOrder.Shuffled;
        new RecordOrder { order = order }.ScheduleParallel(50, 50, default).Complete();
        Assert.That(order.ToArray(), Is.Not.Ordered);
        Assert.That(order.ToArray(), Is.Unique);
        new RecordOrder { order = order }.Schedule(50, default).Complete();
        Assert.That(order.ToArray(), Is.Ordered, "a job that is not parallel keeps its order");
    }

    [Test]
    public void ThreadIndex_IsThatOfTheExecutingThread()
    {
        using var threads = new NativeArray<int>(200, Allocator.TempJob);
        new RecordThread(threads).ScheduleParallel(200, 1, default).Complete();
        Assert.That(threads, Is.All.InRange(0, JobsUtility.ThreadIndexCount - 1));
        JobsUtility.JobWorkerCount = 0;
        new RecordThread(threads).ScheduleParallel(200, 1, default).Complete();
        Assert.That(threads, Is.All.EqualTo(JobsUtility.ThreadIndex));
    }

    [Test]
    public void Worker_TakesPart_WhileTheMainThreadDoesNot()
    {
        if (JobsUtility.JobWorkerCount == 0)
            Assert.Ignore("This machine has no core for a worker.");
        using var threads = new NativeArray<int>(10, Allocator.TempJob);
        JobHandle handle = new RecordThread(threads).ScheduleParallel(10, 1, default);
        Assert.That(() => handle.IsCompleted, Is.True.After(5000, 1));
        handle.Complete();
        Assert.That(threads, Is.All.Positive);
    }

    [Test]
    public void Exceptions_ComeOutOfComplete_AndTheOtherIndicesAreExecuted()
    {
        Assert.That(
            () => new Throw { at = 30 }.ScheduleParallel(100, 1, default).Complete(),
            Throws.TypeOf<ArithmeticException>().With.Message.EqualTo("index 30"));
        JobHandle failing = new Throw { at = 0 }.Schedule(1, default);
        JobHandle following = new Throw { at = -1 }.Schedule(1, failing);
        Assert.That(() => following.Complete(), Throws.TypeOf<ArithmeticException>(), "a dependency's exception counts");
        Assert.That(() => following.Complete(), Throws.Nothing, "once");
        Assert.That(() => new Throw { at = 0 }.Run(1), Throws.TypeOf<ArithmeticException>());
    }

    [Test]
    public void Dependencies_RunOneAfterTheOther()
    {
        using var value = new NativeArray<int>(1, Allocator.TempJob);
        for (int round = 0; round < 200; round++)
        {
            JobExecution.Order = round % 2 == 0 ? JobOrder.Ascending : JobOrder.Shuffled;
            NativeArray<int> write = value;
            write[0] = 0;
            JobHandle handle = default;
            for (int i = 0; i < 10; i++)
                handle = new AddOne { value = value }.Schedule(handle);
            handle.Complete();
            Assert.That(value[0], Is.EqualTo(1023));
        }
    }

    [Test]
    public void CombinedHandle_WaitsForAll()
    {
        using var first = new NativeArray<int>(1, Allocator.TempJob);
        using var second = new NativeArray<int>(1, Allocator.TempJob);
        using var handles = new NativeArray<JobHandle>(2, Allocator.TempJob);
        NativeArray<JobHandle> write = handles;
        write[0] = new AddOne { value = first }.Schedule();
        write[1] = new AddOne { value = second }.Schedule();
        JobHandle.CombineDependencies(handles).Complete();
        Assert.That(first[0] + second[0], Is.EqualTo(2));
        Assert.That(handles[0].IsCompleted && handles[1].IsCompleted);
        Assert.That(JobHandle.CombineDependencies(default, default), Is.EqualTo(default(JobHandle)));
    }

    [Test]
    public void WithoutWorkers_AJobWaitsForComplete()
    {
        JobsUtility.JobWorkerCount = 0;
        using var value = new NativeArray<int>(1, Allocator.TempJob);
        JobHandle handle = new AddOne { value = value }.Schedule();
        Assert.That(JobExecution.PendingCount, Is.EqualTo(1));
        handle.Complete();
        Assert.That(value[0], Is.EqualTo(1));
    }

    [Test]
    public void CompleteAll_LeavesNoJobPending()
    {
        using var first = new NativeArray<int>(1, Allocator.TempJob);
        using var second = new NativeArray<int>(1, Allocator.TempJob);
        JobHandle added = new AddOne { value = first }.Schedule();
        _ = new AddOne { value = first }.Schedule(added);
        _ = new AddOne { value = second }.Schedule();
        _ = new Throw { at = 0 }.Schedule(1, default);
        JobExecution.CompleteAll();
        Assert.That(JobExecution.PendingCount, Is.Zero);
        Assert.That(first[0], Is.EqualTo(3));
        Assert.That(second[0], Is.EqualTo(1));
    }

    [Test]
    public void RunByRef_KeepsWhatTheJobWritesToItsFields_AndRunDoesNot()
    {
        var job = new CountInField();
        job.Run(5);
        Assert.That(job.count, Is.Zero);
        job.RunByRef(5);
        Assert.That(job.count, Is.EqualTo(5));
        job.ScheduleByRef(5, default).Complete();
        Assert.That(job.count, Is.EqualTo(5));
    }

    [Test]
    public void RunByRef_LeavesTheContainersToTheMainThread()
    {
        using var value = new NativeArray<int>(1, Allocator.TempJob);
        var job = new AddOne { value = value };
        job.RunByRef();
        job.value[0] += 1;
        JobHandle pending = new AddOne { value = value }.Schedule();
        try
        {
            TestBuild.RequireChecks();
            Assert.That(() => job.value[0], Throws.InvalidOperationException);
        }
        finally
        {
            pending.Complete();
        }
    }

    [Test]
    public void WorkerCount_OutOfRange_IsRefused()
    {
        Assert.That(() => JobsUtility.JobWorkerCount = -1, Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(
            () => JobsUtility.JobWorkerCount = JobsUtility.JobWorkerMaximumCount + 1, Throws.InstanceOf<ArgumentOutOfRangeException>());
    }
}
