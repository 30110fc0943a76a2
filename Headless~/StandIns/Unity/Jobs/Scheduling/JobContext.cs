using System;
using System.Diagnostics;

namespace Unity.Jobs;

/// <summary>Job that the present thread executes.</summary>
internal static class JobContext
{
    [ThreadStatic]
    private static JobLayout s_Layout;

    /// <summary>0 on the main thread, from 1 on for workers.</summary>
    [field: ThreadStatic]
    public static int ThreadIndex { get; private set; }

    /// <summary>The type of job that is being executed; null outside of jobs.</summary>
    public static JobLayout Layout => s_Layout;

    public static void SetThread(int index) => ThreadIndex = index;

    public static JobLayout Enter(JobLayout layout)
    {
        JobLayout before = s_Layout;
        s_Layout = layout;
        return before;
    }

    public static void Leave(JobLayout before) => s_Layout = before;

    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    public static void CheckOutside(string action)
    {
        if (s_Layout != null)
            throw new InvalidOperationException($"The job {s_Layout.Name} tries to {action}; that is for the main thread only.");
    }
}
