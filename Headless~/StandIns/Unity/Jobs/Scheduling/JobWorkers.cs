using System;
using System.Diagnostics;
using System.Threading;
using Unity.Jobs.LowLevel.Unsafe;
using Unity.StandIns;

namespace Unity.Jobs;

/// <summary>The threads that execute jobs: they look for work for a short while, then sleep until they are woken.</summary>
internal static class JobWorkers
{
#if ENABLE_UNITY_COLLECTIONS_CHECKS
    // Tests run in several processes side by side: a thread that looks for work takes the core of another process.
    private const double k_SpinMicroseconds = 0.0;
#else
    private const double k_SpinMicroseconds = 50.0;
#endif

    public static readonly int Maximum = Math.Clamp(Environment.ProcessorCount - 1, 1, JobsUtility.MaxJobThreadCount - 1);

    private static readonly long s_SpinTicks = (long)(k_SpinMicroseconds * Stopwatch.Frequency / 1e6);
    private static volatile int s_Count = Environment.ProcessorCount - 1;
    private static int s_Started;
    private static uint s_Random = 1u;

    public static int Count
    {
        get => s_Count;
        set
        {
            if (value < 0 || value > Maximum)
                throw new ArgumentOutOfRangeException(nameof(value), value, $"The number of workers must lie between 0 and {Maximum}.");
            lock (JobTable.Gate)
            {
                s_Count = value;
                Monitor.PulseAll(JobTable.Gate);
            }
        }
    }

    /// <summary>Starts the threads that are wanted and do not run yet.</summary>
    public static void EnsureStarted()
    {
        while (s_Started < s_Count)
        {
            int index = ++s_Started;
            new Thread(() => Work(index)) { IsBackground = true, Name = $"Job worker {index}" }.Start();
        }
    }

    public static BatchOrder NextOrder() =>
        JobExecution.Order == JobOrder.Shuffled ? BatchOrder.Shuffled(NextRandom()) : BatchOrder.Ascending;

    /// <summary>Chooses the next of the jobs that can run.</summary>
    public static int Pick(int count) => JobExecution.Order == JobOrder.Shuffled ? (int)(NextRandom() % (uint)count) : 0;

    private static uint NextRandom()
    {
        s_Random ^= s_Random << 13;
        s_Random ^= s_Random >> 17;
        s_Random ^= s_Random << 5;
        return s_Random;
    }

    private static void Work(int index)
    {
        JobContext.SetThread(index);
        while (true)
        {
            if (index <= s_Count && (JobTable.ExecuteOne(index) || SpinUntilReady()))
                continue;
            JobTable.Sleep(index);
        }
    }

    private static bool SpinUntilReady()
    {
        long end = Stopwatch.GetTimestamp() + s_SpinTicks;
        while (Stopwatch.GetTimestamp() < end)
        {
            if (JobTable.HasReady)
                return true;
            Thread.SpinWait(20);
        }

        return false;
    }
}
