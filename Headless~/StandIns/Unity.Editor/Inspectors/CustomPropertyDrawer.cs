using System;

namespace UnityEditor;

[System.AttributeUsage(System.AttributeTargets.Class, AllowMultiple = true)]
public sealed class CustomPropertyDrawer : Attribute
{
    public CustomPropertyDrawer(Type type) => Drawn = type;

    public CustomPropertyDrawer(Type type, bool useForChildren) : this(type)
    {
    }

    internal Type Drawn { get; }
}
