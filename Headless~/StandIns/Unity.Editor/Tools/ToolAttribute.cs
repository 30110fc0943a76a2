using System;

namespace UnityEditor.EditorTools;

public abstract class ToolAttribute : Attribute
{
    public string displayName { get; }
    public Type targetType { get; }
    public Type targetContext { get; }
}
