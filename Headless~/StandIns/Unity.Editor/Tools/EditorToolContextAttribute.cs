using System;

namespace UnityEditor.EditorTools;

[System.AttributeUsage(System.AttributeTargets.Class)]
public class EditorToolContextAttribute : ToolAttribute
{
    public EditorToolContextAttribute(string displayName = "", Type targetType = null)
    {
    }
}
