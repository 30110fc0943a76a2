using StandIns;

namespace UnityEngine;

public partial class GUI
{
    public static Color color { get; set; }
    public static Color backgroundColor { get; set; }
    public static Color contentColor { get; set; }
    public static bool enabled { get; set; } = true;
    public static Matrix4x4 matrix { get; set; } = Matrix4x4.identity;
    public static GUISkin skin { get; set; } = new();
    public static bool changed { get; set; }
    public static string tooltip { get; set; }

    public static bool Button(Rect position, string text) =>
        GuiPage.Needed.Add(ControlKind.Button, position, new GUIContent(text));
    public static bool Button(Rect position, string text, GUIStyle style) => throw Absent.Gui;
    public static bool Button(Rect position, GUIContent content) => throw Absent.Gui;
    public static bool Button(Rect position, GUIContent content, GUIStyle style) => throw Absent.Gui;
    public static bool Button(Rect position, Texture image) => throw Absent.Gui;
    public static bool Button(Rect position, Texture image, GUIStyle style) => throw Absent.Gui;
    public static void Label(Rect position, string text) => Label(position, text, skin.label);
    public static void Label(Rect position, string text, GUIStyle style) =>
        GuiPage.Needed.Add(ControlKind.Area, position, new GUIContent(text));
    public static void Label(Rect position, GUIContent content) => throw Absent.Gui;
    public static void Label(Rect position, GUIContent content, GUIStyle style) => throw Absent.Gui;
    public static void Label(Rect position, Texture image) => throw Absent.Gui;
    public static void Label(Rect position, Texture image, GUIStyle style) => throw Absent.Gui;
    public static void Box(Rect position, string text)
    {
        if (GuiPage.Needed != null && position.xMax > Screen.width || position.yMax > Screen.height)
            throw new System.InvalidOperationException($"The box at {position} is not on the screen.");
        (GuiPage.Needed as ScreenPage)?.Boxes.Add(position);
    }

    public static void Box(Rect position, string text, GUIStyle style) => throw Absent.Gui;
    public static void Box(Rect position, GUIContent content) => throw Absent.Gui;
    public static void Box(Rect position, GUIContent content, GUIStyle style) => throw Absent.Gui;
    public static void Box(Rect position, Texture image) => throw Absent.Gui;
    public static void Box(Rect position, Texture image, GUIStyle style) => throw Absent.Gui;
    public static void BeginGroup(Rect position) => throw Absent.Gui;
    public static void EndGroup() => throw Absent.Gui;
    public static void DrawTexture(Rect position, Texture image) => throw Absent.Gui;
    public static void DrawTexture(Rect position, Texture image, ScaleMode scaleMode) =>
        GuiPage.Needed.Add(ControlKind.Area, position, GUIContent.none, image.name);
    public static bool Toggle(Rect position, bool value, string text) =>
        value ^ GuiPage.Needed.Add(ControlKind.Toggle, position, new GUIContent(text), value.ToString());
    public static float HorizontalSlider(Rect position, float value, float leftValue, float rightValue) =>
        GuiPage.Needed.Slide(position, value, leftValue, rightValue);
    public static bool Toggle(Rect position, bool value, string text, GUIStyle style) => throw Absent.Gui;
    public static bool Toggle(Rect position, bool value, GUIContent content) => throw Absent.Gui;
    public static bool Toggle(Rect position, bool value, GUIContent content, GUIStyle style) => throw Absent.Gui;
    public static bool Toggle(Rect position, bool value, Texture image) => throw Absent.Gui;
    public static bool Toggle(Rect position, bool value, Texture image, GUIStyle style) => throw Absent.Gui;
    public static void DragWindow() => throw Absent.Gui;
    public static void FocusControl(string name) => throw Absent.Gui;
    public static void SetNextControlName(string name) => throw Absent.Gui;
}
