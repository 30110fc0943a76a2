using System;
using System.Runtime.CompilerServices;

namespace Unity.Jobs;

/// <summary>A scheduled IJobFor.</summary>
internal sealed class ForJob<T> : JobRecord where T : struct, IJobFor
{
    private static readonly JobLayout s_Layout = JobLayout.Of(typeof(T));

    private T m_Data;
    private int m_Length;
    private int m_BatchSize;
    private bool m_IsParallel;

    public override string Name => s_Layout.Name;

    public static JobHandle Schedule(ref T data, int length, int batchSize, bool parallel, JobHandle dependency)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(length);
        JobContext.CheckOutside("schedule a job");
        s_Layout.Check(ref data, dependency, true);
        lock (JobTable.Gate)
        {
            JobWorkers.EnsureStarted();
            ForJob<T> record = JobPool<ForJob<T>>.Take();
            BatchOrder order = parallel ? JobWorkers.NextOrder() : BatchOrder.Ascending;
            record.m_Length = length;
            record.m_IsParallel = parallel;
            record.m_BatchSize = order.IsAscending ? Math.Clamp(batchSize, 1, Math.Max(length, 1)) : 1;
            record.m_Data = data;
            record.Begin((int)((length + (long)record.m_BatchSize - 1) / record.m_BatchSize), order);
            s_Layout.Attach(ref record.m_Data, record);
            record.DependOn(dependency);
            return JobTable.Submit(record);
        }
    }

    public static void Run(ref T data, int length)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(length);
        s_Layout.Check(ref data, default, false);
        T job = data;
        s_Layout.Attach(ref job, null);
        s_Layout.SetThreadIndex(ref job);
        JobLayout outer = JobContext.Enter(s_Layout);
        try
        {
            ExecuteRange(ref job, 0, length, false);
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
        if (!Claim(out int batch))
            return;
        T job = m_Data;
        s_Layout.SetThreadIndex(ref job);
        JobLayout outer = JobContext.Enter(s_Layout);
        int executed = 0;
        do
        {
            int begin = batch * m_BatchSize;
            try
            {
                ExecuteRange(ref job, begin, Math.Min(begin + m_BatchSize, m_Length), m_IsParallel);
            }
            catch (Exception exception)
            {
                Fail(exception);
            }

            executed++;
        }
        while (Claim(out batch));
        JobContext.Leave(outer);
        Executed(executed);
    }

    public override void ReturnToPool()
    {
        m_Data = default;
        JobPool<ForJob<T>>.Return(this);
    }

    // Apart from the try block: the loop keeps its variables in registers.
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void ExecuteRange(ref T job, int begin, int end, bool parallel)
    {
        for (int i = begin; i < end; i++)
        {
            s_Layout.Restrict(ref job, i, parallel);
            job.Execute(i);
        }
    }
}
