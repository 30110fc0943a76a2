using System;
using System.Threading;
using Unity.Collections;

namespace Unity.Jobs;

/// <summary>
/// A scheduled job from Schedule until it has been completed; then it goes back to the pool of its job type. Fields that
/// are not of the batches are guarded by <see cref="JobTable.Gate"/>.
/// </summary>
internal abstract class JobRecord
{
    private JobHandle[] m_Dependencies = new JobHandle[4];
    private JobRecord[] m_Dependents = new JobRecord[4];
    private ContainerSafety[] m_Containers = new ContainerSafety[8];
    private int m_DependentCount;
    private int m_ContainerCount;
    private int m_NextBatch;
    private int m_BatchesLeft;
    private BatchOrder m_Order;

    protected JobRecord()
    {
        Index = JobTable.Add(this);
    }

    public int Index { get; }

    public int Version { get; private set; } = 1;

    public abstract string Name { get; }

    public JobHandle Handle => new(Index, Version);

    public ReadOnlySpan<JobHandle> Dependencies => m_Dependencies.AsSpan(0, DependencyCount);

    public int DependencyCount { get; private set; }

    public int WaitingFor { get; private set; }

    /// <summary>Threads that hold a reference and may ask for a batch.</summary>
    public int Users { get; set; }

    public bool IsFinished { get; private set; }

    /// <summary>Completed by the main thread; reused when the last user has left.</summary>
    public bool IsSynced { get; private set; }

    /// <summary>Scheduled, and not yet completed by the main thread.</summary>
    public bool IsPending { get; private set; }

    public int BatchCount { get; private set; }

    /// <summary>The first exception of the job.</summary>
    public Exception Error { get; set; }

    /// <summary>Claims batches and executes them until none is left.</summary>
    public abstract void Execute();

    public abstract void ReturnToPool();

    public void Begin(int batchCount, BatchOrder order)
    {
        BatchCount = batchCount;
        m_Order = order;
        m_NextBatch = 0;
        m_BatchesLeft = batchCount;
        DependencyCount = m_DependentCount = m_ContainerCount = 0;
        WaitingFor = 0;
        IsFinished = IsSynced = false;
        IsPending = true;
        Error = null;
    }

    public void DependOn(JobHandle handle)
    {
        JobRecord record = JobTable.Find(handle);
        if (record == null)
            return;
        Append(ref m_Dependencies, DependencyCount++, handle);
        if (record.IsFinished)
            return;
        WaitingFor++;
        Append(ref record.m_Dependents, record.m_DependentCount++, this);
    }

    public void Use(ContainerSafety container, bool writes)
    {
        Append(ref m_Containers, m_ContainerCount++, container);
        container.AddUser(this, writes);
    }

    protected bool Claim(out int batch)
    {
        int next = Interlocked.Increment(ref m_NextBatch) - 1;
        batch = m_Order.Of(next, BatchCount);
        return next < BatchCount;
    }

    protected void Executed(int batches)
    {
        if (Interlocked.Add(ref m_BatchesLeft, -batches) == 0)
            JobTable.Finish(this);
    }

    protected void Fail(Exception exception)
    {
        lock (JobTable.Gate)
            Error ??= exception;
    }

    /// <summary>Marks the job as finished and hands on those that waited for nothing else.</summary>
    public void Finish()
    {
        IsFinished = true;
        for (int i = 0; i < m_DependentCount; i++)
        {
            JobRecord dependent = m_Dependents[i];
            m_Dependents[i] = null;
            if (--dependent.WaitingFor == 0)
                JobTable.Start(dependent);
        }

        m_DependentCount = 0;
    }

    /// <summary>From now on the handles of the job are complete, and its containers free.</summary>
    public void Sync()
    {
        IsSynced = true;
        IsPending = false;
        Version++;
        for (int i = 0; i < m_ContainerCount; i++)
        {
            m_Containers[i].RemoveUser(this);
            m_Containers[i] = null;
        }

        m_ContainerCount = 0;
    }

    private static void Append<TItem>(ref TItem[] items, int count, TItem item)
    {
        if (count == items.Length)
            Array.Resize(ref items, 2 * count);
        items[count] = item;
    }
}
