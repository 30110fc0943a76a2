using System;
using System.Collections.Generic;
using StandIns;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

public sealed partial class EditorGUI
{
    private static readonly Stack<int> s_Checks = [];

    public static int indentLevel { get; set; }
    public static bool showMixedValue { get; set; }
    public static bool actionKey => Event.current.control;

    public static void BeginChangeCheck() => s_Checks.Push(GuiPage.Needed.Changes);
    public static bool EndChangeCheck() => GuiPage.Needed.Changes > s_Checks.Pop();
    public static GUIContent BeginProperty(Rect totalPosition, GUIContent label, SerializedProperty property) => throw Absent.Editor;
    public static void EndProperty() => throw Absent.Editor;
    public static void BeginDisabledGroup(bool disabled) => throw Absent.Editor;
    public static void EndDisabledGroup() => throw Absent.Editor;
    public static bool PropertyField(Rect position, SerializedProperty property) => PropertyField(position, property, null, false);
    public static bool PropertyField(Rect position, SerializedProperty property, bool includeChildren) =>
        PropertyField(position, property, null, includeChildren);
    public static bool PropertyField(Rect position, SerializedProperty property, GUIContent label) =>
        PropertyField(position, property, label, false);
    public static bool PropertyField(
        Rect position,
        SerializedProperty property,
        GUIContent label,
        bool includeChildren) => DrawnProperty.Draw(position, property, label, includeChildren);
    public static float GetPropertyHeight(SerializedProperty property) => DrawnProperty.HeightOf(property, null, true);
    public static float GetPropertyHeight(SerializedProperty property, bool includeChildren) =>
        DrawnProperty.HeightOf(property, null, includeChildren);
    public static float GetPropertyHeight(SerializedProperty property, GUIContent label) => DrawnProperty.HeightOf(property, label, true);
    public static float GetPropertyHeight(SerializedProperty property, GUIContent label, bool includeChildren) =>
        DrawnProperty.HeightOf(property, label, includeChildren);
    public static float GetPropertyHeight(SerializedPropertyType type, GUIContent label) => throw Absent.Editor;
    public static void LabelField(Rect position, string label) => throw Absent.Editor;
    public static void LabelField(Rect position, string label, GUIStyle style) => throw Absent.Editor;
    public static void LabelField(Rect position, GUIContent label) => throw Absent.Editor;
    public static void LabelField(Rect position, GUIContent label, GUIStyle style) => throw Absent.Editor;
    public static void HelpBox(Rect position, string message, MessageType type) => throw Absent.Editor;
    public static bool Foldout(Rect position, bool foldout, string content, bool toggleOnLabelClick) => throw Absent.Editor;
    public static bool Foldout(Rect position, bool foldout, GUIContent content, bool toggleOnLabelClick) =>
        GuiPage.Needed.Add(ControlKind.Foldout, position, content) != foldout;
    public static bool Toggle(Rect position, string label, bool value) => throw Absent.Editor;
    public static bool Toggle(Rect position, GUIContent label, bool value) => throw Absent.Editor;
    public static float FloatField(Rect position, string label, float value) => throw Absent.Editor;
    public static float FloatField(Rect position, GUIContent label, float value) => throw Absent.Editor;
    public static int IntField(Rect position, string label, int value) => throw Absent.Editor;
    public static int IntField(Rect position, GUIContent label, int value) => throw Absent.Editor;
    public static float Slider(Rect position, float value, float leftValue, float rightValue) => throw Absent.Editor;
    public static float Slider(Rect position, string label, float value, float leftValue, float rightValue) => throw Absent.Editor;
    public static void Slider(Rect position, SerializedProperty property, float leftValue, float rightValue) => throw Absent.Editor;
    public static void Slider(
        Rect position,
        SerializedProperty property,
        float leftValue,
        float rightValue,
        string label) => throw Absent.Editor;
    public static void Slider(
        Rect position,
        SerializedProperty property,
        float leftValue,
        float rightValue,
        GUIContent label) => DrawnProperty.Slide(position, property, leftValue, rightValue, label);
    public static float Slider(Rect position, GUIContent label, float value, float leftValue, float rightValue) => throw Absent.Editor;
    public static int Popup(Rect position, string label, int selectedIndex, string[] displayedOptions) => throw Absent.Editor;
    public static int Popup(Rect position, GUIContent label, int selectedIndex, GUIContent[] displayedOptions) => throw Absent.Editor;
    public static Object ObjectField(Rect position, string label, Object obj, Type objType, bool allowSceneObjects) => throw Absent.Editor;
    public static Object ObjectField(
        Rect position,
        string label,
        Object obj,
        Type objType,
        Object targetBeingEdited) => throw Absent.Editor;
    public static void ObjectField(Rect position, SerializedProperty property, Type objType) => throw Absent.Editor;
    public static void ObjectField(Rect position, SerializedProperty property, Type objType, GUIContent label) => throw Absent.Editor;
    public static void ObjectField(Rect position, SerializedProperty property, GUIContent label) => throw Absent.Editor;
    public static Object ObjectField(
        Rect position,
        GUIContent label,
        Object obj,
        Type objType,
        bool allowSceneObjects) => throw Absent.Editor;
    public static Object ObjectField(
        Rect position,
        GUIContent label,
        Object obj,
        Type objType,
        Object targetBeingEdited) => throw Absent.Editor;
    public static void DrawRect(Rect rect, Color color) =>
        GuiPage.Needed.Add(ControlKind.Area, rect, GUIContent.none, color.ToString());
    public static void ProgressBar(Rect position, float value, string text) =>
        GuiPage.Needed.Add(ControlKind.Area, position, new GUIContent(text),
            value.ToString(System.Globalization.CultureInfo.InvariantCulture));
    public static Rect PrefixLabel(Rect totalPosition, int id, GUIContent label) => throw Absent.Editor;
    public static Rect PrefixLabel(Rect totalPosition, int id, GUIContent label, GUIStyle style) => throw Absent.Editor;
    public static Rect PrefixLabel(Rect totalPosition, GUIContent label) => throw Absent.Editor;
    public static Rect PrefixLabel(Rect totalPosition, GUIContent label, GUIStyle style) => throw Absent.Editor;
    public static Rect IndentedRect(Rect source) => throw Absent.Editor;
    public static void DropShadowLabel(Rect position, string text) => throw Absent.Editor;
    public static void DropShadowLabel(Rect position, string text, GUIStyle style) => throw Absent.Editor;
    public static void DropShadowLabel(Rect position, GUIContent content) => throw Absent.Editor;
    public static void DropShadowLabel(Rect position, GUIContent content, GUIStyle style) => throw Absent.Editor;
}
