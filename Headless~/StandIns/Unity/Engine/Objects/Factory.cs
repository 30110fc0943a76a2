using System;

namespace UnityEngine;

/// <summary>Makes what scripts may not make with "new", and tells when they do.</summary>
internal static class Factory
{
    private static Type s_Expected;

    public static T Make<T>(Type type) where T : Object
    {
        s_Expected = type;
        try
        {
            return (T)Activator.CreateInstance(type, nonPublic: true);
        }
        finally
        {
            s_Expected = null;
        }
    }

    /// <summary>Called by the constructor of a component or asset; false, and a warning, if a script called that itself.</summary>
    public static bool Announce(Object made, string advice)
    {
        Type type = made.GetType();
        bool expected = s_Expected == type;
        s_Expected = null;
        if (expected || type.Assembly == typeof(Object).Assembly)
            return true;
        Debug.LogWarning($"You are trying to create a {type.Name} using the 'new' keyword. This is not allowed. {advice}");
        return false;
    }
}
