using System;
using Unity.Collections;

namespace Unity.Jobs;

/// <summary>Frees a container's memory once the jobs that use it are done.</summary>
internal sealed unsafe class DisposeJob : JobRecord
{
    private void* m_Memory;
    private ContainerSafety m_Safety;

    public override string Name => "NativeArray.Dispose";

    public static JobHandle Schedule(void* memory, ContainerSafety safety, JobHandle dependency)
    {
        JobContext.CheckOutside("dispose of a container after a job");
        lock (JobTable.Gate)
        {
            JobWorkers.EnsureStarted();
            DisposeJob record = JobPool<DisposeJob>.Take();
            record.m_Memory = memory;
            record.m_Safety = safety;
            record.Begin(1, BatchOrder.Ascending);
            record.DependOn(dependency);
            return JobTable.Submit(record);
        }
    }

    public override void Execute()
    {
        if (!Claim(out _))
            return;
        try
        {
            m_Safety?.ReleaseJobs();
            NativeHeap.Free(m_Memory);
        }
        catch (Exception exception)
        {
            Fail(exception);
        }

        Executed(1);
    }

    public override void ReturnToPool()
    {
        m_Memory = null;
        m_Safety = null;
        JobPool<DisposeJob>.Return(this);
    }
}
