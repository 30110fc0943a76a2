using System;
using System.Globalization;
using System.Linq;
using System.Reflection;
using StandIns;
using UnityEngine;

namespace UnityEditor;

/// <summary>Draws a property as the inspector does: by its drawer, or its fields one below the other.</summary>
internal static class DrawnProperty
{
    private const float k_Line = 18f, k_Gap = 2f;

    public static float HeightOf(SerializedProperty property, GUIContent label, bool includeChildren)
    {
        if (Custom.DrawerOf(property.Type) is { } drawer)
            return drawer.GetPropertyHeight(property, label ?? LabelOf(property));
        if (!IsOpen(property, includeChildren))
            return k_Line;
        return k_Line + property.Children().Sum(child => k_Gap + HeightOf(child, null, true));
    }

    public static bool Draw(Rect position, SerializedProperty property, GUIContent label, bool includeChildren)
    {
        label ??= LabelOf(property);
        float height = HeightOf(property, label, includeChildren);
        if (Math.Abs(position.height - height) > 0.5f)
            throw new InvalidOperationException($"'{property.propertyPath}' is {height} high and was given {position.height}.");
        if (Custom.DrawerOf(property.Type) is { } drawer)
        {
            GuiPage.Needed.Begin("drawer");
            drawer.OnGUI(position, property, label);
            GuiPage.Needed.End("drawer");
            return false;
        }

        var line = new Rect(position.x, position.y, position.width, k_Line);
        bool hasChildren = property.Node.Children != null && property.propertyType == SerializedPropertyType.Generic;
        RangeAttribute range = property.Node.Field?.GetCustomAttribute<RangeAttribute>();
        if (range != null && !hasChildren)
            Slide(line, property, range.min, range.max, label);
        else if (GuiPage.Needed.Add(hasChildren ? ControlKind.Foldout : ControlKind.Field, line, label, ValueOf(property)))
            property.isExpanded = !property.isExpanded;
        if (!IsOpen(property, includeChildren))
            return false;
        foreach (SerializedProperty child in property.Children())
        {
            line = new Rect(line.x, line.yMax + k_Gap, line.width, HeightOf(child, null, true));
            Draw(line, child, null, true);
        }

        return false;
    }

    /// <summary>A slider for a number.</summary>
    public static void Slide(Rect position, SerializedProperty property, float left, float right, GUIContent label)
    {
        if (property.propertyType is not (SerializedPropertyType.Float or SerializedPropertyType.Integer))
            throw new InvalidOperationException($"'{property.propertyPath}' is no number to slide.");
        string value = property.hasMultipleDifferentValues ? ValueOf(property) : $"{ValueOf(property)} of {left} to {right}";
        GuiPage.Needed.Add(ControlKind.Field, position, label, value);
    }

    private static bool IsOpen(SerializedProperty property, bool includeChildren) =>
        includeChildren && property.isExpanded && property.hasVisibleChildren && property.propertyType == SerializedPropertyType.Generic;

    private static GUIContent LabelOf(SerializedProperty property) => new(property.displayName, property.tooltip);

    private static string ValueOf(SerializedProperty property)
    {
        if (property.hasMultipleDifferentValues)
            return "—";
        return property.Node.Children == null ? Convert.ToString(property.Node.Value, CultureInfo.InvariantCulture) : "";
    }
}
