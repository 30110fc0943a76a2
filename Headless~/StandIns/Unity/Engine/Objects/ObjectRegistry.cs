using System;
using System.Collections.Generic;

namespace UnityEngine;

/// <summary>All objects that were made and not yet destroyed. As in Unity, forgetting an object does not end it.</summary>
internal static class ObjectRegistry
{
    private static readonly object s_Gate = new();
    private static readonly Dictionary<int, Object> s_Alive = [];

    // A scene has many objects of many types, and is asked for those of one all the time.
    private static readonly Dictionary<Type, SortedDictionary<int, Object>> s_ByType = [];
    private static int s_Made;

    public static int Add(Object made)
    {
        lock (s_Gate)
        {
            int id = ++s_Made;
            s_Alive.Add(id, made);
            if (!s_ByType.TryGetValue(made.GetType(), out SortedDictionary<int, Object> alike))
                s_ByType.Add(made.GetType(), alike = []);
            alike.Add(id, made);
            return -2 * id;
        }
    }

    public static void Remove(Object destroyed)
    {
        lock (s_Gate)
        {
            int id = destroyed.GetInstanceID() / -2;
            if (s_Alive.Remove(id))
                s_ByType[destroyed.GetType()].Remove(id);
        }
    }

    /// <summary>The living object with an instance's number; null for none.</summary>
    public static Object Get(int instance)
    {
        lock (s_Gate)
            return s_Alive.GetValueOrDefault(instance / -2);
    }

    /// <summary>All living objects of a type, oldest first.</summary>
    public static List<T> Find<T>(Type type, Predicate<T> chosen = null) where T : Object
    {
        var found = new List<(int Id, T Object)>();
        int types = 0;
        lock (s_Gate)
        {
            foreach ((Type kind, SortedDictionary<int, Object> alike) in s_ByType)
            {
                if (alike.Count == 0 || !type.IsAssignableFrom(kind))
                    continue;
                types++;
                foreach ((int id, Object o) in alike)
                {
                    if (o is T t && (chosen == null || chosen(t)))
                        found.Add((id, t));
                }
            }
        }

        if (types > 1)
            found.Sort((a, b) => a.Id.CompareTo(b.Id));
        return found.ConvertAll(one => one.Object);
    }
}
