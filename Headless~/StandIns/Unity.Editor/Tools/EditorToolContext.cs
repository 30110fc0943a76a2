using System;
using System.Collections.Generic;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor.EditorTools;

public abstract class EditorToolContext : ScriptableObject
{
    public Object target { get; }
    public IEnumerable<Object> targets { get; }

    public virtual void OnToolGUI(EditorWindow window)
    {
    }

    public virtual void OnActivated()
    {
    }

    public virtual void OnWillBeDeactivated()
    {
    }

    protected virtual Type GetEditorToolType(Tool tool) => null;
    public virtual IEnumerable<Type> GetAdditionalToolTypes() => null;
    public Type ResolveTool(Tool tool) => throw Absent.Editor;
}
