using System;
using System.Collections.Generic;
using System.Reflection;

namespace UnityEngine;

/// <summary>Static methods that run when play begins.</summary>
internal static class LoadMethods
{
    private static readonly Dictionary<Assembly, List<(RuntimeInitializeLoadType Moment, Action Method)>> s_Known = [];

    public static void Run(RuntimeInitializeLoadType moment)
    {
        foreach (Assembly assembly in AppDomain.CurrentDomain.GetAssemblies())
        {
            if (!s_Known.TryGetValue(assembly, out List<(RuntimeInitializeLoadType Moment, Action Method)> methods))
                s_Known.Add(assembly, methods = Find(assembly));
            foreach ((RuntimeInitializeLoadType when, Action method) in methods)
            {
                if (when == moment)
                    Call(method);
            }
        }
    }

    private static void Call(Action method)
    {
        try
        {
            method();
        }
        catch (Exception e)
        {
            Debug.LogException(e);
        }
    }

    private static List<(RuntimeInitializeLoadType Moment, Action Method)> Find(Assembly assembly)
    {
        var found = new List<(RuntimeInitializeLoadType, Action)>();
        string engine = typeof(LoadMethods).Assembly.GetName().Name;
        if (!Array.Exists(assembly.GetReferencedAssemblies(), a => a.Name == engine))
            return found;
        const BindingFlags own = BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;
        foreach (Type type in assembly.GetTypes())
        {
            if (type.ContainsGenericParameters)
                continue;
            foreach (MethodInfo method in type.GetMethods(own))
            {
                if (method.GetCustomAttribute<RuntimeInitializeOnLoadMethodAttribute>() is { } attribute)
                    found.Add((attribute.loadType, method.CreateDelegate<Action>()));
            }
        }

        return found;
    }
}
