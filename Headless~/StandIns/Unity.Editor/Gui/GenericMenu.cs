using System.Collections.Generic;
using StandIns;
using UnityEngine;

namespace UnityEditor;

public sealed class GenericMenu
{
    private readonly List<(string Label, MenuFunction Act)> _items = [];

    public delegate void MenuFunction();

    public void AddItem(GUIContent content, bool on, MenuFunction func) => _items.Add((content.text, func));
    public void AddSeparator(string path) => _items.Add(("", null));

    /// <summary>Hands the menu to the test that opened it.</summary>
    public void ShowAsContext() => ShownMenu.Show(_items);
}
