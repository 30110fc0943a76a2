using UnityEngine;

namespace UnityEditor;

public sealed class EditorStyles
{
    public static GUIStyle label { get; }
    public static GUIStyle boldLabel { get; }
    public static GUIStyle miniLabel { get; }
    public static GUIStyle miniBoldLabel { get; }
    public static GUIStyle centeredGreyMiniLabel { get; }
    public static GUIStyle wordWrappedLabel { get; }
    public static GUIStyle wordWrappedMiniLabel { get; }
    public static GUIStyle helpBox { get; }
    public static GUIStyle foldout { get; }
    public static GUIStyle foldoutHeader { get; }
    public static GUIStyle toolbar { get; }
    public static GUIStyle toolbarButton { get; }
    public static GUIStyle miniButton { get; }
    public static GUIStyle miniButtonLeft { get; }
    public static GUIStyle miniButtonMid { get; }
    public static GUIStyle miniButtonRight { get; }
    public static GUIStyle whiteLabel { get; }
    public static GUIStyle whiteMiniLabel { get; }
}
