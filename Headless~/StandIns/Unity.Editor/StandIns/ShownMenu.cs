using System.Collections.Generic;
using System.Linq;
using UnityEditor;

namespace StandIns;

/// <summary>The context menu that was opened last.</summary>
public static class ShownMenu
{
    private static List<(string Label, GenericMenu.MenuFunction Act)> s_Items = [];

    /// <summary>Lines of the menu; separators are empty.</summary>
    public static IEnumerable<string> Lines => s_Items.Select(item => item.Label);

    /// <summary>Chooses the only line with a text.</summary>
    public static void Choose(string line) => s_Items.Single(item => item.Label == line).Act();

    /// <summary>Forgets the menu.</summary>
    public static void Clear() => s_Items = [];

    internal static void Show(List<(string Label, GenericMenu.MenuFunction Act)> items) => s_Items = items;
}
