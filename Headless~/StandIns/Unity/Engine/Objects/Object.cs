using System.Runtime.CompilerServices;

namespace UnityEngine;

/// <summary>The base of everything with a native side: destroyed objects compare equal to null, and using one throws.</summary>
public partial class Object
{
    private readonly int _instanceId;
    private bool _destroyed;
    private string _name = "";
    private HideFlags _hideFlags;

    public Object()
    {
        MainThread.Check(GetType().Name);
        _instanceId = ObjectRegistry.Add(this);
    }

    public string name
    {
        get
        {
            CheckAlive();
            return Name;
        }
        set
        {
            CheckAlive();
            Name = value ?? "";
        }
    }

    public HideFlags hideFlags
    {
        get
        {
            CheckAlive();
            return _hideFlags;
        }
        set
        {
            CheckAlive();
            _hideFlags = value;
        }
    }

    private protected virtual string Name
    {
        get => _name;
        set => _name = value;
    }

    internal bool IsDestroyed => _destroyed;

    public static implicit operator bool(Object exists) => !IsNull(exists);
    public static bool operator ==(Object x, Object y) => IsNull(x) ? IsNull(y) : ReferenceEquals(x, y);
    public static bool operator !=(Object x, Object y) => !(x == y);

    public int GetInstanceID() => _instanceId;

    public override bool Equals(object other) => other is Object o ? this == o : other == null && IsNull(this);
    public override int GetHashCode() => _instanceId;
    public override string ToString() => IsNull(this) ? "null" : $"{Name} ({GetType().FullName})";

    /// <summary>Turns the object into a fake null; what must be told or freed before is the caller's.</summary>
    internal void MarkDestroyed()
    {
        if (_destroyed)
            return;
        _destroyed = true;
        ObjectRegistry.Remove(this);
        Released();
    }

    /// <summary>The native side is gone.</summary>
    private protected virtual void Released()
    {
    }

    private protected void CheckAlive([CallerMemberName] string member = null)
    {
        MainThread.Check(member);
        if (_destroyed)
        {
            throw new MissingReferenceException(
                $"The object of type '{GetType().Name}' has been destroyed but you are still trying to access it.\n"
                + "Your script should either check if it is null or you should not destroy the object.");
        }
    }

    private static bool IsNull(Object o) => o is null || o._destroyed;
}
