using System;
using NUnit.Framework;
using Unity.Collections;
using Unity.Jobs;
using Unity.Jobs.LowLevel.Unsafe;

namespace Unity.Tests.Jobs;

/// <summary>Scheduling must not feed the garbage collector: a frame of the package allocates nothing.</summary>
public sealed class JobAllocationTests : SafetyFixture
{
    private struct Fill : IJobFor
    {
        [ReadOnly] public NativeArray<float> source;
        public NativeArray<float> target;

        public void Execute(int index) => target[index] = source[index];
    }

    private struct Touch : IJob
    {
        public NativeArray<float> target;

        public void Execute() => target[0] += 1f;
    }

    private static void Frame(NativeArray<float> source, NativeArray<float> target)
    {
        using var scratch = new NativeArray<float>(64, Allocator.TempJob);
        JobHandle first = new Fill { source = source, target = scratch }.ScheduleParallel(64, 8, default);
        JobHandle second = new Fill { source = scratch, target = target }.ScheduleParallel(64, 8, first);
        JobHandle third = new Touch { target = target }.Schedule(second);
        JobHandle.CombineDependencies(first, second, third).Complete();
        new Touch { target = target }.Run();
    }

    [Test]
    public void AWarmFrame_AllocatesNothing_OnAnyThread([Values(0, 1)] int workers)
    {
        if (workers > JobsUtility.JobWorkerMaximumCount)
            Assert.Ignore("This machine has no core for a worker.");
        JobsUtility.JobWorkerCount = workers;
        using var source = new NativeArray<float>(64, Allocator.Persistent);
        using var target = new NativeArray<float>(64, Allocator.Persistent);
        for (int i = 0; i < 50; i++)
            Frame(source, target);

        // The test host allocates now and then on threads of its own: the best of several rounds is without that.
        long leastOnThread = long.MaxValue, leastInTotal = long.MaxValue;
        for (int round = 0; round < 20; round++)
        {
            long thread = GC.GetAllocatedBytesForCurrentThread();
            long total = GC.GetTotalAllocatedBytes(true);
            for (int i = 0; i < 100; i++)
                Frame(source, target);
            leastInTotal = Math.Min(leastInTotal, GC.GetTotalAllocatedBytes(true) - total);
            leastOnThread = Math.Min(leastOnThread, GC.GetAllocatedBytesForCurrentThread() - thread);
        }

        Assert.That(leastOnThread, Is.LessThan(100), "on the main thread, for 100 frames");
        Assert.That(leastInTotal, Is.LessThan(100), "on all threads, for 100 frames");
    }
}
