namespace UnityEngine;

public sealed class GUISkin : ScriptableObject
{
    public GUIStyle label { get; set; } = new();
    public GUIStyle box { get; set; } = new();
}
