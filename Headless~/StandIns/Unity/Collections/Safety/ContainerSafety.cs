using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using Unity.Jobs;

namespace Unity.Collections;

/// <summary>The safety system's view of one container's memory: whether it is alive, and which pending jobs use it.</summary>
internal sealed unsafe class ContainerSafety
{
    private struct Cells
    {
        public SafetyCell main;
        public SafetyCell job;
    }

    private struct User
    {
        public JobRecord job;
        public bool writes;
    }

    // Versions are even: the lowest bit of a cell says that pending jobs use the container.
    private const int k_Step = 2;

    private static readonly List<ContainerSafety> s_All = [];
    private static readonly Stack<ContainerSafety> s_Free = [];

    private readonly Cells* m_Cells;
    private int m_Version;
    private User[] m_Users = new User[4];
    private int m_UserCount;
    private bool m_IsReleased;

    private ContainerSafety(int index)
    {
        // Stays for the life of the process, so that stale handles can always be recognised.
        m_Cells = (Cells*)NativeMemory.AllocZeroed((nuint)sizeof(Cells));
        m_Cells->main.container = m_Cells->job.container = index;
        m_Version = k_Step;
        OpenMain();
        OpenJobs();
    }

    public string Name { get; private set; }

    public bool IsTemporary { get; private set; }

    public static ContainerSafety Create(string name, Allocator allocator)
    {
        lock (s_All)
        {
            if (!s_Free.TryPop(out ContainerSafety safety))
            {
                safety = new ContainerSafety(s_All.Count);
                s_All.Add(safety);
            }

            safety.Name = name;
            safety.IsTemporary = allocator == Allocator.Temp;
            return safety;
        }
    }

    public static ContainerSafety Of(in SafetyHandle handle)
    {
        lock (s_All)
            return s_All[handle.cell->container];
    }

    public SafetyHandle Handle() => new()
    {
        cell = &m_Cells->main,
        readKey = m_Version,
        writeKey = m_Version,
        version = m_Version,
        slot = SafetyHandle.MainThread,
    };

    public SafetyHandle JobHandle(int slot, bool mayRead, bool mayWrite) => new()
    {
        cell = &m_Cells->job,
        readKey = mayRead ? m_Version : SafetyHandle.Denied,
        writeKey = mayWrite ? m_Version : SafetyHandle.Denied,
        version = m_Version,
        slot = slot,
    };

    /// <summary>The memory is about to be freed: no handle is valid any more.</summary>
    public void Release()
    {
        ReleaseMain();
        ReleaseJobs();
    }

    /// <summary>The main thread's handles end; a job that still runs keeps its own.</summary>
    public void ReleaseMain()
    {
        m_Version += k_Step;
        OpenMain();
    }

    public void ReleaseJobs()
    {
        OpenJobs();
        m_IsReleased = true;
        ReuseIfUnused();
    }

    public void AddUser(JobRecord job, bool writes)
    {
        if (m_UserCount == m_Users.Length)
            Array.Resize(ref m_Users, 2 * m_UserCount);
        m_Users[m_UserCount++] = new User { job = job, writes = writes };
        UpdateBlocked();
    }

    public void RemoveUser(JobRecord job)
    {
        for (int i = m_UserCount - 1; i >= 0; i--)
        {
            if (m_Users[i].job != job)
                continue;
            m_Users[i] = m_Users[--m_UserCount];
            m_Users[m_UserCount] = default;
        }

        UpdateBlocked();
        ReuseIfUnused();
    }

    /// <summary>A pending job that a reader or a writer would have to wait for and does not depend on; null if none.</summary>
    public JobRecord FindConflict(bool writes, JobHandle dependency, out bool otherWrites)
    {
        for (int i = 0; i < m_UserCount; i++)
        {
            otherWrites = m_Users[i].writes;
            if ((writes || otherWrites) && !JobTable.DependsOn(dependency, m_Users[i].job))
                return m_Users[i].job;
        }

        otherWrites = false;
        return null;
    }

    private void ReuseIfUnused()
    {
        lock (s_All)
        {
            if (!m_IsReleased || m_UserCount > 0)
                return;
            m_IsReleased = false;
            s_Free.Push(this);
        }
    }

    private void UpdateBlocked()
    {
        OpenMain();
        for (int i = 0; i < m_UserCount; i++)
        {
            m_Cells->main.write = m_Version | 1;
            if (m_Users[i].writes)
                m_Cells->main.read = m_Version | 1;
        }
    }

    private void OpenMain() => m_Cells->main.read = m_Cells->main.write = m_Version;

    private void OpenJobs() => m_Cells->job.read = m_Cells->job.write = m_Version;
}
