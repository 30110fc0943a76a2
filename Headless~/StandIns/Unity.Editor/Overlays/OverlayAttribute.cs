using System;

namespace UnityEditor.Overlays;

[AttributeUsage(AttributeTargets.Class)]
public sealed class OverlayAttribute : Attribute
{
    public OverlayAttribute(Type editorWindowType, string id, string displayName, bool defaultDisplay = false)
    {
    }
}
