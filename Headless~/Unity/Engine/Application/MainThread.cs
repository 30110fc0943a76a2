using System;
using UnityEngine;

namespace Unity.StandIns;

/// <summary>The thread on which most of UnityEngine may be used: the first that does, or the last that adopted the role.</summary>
[StandInExtension]
public static class MainThread
{
    private static int s_Id;

    internal static bool IsCurrent => s_Id == 0 || s_Id == Environment.CurrentManagedThreadId;

    /// <summary>Makes the calling thread the main thread.</summary>
    public static void Adopt() => s_Id = Environment.CurrentManagedThreadId;

    /// <exception cref="UnityException">The calling thread is another one.</exception>
    internal static void Check(string member)
    {
        int current = Environment.CurrentManagedThreadId;
        if (s_Id == current)
            return;
        if (s_Id != 0)
            Refuse(member);
        s_Id = current;
    }

    private static void Refuse(string member) => throw new UnityException(
        $"{member} can only be called from the main thread. Use a job for what may run elsewhere, and objects only on the main thread.");
}
