namespace UnityEngine;

public class GUILayoutUtility
{
    public static Rect GetRect(float width, float height) => GuiPage.Needed.Next(height);
    public static Rect GetRect(float width, float height, params GUILayoutOption[] options) => throw Absent.Gui;
    public static Rect GetRect(float width, float height, GUIStyle style) => throw Absent.Gui;
    public static Rect GetRect(float width, float height, GUIStyle style, params GUILayoutOption[] options) => throw Absent.Gui;
    public static Rect GetRect(GUIContent content, GUIStyle style) => throw Absent.Gui;
    public static Rect GetRect(GUIContent content, GUIStyle style, params GUILayoutOption[] options) => throw Absent.Gui;
    public static Rect GetLastRect() => throw Absent.Gui;
    public static Rect GetAspectRect(float aspect) => GuiPage.Needed.Next(GuiPage.Needed.Next(0f).width / aspect);
}
