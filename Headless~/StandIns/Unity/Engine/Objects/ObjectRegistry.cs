using System;
using System.Collections.Generic;

namespace UnityEngine;

/// <summary>All objects that were made and not yet destroyed. As in Unity, forgetting an object does not end it.</summary>
internal static class ObjectRegistry
{
    private static readonly object s_Gate = new();
    private static readonly SortedDictionary<int, Object> s_Alive = [];
    private static int s_Made;

    public static int Add(Object made)
    {
        lock (s_Gate)
        {
            int id = ++s_Made;
            s_Alive.Add(id, made);
            return -2 * id;
        }
    }

    public static void Remove(Object destroyed)
    {
        lock (s_Gate)
            s_Alive.Remove(destroyed.GetInstanceID() / -2);
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
        var found = new List<T>();
        lock (s_Gate)
        {
            foreach (Object o in s_Alive.Values)
            {
                if (type.IsInstanceOfType(o) && o is T t && (chosen == null || chosen(t)))
                    found.Add(t);
            }
        }

        return found;
    }
}
