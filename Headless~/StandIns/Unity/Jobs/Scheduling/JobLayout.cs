using System;
using System.Diagnostics;
using System.Runtime.CompilerServices;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
using Unity.Collections;
#endif

namespace Unity.Jobs;

/// <summary>Knowledge of the safety system about a type of job, and its checks for each job of the type.</summary>
internal sealed unsafe class JobLayout
{
    private readonly JobFields m_Fields;

    private JobLayout(Type type)
    {
        m_Fields = new JobFields(type);
        Name = type.Name;
    }

    public string Name { get; }

    public static JobLayout Of(Type type) => new(type);

    /// <summary>The job that is being executed, and its container of the given number.</summary>
    public static (string Job, string Field) Describe(int container)
    {
        JobLayout layout = JobContext.Layout;
        return layout == null || container >= layout.m_Fields.Containers.Length
            ? ("job", "container")
            : (layout.Name, layout.m_Fields.Containers[container].name);
    }

    public void SetThreadIndex<T>(ref T job)
    {
        foreach (int offset in m_Fields.ThreadIndices)
            Unsafe.As<byte, int>(ref Unsafe.Add(ref Unsafe.As<T, byte>(ref job), offset)) = JobContext.ThreadIndex;
    }

    /// <summary>Throws if a job must not be scheduled or run: for its fields, or for other jobs that use its containers.</summary>
    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    public void Check<T>(ref T job, JobHandle dependency, bool scheduled)
    {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        if (m_Fields.Problem != null)
            throw new InvalidOperationException(m_Fields.Problem);
        fixed (byte* data = &Unsafe.As<T, byte>(ref job))
        {
            for (int i = 0; i < m_Fields.Containers.Length; i++)
            {
                ref readonly JobFields.Container container = ref m_Fields.Containers[i];
                if (!container.exempt)
                    Check(data, container, i, dependency, scheduled);
            }
        }
#endif
    }

    /// <summary>Gives the job's copy of each container the job's rights, and marks the containers as in use.</summary>
    /// <param name="record">Null if the job is run at once.</param>
    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    public void Attach<T>(ref T job, JobRecord record)
    {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        fixed (byte* data = &Unsafe.As<T, byte>(ref job))
        {
            for (int i = 0; i < m_Fields.Containers.Length; i++)
            {
                ref readonly JobFields.Container container = ref m_Fields.Containers[i];
                SafetyHandle* handle = Handle(data, container);
                if (handle->cell == null || (container.exempt && !handle->Exists))
                    continue;
                var safety = ContainerSafety.Of(*handle);
                bool mayRead = container.exempt || (!container.writeOnly && handle->readKey != SafetyHandle.Denied);
                bool mayWrite = container.exempt || (!container.readOnly && handle->writeKey != SafetyHandle.Denied);
                *handle = safety.JobHandle(i, mayRead, mayWrite);
                if (!container.exempt)
                    record?.Use(safety, !container.readOnly);
            }
        }
#endif
    }

    /// <summary>Gives the containers of a job that was run the rights back that they had before.</summary>
    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    public void Detach<T>(ref T job, ref T original)
    {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        fixed (byte* data = &Unsafe.As<T, byte>(ref job), before = &Unsafe.As<T, byte>(ref original))
        {
            foreach (ref readonly JobFields.Container container in m_Fields.Containers.AsSpan())
                *Handle(data, container) = *Handle(before, container);
        }
#endif
    }

    /// <summary>Opens the containers that a parallel job writes at the next index only.</summary>
    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    public void Restrict<T>(ref T job, int index, bool parallel)
    {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        if (!parallel)
            return;
        fixed (byte* data = &Unsafe.As<T, byte>(ref job))
        {
            foreach (int offset in m_Fields.Restricted)
            {
                var array = (NativeArray<byte>*)(data + offset);
                array->m_First = index;
                array->m_Count = index < array->m_Length ? 1 : 0;
            }
        }
#endif
    }

#if ENABLE_UNITY_COLLECTIONS_CHECKS
    private void Check(byte* data, in JobFields.Container container, int index, JobHandle dependency, bool scheduled)
    {
        SafetyHandle* handle = Handle(data, container);
        if (handle->cell == null)
        {
            throw new InvalidOperationException(
                $"{What(container)} has not been created. All containers of a job must be when it is scheduled.");
        }
        if (!handle->Exists)
            throw new ObjectDisposedException(What(container), $"{What(container)} has been disposed of, so the job cannot be scheduled.");
        var safety = ContainerSafety.Of(*handle);
        if (scheduled && safety.IsTemporary)
        {
            throw new InvalidOperationException(
                $"{What(container)} was allocated with Allocator.Temp, so it cannot be passed to a job. Use Allocator.TempJob.");
        }

        bool otherWrites = false;
        JobRecord pending = handle->IsOfJob ? null : safety.FindConflict(!container.readOnly, dependency, out otherWrites);
        if (pending != null)
        {
            throw new InvalidOperationException(
                $"The scheduled job {pending.Name} {(otherWrites ? "writes to" : "reads from")} the {safety.Name} that the new job "
                + $"{(container.readOnly ? "reads from" : "writes to")} as "
                + $"{What(container)}. Make the new job depend on it, or complete it first.");
        }

        for (int i = 0; i < index; i++)
        {
            ref readonly JobFields.Container other = ref m_Fields.Containers[i];
            if (other.exempt || (other.readOnly && container.readOnly) || Handle(data, other)->cell != handle->cell)
                continue;
            throw new InvalidOperationException(
                $"{What(container)} is the same {safety.Name} as {What(other)}, and the job may write it: containers of a job "
                + "must not overlap.");
        }
    }

    private string What(in JobFields.Container container) => $"{Name}.{container.name}";

    private static SafetyHandle* Handle(byte* data, in JobFields.Container container) => container.isView
        ? &((NativeArray<byte>.ReadOnly*)(data + container.offset))->m_Safety
        : &((NativeArray<byte>*)(data + container.offset))->m_Safety;
#endif
}
