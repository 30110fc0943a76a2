using System;

namespace UnityEngine;

/// <summary>The base of everything with a native side: destroyed objects compare equal to null, and using one throws.</summary>
public class Object
{
    private bool _destroyed;
    private string _name = "";

    public string name
    {
        get
        {
            CheckAlive();
            return _name;
        }
        set
        {
            CheckAlive();
            _name = value;
        }
    }

    public HideFlags hideFlags { get; set; }

    public static implicit operator bool(Object exists) => !IsNull(exists);
    public static bool operator ==(Object x, Object y) => IsNull(x) ? IsNull(y) : ReferenceEquals(x, y);
    public static bool operator !=(Object x, Object y) => !(x == y);

    public static void DestroyImmediate(Object obj)
    {
        if (!IsNull(obj))
            obj._destroyed = true;
    }

    public override bool Equals(object other) => other is Object o ? this == o : other == null && IsNull(this);
    public override int GetHashCode() => System.Runtime.CompilerServices.RuntimeHelpers.GetHashCode(this);
    public override string ToString() => IsNull(this) ? "null" : $"{_name} ({GetType().FullName})";

    private protected void CheckAlive()
    {
        if (_destroyed)
            throw new MissingReferenceException($"The object of type '{GetType().Name}' has been destroyed but you are still trying to access it.");
    }

    private static bool IsNull(Object o) => o is null || o._destroyed;
}

public class MissingReferenceException(string message) : SystemException(message);

[Flags]
public enum HideFlags
{
    None = 0,
    HideInHierarchy = 1,
    HideInInspector = 2,
    DontSaveInEditor = 4,
    NotEditable = 8,
    DontSaveInBuild = 16,
    DontUnloadUnusedAsset = 32,
    DontSave = 52,
    HideAndDontSave = 61,
}
