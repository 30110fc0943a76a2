using System.Collections.Generic;

namespace UnityEngine;

/// <summary>Objects that Object.Destroy has named and the end of a frame will destroy.</summary>
internal static class Doomed
{
    private static readonly List<(Object Target, double When)> s_Waiting = [];

    public static void Add(Object target, float delay) => s_Waiting.Add((target, Time.timeAsDouble + delay));

    /// <summary>Ends those whose time has come, also those that are named meanwhile.</summary>
    public static void End()
    {
        for (int i = 0; i < s_Waiting.Count; i++)
        {
            (Object target, double when) = s_Waiting[i];
            if (when > Time.timeAsDouble)
                continue;
            s_Waiting.RemoveAt(i--);
            if (!target.IsDestroyed)
                Lifecycle.Destroy(target);
        }
    }

    public static void Forget() => s_Waiting.Clear();
}
