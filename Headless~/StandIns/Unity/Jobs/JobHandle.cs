using System;
using Unity.Collections;

namespace Unity.Jobs;

/// <summary>A scheduled job, or several; the default value is complete.</summary>
public struct JobHandle : IEquatable<JobHandle>
{
    internal readonly int m_Index;
    internal readonly int m_Version;

    internal JobHandle(int index, int version)
    {
        m_Index = index;
        m_Version = version;
    }

    public readonly bool IsCompleted => JobTable.IsFinished(this);

    /// <summary>Waits for the job and all that it depends on, and helps; throws what one of them has thrown.</summary>
    public void Complete()
    {
        JobHandle handle = this;
        this = default;
        JobTable.Complete(handle);
    }

    public static void CompleteAll(ref JobHandle job0, ref JobHandle job1)
    {
        CombineDependencies(job0, job1).Complete();
        job0 = job1 = default;
    }

    public static void CompleteAll(ref JobHandle job0, ref JobHandle job1, ref JobHandle job2)
    {
        CombineDependencies(job0, job1, job2).Complete();
        job0 = job1 = job2 = default;
    }

    public static void CompleteAll(NativeArray<JobHandle> jobs)
    {
        CombineDependencies(jobs).Complete();
        for (int i = 0; i < jobs.Length; i++)
            jobs[i] = default;
    }

    public static JobHandle CombineDependencies(JobHandle job0, JobHandle job1) => JobFence.Combine([job0, job1]);

    public static JobHandle CombineDependencies(JobHandle job0, JobHandle job1, JobHandle job2) => JobFence.Combine([job0, job1, job2]);

    public static JobHandle CombineDependencies(NativeArray<JobHandle> jobs) => JobFence.Combine(jobs.AsReadOnlySpan());

    public static void ScheduleBatchedJobs() => JobTable.Wake();

    /// <summary>Returns true where the first job is complete, or the second waits for it.</summary>
    public static bool CheckFenceIsDependencyOrDidSyncFence(JobHandle jobHandle, JobHandle dependsOn) =>
        JobTable.DependsOn(dependsOn, jobHandle);

    public readonly bool Equals(JobHandle other) => m_Index == other.m_Index && m_Version == other.m_Version;

    public override readonly bool Equals(object obj) => obj is JobHandle other && Equals(other);

    public override readonly int GetHashCode() => m_Index * 397 ^ m_Version;

    public static bool operator ==(JobHandle a, JobHandle b) => a.Equals(b);

    public static bool operator !=(JobHandle a, JobHandle b) => !a.Equals(b);
}
