using System;

namespace UnityEngine;

/// <summary>The only thread that may use objects and the clock: the one that did so first, or took the part over.</summary>
internal static class MainThread
{
    private static int s_Id;

    /// <summary>Makes the calling thread the main thread: a frame runs, or a test, on it.</summary>
    public static void Adopt() => s_Id = Environment.CurrentManagedThreadId;

    /// <exception cref="UnityException">The calling thread is another.</exception>
    public static void Check(string member)
    {
        int current = Environment.CurrentManagedThreadId;
        if (s_Id == current)
            return;
        if (s_Id != 0)
            throw new UnityException($"{member} can only be called from the main thread.");
        s_Id = current;
    }
}
