using System.Collections.Generic;
using UnityEngine;

namespace UnityEditor.EditorTools;

public abstract class EditorTool : ScriptableObject
{
    public Object target { get; }
    public IEnumerable<Object> targets => StandIns.ChosenTargets.All;
    public virtual GUIContent toolbarIcon { get; }
    public virtual bool gridSnapEnabled { get; }

    public virtual void OnToolGUI(EditorWindow window)
    {
    }

    public virtual void OnActivated()
    {
    }

    public virtual void OnWillBeDeactivated()
    {
    }

    public virtual bool IsAvailable() => true;
}
