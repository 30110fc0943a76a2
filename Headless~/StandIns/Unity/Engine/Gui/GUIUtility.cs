using System;

namespace UnityEngine;

public class GUIUtility
{
    public static int hotControl { get; set; }
    public static int keyboardControl { get; set; }
    public static string systemCopyBuffer { get; set; }


    /// <summary>The hint: enough where each control has its own.</summary>
    public static int GetControlID(int hint, FocusType focus) => hint;

    public static int GetControlID(int hint, FocusType focusType, Rect rect) => throw Absent.Gui;
    public static int GetControlID(FocusType focus) => throw Absent.Gui;
    public static int GetControlID(FocusType focus, Rect position) => throw Absent.Gui;
    public static int GetControlID(GUIContent contents, FocusType focus) => throw Absent.Gui;
    public static int GetControlID(GUIContent contents, FocusType focus, Rect position) => throw Absent.Gui;
    public static void ExitGUI() => throw new ExitGUIException();
    public static object GetStateObject(Type t, int controlID) => throw Absent.Gui;
    public static Vector2 GUIToScreenPoint(Vector2 guiPoint) => throw Absent.Gui;
    public static Vector2 ScreenToGUIPoint(Vector2 screenPoint) => throw Absent.Gui;
}
