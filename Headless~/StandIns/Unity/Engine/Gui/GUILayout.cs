using StandIns;

namespace UnityEngine;

public class GUILayout
{
    private const float k_Line = 18f;

    public static bool Button(string text, params GUILayoutOption[] options) =>
        GuiPage.Needed.Add(ControlKind.Button, GuiPage.Needed.Next(k_Line), new GUIContent(text));
    public static bool Button(string text, GUIStyle style, params GUILayoutOption[] options) =>
        GuiPage.Needed.Add(ControlKind.Button, GuiPage.Needed.Next(k_Line), new GUIContent(text));
    public static bool Button(GUIContent content, params GUILayoutOption[] options) =>
        GuiPage.Needed.Add(ControlKind.Button, GuiPage.Needed.Next(k_Line), content);
    public static bool Button(GUIContent content, GUIStyle style, params GUILayoutOption[] options) =>
        GuiPage.Needed.Add(ControlKind.Button, GuiPage.Needed.Next(k_Line), content);
    public static bool Button(Texture image, params GUILayoutOption[] options) => throw Absent.Gui;
    public static bool Button(Texture image, GUIStyle style, params GUILayoutOption[] options) => throw Absent.Gui;
    public static void Label(string text, params GUILayoutOption[] options) =>
        GuiPage.Needed.Add(ControlKind.Label, GuiPage.Needed.Next(k_Line), new GUIContent(text));
    public static void Label(string text, GUIStyle style, params GUILayoutOption[] options) =>
        GuiPage.Needed.Add(ControlKind.Label, GuiPage.Needed.Next(k_Line), new GUIContent(text));
    public static void Label(GUIContent content, params GUILayoutOption[] options) => throw Absent.Gui;
    public static void Label(GUIContent content, GUIStyle style, params GUILayoutOption[] options) => throw Absent.Gui;
    public static void Label(Texture image, params GUILayoutOption[] options) => throw Absent.Gui;
    public static void Label(Texture image, GUIStyle style, params GUILayoutOption[] options) => throw Absent.Gui;
    public static void Box(string text, params GUILayoutOption[] options) => throw Absent.Gui;
    public static void Box(string text, GUIStyle style, params GUILayoutOption[] options) => throw Absent.Gui;
    public static void Box(GUIContent content, params GUILayoutOption[] options) => throw Absent.Gui;
    public static void Box(GUIContent content, GUIStyle style, params GUILayoutOption[] options) => throw Absent.Gui;
    public static void Box(Texture image, params GUILayoutOption[] options) => throw Absent.Gui;
    public static void Box(Texture image, GUIStyle style, params GUILayoutOption[] options) => throw Absent.Gui;
    public static void Space(float pixels) => GuiPage.Needed.Next(pixels);
    public static void FlexibleSpace() => throw Absent.Gui;
    public static void BeginHorizontal(params GUILayoutOption[] options) => GuiPage.Needed.Begin("horizontal");
    public static void BeginHorizontal(GUIStyle style, params GUILayoutOption[] options) => throw Absent.Gui;
    public static void EndHorizontal() => GuiPage.Needed.End("horizontal");
    public static void BeginVertical(params GUILayoutOption[] options) => throw Absent.Gui;
    public static void BeginVertical(GUIStyle style, params GUILayoutOption[] options) => throw Absent.Gui;
    public static void EndVertical() => throw Absent.Gui;
    public static void BeginArea(Rect screenRect) => GuiPage.Needed.BeginArea(screenRect);
    public static void BeginArea(Rect screenRect, GUIStyle style) => BeginArea(screenRect);
    public static void EndArea() => GuiPage.Needed.End("area");
    public static GUILayoutOption Width(float width) => new();
    public static GUILayoutOption Height(float height) => throw Absent.Gui;
    public static GUILayoutOption MinWidth(float minWidth) => throw Absent.Gui;
    public static GUILayoutOption MaxWidth(float maxWidth) => throw Absent.Gui;
    public static GUILayoutOption MinHeight(float minHeight) => throw Absent.Gui;
    public static GUILayoutOption MaxHeight(float maxHeight) => throw Absent.Gui;
    public static GUILayoutOption ExpandWidth(bool expand) => throw Absent.Gui;
    public static GUILayoutOption ExpandHeight(bool expand) => throw Absent.Gui;
    public static bool Toggle(bool value, string text, params GUILayoutOption[] options) =>
        value ^ GuiPage.Needed.Add(ControlKind.Toggle, GuiPage.Needed.Next(k_Line), new GUIContent(text), value.ToString());
    public static bool Toggle(bool value, string text, GUIStyle style, params GUILayoutOption[] options) => throw Absent.Gui;
    public static bool Toggle(bool value, GUIContent content, params GUILayoutOption[] options) => throw Absent.Gui;
    public static bool Toggle(bool value, GUIContent content, GUIStyle style, params GUILayoutOption[] options) =>
        value ^ GuiPage.Needed.Add(ControlKind.Toggle, GuiPage.Needed.Next(k_Line), content, value.ToString());
    public static bool Toggle(bool value, Texture image, params GUILayoutOption[] options) => throw Absent.Gui;
    public static bool Toggle(bool value, Texture image, GUIStyle style, params GUILayoutOption[] options) => throw Absent.Gui;
    public static int Toolbar(int selected, string[] texts, params GUILayoutOption[] options)
    {
        Rect line = GuiPage.Needed.Next(k_Line);
        for (int k = 0; k < texts.Length; k++)
        {
            if (GuiPage.Needed.Add(ControlKind.Button, line, new GUIContent(texts[k]), (k == selected).ToString()))
                selected = k;
        }

        return selected;
    }

    public static int Toolbar(int selected, GUIContent[] contents, params GUILayoutOption[] options)
    {
        for (int k = 0; k < contents.Length; k++)
        {
            if (GuiPage.Needed.Add(ControlKind.Button, GuiPage.Needed.Next(k_Line), contents[k], (k == selected).ToString()))
                selected = k;
        }

        return selected;
    }

    public static float HorizontalSlider(
        float value,
        float leftValue,
        float rightValue,
        params GUILayoutOption[] options) => GuiPage.Needed.Slide(GuiPage.Needed.Next(k_Line), value, leftValue, rightValue);
}
