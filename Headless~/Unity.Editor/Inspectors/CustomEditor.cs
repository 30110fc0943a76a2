using System;

namespace UnityEditor;

public class CustomEditor : Attribute
{
    public CustomEditor(Type inspectedType)
    {
    }

    public CustomEditor(Type inspectedType, bool editorForChildClasses)
    {
    }

    public bool isFallback { get; set; }
}
