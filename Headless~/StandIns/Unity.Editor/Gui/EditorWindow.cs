using System;
using StandIns;
using UnityEngine;

namespace UnityEditor;

public class EditorWindow : ScriptableObject
{
    public GUIContent titleContent { get; set; }
    public Rect position { get; set; }
    public Vector2 minSize { get; set; }
    public Vector2 maxSize { get; set; }
    public bool wantsMouseMove { get; set; }
    public static EditorWindow focusedWindow { get; }

    public static EditorWindow GetWindow(Type windowType) => throw Absent.Editor;
    public static EditorWindow GetWindow(Type windowType, bool utility) => throw Absent.Editor;
    public static EditorWindow GetWindow(Type windowType, bool utility, string title) => throw Absent.Editor;
    public static EditorWindow GetWindow(Type windowType, bool utility, string title, bool focus) => throw Absent.Editor;
    public static T GetWindow<T>() where T : EditorWindow => throw Absent.Editor;
    public static T GetWindow<T>(bool utility) where T : EditorWindow => throw Absent.Editor;
    public static T GetWindow<T>(bool utility, string title) where T : EditorWindow => throw Absent.Editor;
    public static T GetWindow<T>(bool utility, string title, bool focus) where T : EditorWindow => throw Absent.Editor;
    public static T GetWindow<T>(string title) where T : EditorWindow
    {
        T window = CreateInstance<T>();
        window.titleContent = new GUIContent(title);
        OpenWindows.All.Add(window);
        return window;
    }

    public static T GetWindow<T>(string title, bool focus) where T : EditorWindow => throw Absent.Editor;
    public static T GetWindow<T>(string title, bool focus, params Type[] desiredDockNextTo) where T : EditorWindow => throw Absent.Editor;
    public static T GetWindow<T>(string title, params Type[] desiredDockNextTo) where T : EditorWindow => throw Absent.Editor;
    public static T GetWindow<T>(params Type[] desiredDockNextTo) where T : EditorWindow => throw Absent.Editor;
    public static T CreateWindow<T>(string title, params Type[] desiredDockNextTo) where T : EditorWindow => throw Absent.Editor;
    public static T CreateWindow<T>(params Type[] desiredDockNextTo) where T : EditorWindow => throw Absent.Editor;
    public void Show() => throw Absent.Editor;
    public void ShowUtility() => throw Absent.Editor;
    public void Close() => throw Absent.Editor;
    public void Focus() => throw Absent.Editor;

    /// <summary>Does nothing: there is no window to draw again.</summary>
    public void Repaint()
    {
    }

    public static bool HasOpenInstances<T>() where T : EditorWindow => throw Absent.Editor;
    public void ShowNotification(GUIContent notification) => throw Absent.Editor;
}
