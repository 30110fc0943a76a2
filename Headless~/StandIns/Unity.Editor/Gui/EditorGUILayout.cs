using System;
using StandIns;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

public sealed partial class EditorGUILayout
{
    public static bool PropertyField(
        SerializedProperty property,
        bool includeChildren,
        params GUILayoutOption[] options) => Field(property, null, includeChildren);
    public static bool PropertyField(
        SerializedProperty property,
        GUIContent label,
        bool includeChildren,
        params GUILayoutOption[] options) => Field(property, label, includeChildren);
    public static bool PropertyField(
        SerializedProperty property,
        GUIContent label,
        params GUILayoutOption[] options) => Field(property, label, true);
    public static bool PropertyField(SerializedProperty property, params GUILayoutOption[] options) => Field(property, null, true);
    public static void HelpBox(string message, MessageType type) => Add(ControlKind.HelpBox, new GUIContent(message), type.ToString());
    public static void HelpBox(string message, MessageType type, bool wide) => throw Absent.Editor;
    public static void HelpBox(GUIContent content, bool wide = true) => throw Absent.Editor;
    public static void LabelField(string label, string label2, params GUILayoutOption[] options) => throw Absent.Editor;
    public static void LabelField(string label, string label2, GUIStyle style, params GUILayoutOption[] options) =>
        Add(ControlKind.Label, new GUIContent(label), label2);
    public static void LabelField(string label, params GUILayoutOption[] options) => Add(ControlKind.Label, new GUIContent(label));
    public static void LabelField(string label, GUIStyle style, params GUILayoutOption[] options) =>
        Add(ControlKind.Label, new GUIContent(label));
    public static void LabelField(GUIContent label, GUIContent label2, params GUILayoutOption[] options) =>
        Add(ControlKind.Label, label, label2.text);
    public static void LabelField(
        GUIContent label,
        GUIContent label2,
        GUIStyle style,
        params GUILayoutOption[] options) => throw Absent.Editor;
    public static void LabelField(GUIContent label, params GUILayoutOption[] options) => Add(ControlKind.Label, label);
    public static void LabelField(GUIContent label, GUIStyle style, params GUILayoutOption[] options) => Add(ControlKind.Label, label);
    public static bool Foldout(bool foldout, string content, bool toggleOnLabelClick) => throw Absent.Editor;
    public static bool Foldout(bool foldout, string content, bool toggleOnLabelClick, GUIStyle style) => throw Absent.Editor;
    public static bool Foldout(bool foldout, GUIContent content, bool toggleOnLabelClick) => throw Absent.Editor;
    public static bool Foldout(bool foldout, GUIContent content, bool toggleOnLabelClick, GUIStyle style) =>
        Add(ControlKind.Foldout, content) != foldout;
    public static bool BeginFoldoutHeaderGroup(
        bool foldout,
        string content,
        GUIStyle style = null,
        Action<Rect> menuAction = null,
        GUIStyle menuIcon = null) => throw Absent.Editor;
    public static bool BeginFoldoutHeaderGroup(
        bool foldout,
        GUIContent content,
        GUIStyle style = null,
        Action<Rect> menuAction = null,
        GUIStyle menuIcon = null) => throw Absent.Editor;
    public static void EndFoldoutHeaderGroup() => throw Absent.Editor;
    public static Rect BeginHorizontal(params GUILayoutOption[] options) => throw Absent.Editor;
    public static Rect BeginHorizontal(GUIStyle style, params GUILayoutOption[] options) => throw Absent.Editor;
    public static void EndHorizontal() => throw Absent.Editor;
    public static Rect BeginVertical(params GUILayoutOption[] options) => throw Absent.Editor;
    public static Rect BeginVertical(GUIStyle style, params GUILayoutOption[] options) => throw Absent.Editor;
    public static void EndVertical() => throw Absent.Editor;
    public static void Space() => GuiPage.Needed.Next(6f);
    public static void Space(float width) => throw Absent.Editor;
    public static void Space(float width, bool expand) => throw Absent.Editor;
    public static void Separator() => throw Absent.Editor;
    public static bool Toggle(string label, bool value, params GUILayoutOption[] options) =>
        Toggle(new GUIContent(label), value, options);
    public static bool Toggle(GUIContent label, bool value, params GUILayoutOption[] options) =>
        Add(ControlKind.Toggle, label, value ? "on" : "off") != value;
    public static float FloatField(string label, float value, params GUILayoutOption[] options) => throw Absent.Editor;
    public static float FloatField(GUIContent label, float value, params GUILayoutOption[] options) => Field(label, value);
    public static int IntField(string label, int value, params GUILayoutOption[] options) => throw Absent.Editor;
    public static int IntField(GUIContent label, int value, params GUILayoutOption[] options) => Field(label, value);
    public static float Slider(
        string label,
        float value,
        float leftValue,
        float rightValue,
        params GUILayoutOption[] options) => throw Absent.Editor;
    public static void Slider(
        SerializedProperty property,
        float leftValue,
        float rightValue,
        string label,
        params GUILayoutOption[] options) => throw Absent.Editor;
    public static void Slider(
        SerializedProperty property,
        float leftValue,
        float rightValue,
        GUIContent label,
        params GUILayoutOption[] options) => throw Absent.Editor;
    public static void Slider(
        SerializedProperty property,
        float leftValue,
        float rightValue,
        params GUILayoutOption[] options) => throw Absent.Editor;
    public static float Slider(
        GUIContent label,
        float value,
        float leftValue,
        float rightValue,
        params GUILayoutOption[] options)
    {
        return Mathf.Clamp(Field(label, value), leftValue, rightValue);
    }

