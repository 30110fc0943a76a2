using System;
using System.Collections.Generic;
using Unity.StandIns;

namespace UnityEngine;

/// <summary>Keys, mouse and fingers that tests move.</summary>
public class Input
{
    private static readonly HashSet<KeyCode> s_Held = [];
    private static readonly Dictionary<KeyCode, int> s_Pressed = [];
    private static readonly Dictionary<KeyCode, int> s_Released = [];
    private static readonly bool[] s_Buttons = new bool[3];
    private static readonly Dictionary<string, float> s_Axes = [];

    public static bool anyKey => s_Held.Count > 0;
    public static Vector3 mousePosition { get; private set; }
    public static Vector2 mouseScrollDelta { get; private set; }
    public static int touchCount => Fingers.Count;

    /// <summary>Fingers on the screen.</summary>
    [StandInExtension]
    public static List<Touch> Fingers { get; } = [];

    public static bool GetKey(KeyCode key) => s_Held.Contains(key);
    public static bool GetKeyDown(KeyCode key) => s_Pressed.TryGetValue(key, out int frame) && frame == Time.frameCount;
    public static bool GetKeyUp(KeyCode key) => s_Released.TryGetValue(key, out int frame) && frame == Time.frameCount;
    public static bool GetMouseButton(int button) => s_Buttons[button];
    public static Touch GetTouch(int index) => Fingers[index];

    /// <summary>The axes of a new project.</summary>
    public static float GetAxisRaw(string axisName) => axisName is "Horizontal" or "Vertical"
        ? s_Axes.GetValueOrDefault(axisName)
        : throw new ArgumentException($"Input Axis {axisName} is not setup.");

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

    /// <summary>Puts the mouse somewhere, pixels from the lower left corner.</summary>
    [StandInExtension]
    public static void MoveMouse(Vector2 place) => mousePosition = place;

    /// <summary>Holds a button of the mouse, or lets it go.</summary>
    [StandInExtension]
    public static void HoldMouse(int button, bool isHeld) => s_Buttons[button] = isHeld;

    /// <summary>Turns the wheel; away from the user is positive.</summary>
    [StandInExtension]
    public static void Scroll(float notches) => mouseScrollDelta = new Vector2(0f, notches);

    /// <summary>Pushes an axis.</summary>
    [StandInExtension]
    public static void Push(string axisName, float value) => s_Axes[axisName] = value;
}
