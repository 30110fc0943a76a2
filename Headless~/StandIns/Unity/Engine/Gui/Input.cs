using System.Collections.Generic;
using Unity.StandIns;

namespace UnityEngine;

/// <summary>Keys that tests press.</summary>
public class Input
{
    private static readonly HashSet<KeyCode> s_Held = [];
    private static readonly Dictionary<KeyCode, int> s_Pressed = [];
    private static readonly Dictionary<KeyCode, int> s_Released = [];

    public static bool anyKey => s_Held.Count > 0;
    public static Vector3 mousePosition => Vector3.zero;

    public static bool GetKey(KeyCode key) => s_Held.Contains(key);
    public static bool GetKeyDown(KeyCode key) => s_Pressed.TryGetValue(key, out int frame) && frame == Time.frameCount;
    public static bool GetKeyUp(KeyCode key) => s_Released.TryGetValue(key, out int frame) && frame == Time.frameCount;

    /// <summary>Presses a key; the next frame sees it go down.</summary>
    [StandInExtension]
    public static void Press(KeyCode key)
    {
        if (s_Held.Add(key))
            s_Pressed[key] = Time.frameCount + 1;
    }

    /// <summary>Lets a key go; the next frame sees it go up.</summary>
    [StandInExtension]
    public static void Release(KeyCode key)
    {
        if (s_Held.Remove(key))
            s_Released[key] = Time.frameCount + 1;
    }
}
