using System;

namespace Unity.Jobs;

/// <summary>Empty job that waits for several others.</summary>
internal sealed class JobFence : JobRecord
{
    public override string Name => "CombineDependencies";

    public static JobHandle Combine(ReadOnlySpan<JobHandle> handles)
    {
        lock (JobTable.Gate)
        {
            JobFence fence = JobPool<JobFence>.Take();
            fence.Begin(0, BatchOrder.Ascending);
            foreach (JobHandle handle in handles)
                fence.DependOn(handle);
            if (fence.DependencyCount > 0)
                return JobTable.Submit(fence);
            fence.Sync();
            JobPool<JobFence>.Return(fence);
            return default;
        }
    }

    public override void Execute() => throw new NotSupportedException();

    public override void ReturnToPool() => JobPool<JobFence>.Return(this);
}
