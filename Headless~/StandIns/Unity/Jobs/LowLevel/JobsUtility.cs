using System;

namespace Unity.Jobs.LowLevel.Unsafe;

public static class JobsUtility
{
    public const int MaxJobThreadCount = 128;
    public const int CacheLineSize = 64;

    /// <summary>Threads besides the main thread; 0: all jobs are executed in Complete().</summary>
    public static int JobWorkerCount
    {
        get => JobWorkers.Count;
        set => JobWorkers.Count = value;
    }

    public static int JobWorkerMaximumCount => JobWorkers.Maximum;

    /// <summary>Kept, and without effect: the safety checks are those of the configuration.</summary>
    public static bool JobDebuggerEnabled { get; set; } = true;

    public static int ThreadIndex => JobContext.ThreadIndex;

    /// <summary>One more than the largest ThreadIndex.</summary>
    public static int ThreadIndexCount => JobWorkers.Maximum + 1;

    public static bool IsExecutingJob => JobContext.Layout != null;

    public static void ResetJobWorkerCount() => JobWorkers.Count = Math.Min(Environment.ProcessorCount - 1, JobWorkers.Maximum);
}
