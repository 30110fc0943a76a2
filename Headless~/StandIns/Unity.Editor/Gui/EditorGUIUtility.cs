using System;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

public sealed class EditorGUIUtility : GUIUtility
{
    public static float singleLineHeight => 18f;
    public static float standardVerticalSpacing => 2f;
    public static float labelWidth { get; set; }
    public static float fieldWidth { get; set; }
    public static float currentViewWidth { get; }
    public static bool isProSkin { get; }
    public static float pixelsPerPoint { get; }
    public static bool wideMode { get; set; }
    public static bool editingTextField { get; set; }
    public static bool hierarchyMode { get; set; }

    public static GUIContent IconContent(string name) => throw Absent.Editor;
    public static GUIContent IconContent(string name, string text) => throw Absent.Editor;
    public static GUIContent TrTextContent(string text, string tooltip, string iconName) => throw Absent.Editor;
    public static void PingObject(Object obj) => ArgumentNullException.ThrowIfNull(obj);
    public static void AddCursorRect(Rect position, MouseCursor mouse) => throw Absent.Editor;
    public static Texture2D GetIconForObject(Object obj) => throw Absent.Editor;
    public static void SetIconForObject(Object obj, Texture2D icon) => throw Absent.Editor;
    public static GUIContent ObjectContent(Object obj, Type type) => throw Absent.Editor;
}
