using System;

namespace UnityEditor;

public class CustomEditor : Attribute
{
    public CustomEditor(Type inspectedType) => Inspected = inspectedType;

    public CustomEditor(Type inspectedType, bool editorForChildClasses) : this(inspectedType)
    {
    }

    internal Type Inspected { get; }

    public bool isFallback { get; set; }
}
