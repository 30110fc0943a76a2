using System;
using System.Collections.Generic;
using System.Runtime.ExceptionServices;
using System.Threading;

namespace Unity.Jobs;

/// <summary>All job records by index, and the queue of those that can run.</summary>
internal static class JobTable
{
    /// <summary>Guards the table, the queue and the records.</summary>
    public static readonly object Gate = new();

    // Record 0 is never used: the default handle is complete.
    private static readonly List<JobRecord> s_Records = [null];
    private static JobRecord[] s_Ready = new JobRecord[16];
    private static volatile int s_ReadyCount;
    private static int s_Sleeping;

    public static bool HasReady => s_ReadyCount > 0;

    /// <summary>Scheduled jobs that nobody has completed.</summary>
    public static int PendingCount { get; private set; }

    public static int Add(JobRecord record)
    {
        lock (Gate)
        {
            s_Records.Add(record);
            return s_Records.Count - 1;
        }
    }

    /// <summary>The job of a handle; null once it has been completed.</summary>
    public static JobRecord Find(JobHandle handle)
    {
        JobRecord record = s_Records[handle.m_Index];
        return record != null && record.Version == handle.m_Version ? record : null;
    }

    public static bool IsFinished(JobHandle handle)
    {
        if (handle.m_Index == 0)
            return true;
        lock (Gate)
        {
            JobRecord record = Find(handle);
            if (record == null || record.IsFinished)
                return true;
            Wake();
        }

        if (JobWorkers.Count == 0)
            ExecuteOne();
        return false;
    }

    /// <summary>Returns true where a handle waits for a job, directly or not, or the job has been completed.</summary>
    public static bool DependsOn(JobHandle handle, JobHandle job)
    {
        lock (Gate)
        {
            JobRecord record = Find(job);
            return record == null || DependsOn(handle, record);
        }
    }

    public static bool DependsOn(JobHandle handle, JobRecord job)
    {
        JobRecord record = Find(handle);
        if (record == null)
            return false;
        if (record == job)
            return true;
        foreach (JobHandle dependency in record.Dependencies)
        {
            if (DependsOn(dependency, job))
                return true;
        }

        return false;
    }

    /// <summary>Hands over a record that has been filled: it runs as soon as nothing keeps it waiting.</summary>
    public static JobHandle Submit(JobRecord record)
    {
        PendingCount++;
        JobHandle handle = record.Handle;
        if (record.WaitingFor == 0)
            Start(record);
        return handle;
    }

    public static void Start(JobRecord record)
    {
        if (record.BatchCount == 0)
        {
            record.Finish();
            return;
        }

        if (s_ReadyCount == s_Ready.Length)
            Array.Resize(ref s_Ready, 2 * s_ReadyCount);
        s_Ready[s_ReadyCount] = record;
        s_ReadyCount++;

        // A job of one batch wakes nobody: a worker that is awake takes it, or the thread that completes it.
        if (record.BatchCount > 1 && s_Sleeping > 0)
            Monitor.PulseAll(Gate);
    }

    /// <summary>Wakes the workers if there is a job that can run.</summary>
    public static void Wake()
    {
        lock (Gate)
        {
            if (s_ReadyCount > 0 && s_Sleeping > 0)
                Monitor.PulseAll(Gate);
        }
    }

    public static void Finish(JobRecord record)
    {
        lock (Gate)
            record.Finish();
    }

    /// <summary>Takes part in one job that can run; false if there is none, or the worker (0: the main thread) is not wanted.</summary>
    public static bool ExecuteOne(int worker = 0)
    {
        JobRecord record;
        lock (Gate)
        {
            if (s_ReadyCount == 0 || worker > JobWorkers.Count)
                return false;
            record = s_Ready[JobWorkers.Pick(s_ReadyCount)];
            record.Users++;
        }

        record.Execute();
        lock (Gate)
        {
            RemoveReady(record);
            record.Users--;
            ReuseIfSynced(record);
        }

        return true;
    }

    /// <summary>A worker with nothing to do waits for a job, or until it is no longer wanted.</summary>
    public static void Sleep(int worker)
    {
        lock (Gate)
        {
            while (s_ReadyCount == 0 || worker > JobWorkers.Count)
            {
                s_Sleeping++;
                Monitor.Wait(Gate);
                s_Sleeping--;
            }
        }
    }

    public static void Complete(JobHandle handle)
    {
        if (handle.m_Index == 0)
            return;
        JobContext.CheckOutside("complete a job");
        Wait(handle);
        Exception error = null;
        lock (Gate)
        {
            Sync(handle, ref error);
            Wake();
        }

        if (error != null)
            ExceptionDispatchInfo.Throw(error);
    }

    public static void CompleteAll()
    {
        for (int i = 1; i < s_Records.Count; i++)
        {
            if (!s_Records[i].IsPending)
                continue;
            try
            {
                Complete(s_Records[i].Handle);
            }
            catch (Exception)
            {
                // Not what the next test is about.
            }
        }
    }

    private static void Wait(JobHandle handle)
    {
        var spinner = new SpinWait();
        while (true)
        {
            lock (Gate)
            {
                JobRecord record = Find(handle);
                if (record == null || record.IsFinished)
                    return;

                // This thread takes one job; the others are for the workers.
                if (s_ReadyCount > 1)
                    Wake();
            }

            if (ExecuteOne())
                spinner.Reset();
            else
                spinner.SpinOnce(-1);
        }
    }

    private static void Sync(JobHandle handle, ref Exception error)
    {
        JobRecord record = Find(handle);
        if (record == null)
            return;
        foreach (JobHandle dependency in record.Dependencies)
            Sync(dependency, ref error);
        error ??= record.Error;
        record.Sync();
        PendingCount--;
        ReuseIfSynced(record);
    }

    private static void RemoveReady(JobRecord record)
    {
        int index = Array.IndexOf(s_Ready, record, 0, s_ReadyCount);
        if (index < 0)
            return;
        s_ReadyCount--;
        Array.Copy(s_Ready, index + 1, s_Ready, index, s_ReadyCount - index);
        s_Ready[s_ReadyCount] = null;
    }

    private static void ReuseIfSynced(JobRecord record)
    {
        if (record.IsSynced && record.Users == 0)
            record.ReturnToPool();
    }
}
