using System;
using System.Collections.Generic;
using UnityEngine;
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

    /// <summary>Returns true where overrides of the object were recorded since it was declared.</summary>
    public static bool HasOverrides(Object part) => s_Recorded.Contains(part);

    /// <summary>An instance, all of it declared.</summary>
    internal static GameObject Make(GameObject prefab)
    {
        if (ProjectAssets.PathOf(prefab).Length == 0)
            throw new ArgumentException($"'{prefab.name}' is no prefab asset.", nameof(prefab));
        GameObject made = Object.Instantiate(prefab);
        made.name = prefab.name;
        foreach (Transform part in made.GetComponentsInChildren<Transform>(true))
        {
            Declare(part.gameObject);
            foreach (Component component in part.GetComponents<Component>())
                Declare(component);
        }

        return made;
    }

    internal static bool Contains(Object part) => s_Instances.Contains(part);

    internal static void Record(Object part)
    {
        ArgumentNullException.ThrowIfNull(part);
        s_Recorded.Add(part);
    }
}
