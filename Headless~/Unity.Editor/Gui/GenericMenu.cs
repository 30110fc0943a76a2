using UnityEngine;

namespace UnityEditor;

public sealed class GenericMenu
{
    public delegate void MenuFunction();

    public delegate void MenuFunction2(object userData);

    public bool allowDuplicateNames { get; set; }

    public void AddItem(GUIContent content, bool on, MenuFunction func) => throw Absent.Editor;
    public void AddItem(GUIContent content, bool on, MenuFunction2 func, object userData) => throw Absent.Editor;
    public void AddDisabledItem(GUIContent content) => throw Absent.Editor;
    public void AddSeparator(string path) => throw Absent.Editor;
    public void ShowAsContext() => throw Absent.Editor;
    public void DropDown(Rect position) => throw Absent.Editor;
}
