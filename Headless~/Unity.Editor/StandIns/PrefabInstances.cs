using System;
using System.Collections.Generic;
using Object = UnityEngine.Object;

namespace StandIns;

/// <summary>Objects that a test declares to be instances of prefabs, and of which overrides were recorded.</summary>
[Unity.StandIns.StandInExtension]
public static class PrefabInstances
{
    private static readonly HashSet<Object> s_Instances = [];
    private static readonly HashSet<Object> s_Recorded = [];

    /// <summary>From now on the object is part of an instance of a prefab.</summary>
    public static void Declare(Object part) => s_Instances.Add(part);

    /// <summary>Whether overrides of the object were recorded since it was declared.</summary>
    public static bool HasOverrides(Object part) => s_Recorded.Contains(part);

    internal static bool Contains(Object part) => s_Instances.Contains(part);

    internal static void Record(Object part)
    {
        ArgumentNullException.ThrowIfNull(part);
        s_Recorded.Add(part);
    }
}
