using System;

namespace UnityEditor.EditorTools;

[System.AttributeUsage(System.AttributeTargets.Class)]
public sealed class EditorToolAttribute : ToolAttribute
{
    public EditorToolAttribute(string displayName, Type componentToolTarget = null)
    {
    }

    public EditorToolAttribute(string displayName, Type componentToolTarget, Type editorToolContext)
    {
    }
}