    public static int IntSlider(
        string label,
        int value,
        int leftValue,
        int rightValue,
        params GUILayoutOption[] options) => throw Absent.Editor;
    public static void IntSlider(
        SerializedProperty property,
        int leftValue,
        int rightValue,
        string label,
        params GUILayoutOption[] options) => throw Absent.Editor;
    public static void IntSlider(
        SerializedProperty property,
        int leftValue,
        int rightValue,
        GUIContent label,
        params GUILayoutOption[] options) => throw Absent.Editor;
    public static void IntSlider(
        SerializedProperty property,
        int leftValue,
        int rightValue,
        params GUILayoutOption[] options) => throw Absent.Editor;
    public static int IntSlider(
        GUIContent label,
        int value,
        int leftValue,
        int rightValue,
        params GUILayoutOption[] options)
    {
        return Mathf.Clamp(Field(label, value), leftValue, rightValue);
    }

    public static void MinMaxSlider(
        string label,
        ref float minValue,
        ref float maxValue,
        float minLimit,
        float maxLimit,
        params GUILayoutOption[] options) => throw Absent.Editor;
    public static void MinMaxSlider(
        GUIContent label,
        ref float minValue,
        ref float maxValue,
        float minLimit,
        float maxLimit,
        params GUILayoutOption[] options) => throw Absent.Editor;
    public static Object ObjectField(
        string label,
        Object obj,
        Type objType,
        bool allowSceneObjects,
        params GUILayoutOption[] options) => throw Absent.Editor;
    public static Object ObjectField(
        GUIContent label,
        Object obj,
        Type objType,
        bool allowSceneObjects,
        params GUILayoutOption[] options)
    {
        Add(ControlKind.Field, label, obj == null ? "None" : obj.name);
        return (Object)GuiPage.Needed.Put(label, obj);
    }

    public static int Popup(
        string label,
        int selectedIndex,
        string[] displayedOptions,
        params GUILayoutOption[] options)
    {
        Add(ControlKind.Field, new GUIContent(label), displayedOptions[selectedIndex]);
        return (int)GuiPage.Needed.Put(new GUIContent(label), selectedIndex);
    }

    public static int Popup(
        GUIContent label,
        int selectedIndex,
        string[] displayedOptions,
        params GUILayoutOption[] options) => throw Absent.Editor;
    public static int Popup(
        GUIContent label,
        int selectedIndex,
        GUIContent[] displayedOptions,
        params GUILayoutOption[] options)
    {
        Add(ControlKind.Field, label, displayedOptions[selectedIndex].text);
        return (int)GuiPage.Needed.Put(label, selectedIndex);
    }

    public static Enum EnumPopup(string label, Enum selected, params GUILayoutOption[] options) => throw Absent.Editor;
    public static Enum EnumPopup(GUIContent label, Enum selected, params GUILayoutOption[] options) => Field(label, selected);
    public static Vector2 Vector2Field(string label, Vector2 value, params GUILayoutOption[] options) => throw Absent.Editor;
    public static Vector2 Vector2Field(GUIContent label, Vector2 value, params GUILayoutOption[] options) => Field(label, value);
    public static Vector3 Vector3Field(string label, Vector3 value, params GUILayoutOption[] options) => throw Absent.Editor;
    public static Vector3 Vector3Field(GUIContent label, Vector3 value, params GUILayoutOption[] options) => throw Absent.Editor;
    public static string TextField(string label, string text, params GUILayoutOption[] options) => Field(new GUIContent(label), text);
    public static string TextField(GUIContent label, string text, params GUILayoutOption[] options) => throw Absent.Editor;
    public static void PrefixLabel(string label) => throw Absent.Editor;
    public static void PrefixLabel(GUIContent label) => throw Absent.Editor;
    public static Rect GetControlRect(bool hasLabel, float height, params GUILayoutOption[] options) => GuiPage.Needed.Next(height);
    public static Rect GetControlRect(bool hasLabel, float height, GUIStyle style, params GUILayoutOption[] options) => throw Absent.Editor;
    public static Rect GetControlRect(bool hasLabel, params GUILayoutOption[] options) => throw Absent.Editor;
    public static Rect GetControlRect(params GUILayoutOption[] options) => throw Absent.Editor;
    public static Vector2 BeginScrollView(Vector2 scrollPosition, params GUILayoutOption[] options)
    {
        GuiPage.Needed.Begin("scroll");
        return scrollPosition;
    }

    public static void EndScrollView() => GuiPage.Needed.End("scroll");
    public static Color ColorField(string label, Color value, params GUILayoutOption[] options) => throw Absent.Editor;
    public static Color ColorField(GUIContent label, Color value, params GUILayoutOption[] options) => throw Absent.Editor;

    private static bool Field(SerializedProperty property, GUIContent label, bool includeChildren)
    {
        Rect position = GuiPage.Needed.Next(DrawnProperty.HeightOf(property, label, includeChildren));
        return DrawnProperty.Draw(position, property, label, includeChildren);
    }

    private static T Field<T>(GUIContent label, T value)
    {
        Add(ControlKind.Field, label, FormattableString.Invariant($"{value}"));
        return (T)GuiPage.Needed.Put(label, value);
    }

    private static bool Add(ControlKind kind, GUIContent content, string value = "") =>
        GuiPage.Needed.Add(kind, GuiPage.Needed.Next(EditorGUIUtility.singleLineHeight), content, value);
}
