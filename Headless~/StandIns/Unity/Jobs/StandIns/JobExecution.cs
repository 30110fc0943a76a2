using Unity.Jobs;

namespace Unity.StandIns;

/// <summary>Settings for executing jobs, for tests. JobsUtility.JobWorkerCount = 0 executes all of them in Complete().</summary>
[StandInExtension]
public static class JobExecution
{
    public static JobOrder Order { get; set; } = JobOrder.Ascending;

    /// <summary>Scheduled jobs that have not been completed, directly or through a job that depends on them.</summary>
    public static int PendingCount => JobTable.PendingCount;

    /// <summary>Completes all of these, so that a failed test leaves none to the next; what they throw is lost.</summary>
    public static void CompleteAll() => JobTable.CompleteAll();
}
