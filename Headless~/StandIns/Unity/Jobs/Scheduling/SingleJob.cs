using System;

namespace Unity.Jobs;

/// <summary>A scheduled IJob.</summary>
internal sealed class SingleJob<T> : JobRecord where T : struct, IJob
{
    private static readonly JobLayout s_Layout = JobLayout.Of(typeof(T));

    private T m_Data;

    public override string Name => s_Layout.Name;

    public static JobHandle Schedule(ref T data, JobHandle dependency)
    {
        JobContext.CheckOutside("schedule a job");
        s_Layout.Check(ref data, dependency, true);
        lock (JobTable.Gate)
        {
            JobWorkers.EnsureStarted();
            SingleJob<T> record = JobPool<SingleJob<T>>.Take();
            record.m_Data = data;
            record.Begin(1, BatchOrder.Ascending);
            s_Layout.Attach(ref record.m_Data, record);
            record.DependOn(dependency);
            return JobTable.Submit(record);
        }
    }

    public static void Run(ref T data)
    {
        s_Layout.Check(ref data, default, false);
        T job = data;
        s_Layout.Attach(ref job, null);
        s_Layout.SetThreadIndex(ref job);
        JobLayout outer = JobContext.Enter(s_Layout);
        try
        {
            job.Execute();
        }
        finally
        {
            JobContext.Leave(outer);
            s_Layout.Detach(ref job, ref data);
            data = job;
        }
    }

    public override void Execute()
    {
        if (!Claim(out _))
            return;
        T job = m_Data;
        s_Layout.SetThreadIndex(ref job);
        JobLayout outer = JobContext.Enter(s_Layout);
        try
        {
            job.Execute();
        }
        catch (Exception exception)
        {
            Fail(exception);
        }

        JobContext.Leave(outer);
        Executed(1);
    }

    public override void ReturnToPool()
    {
        m_Data = default;
        JobPool<SingleJob<T>>.Return(this);
    }
}
