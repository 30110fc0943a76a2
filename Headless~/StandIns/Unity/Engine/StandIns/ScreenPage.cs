using System;
using System.Collections.Generic;
using UnityEngine;

namespace StandIns;

/// <summary>One pass over the screen: what was drawn where, and whether it fits.</summary>
internal sealed class ScreenPage(ScreenAct act) : IGuiPage
{
    private const float k_Gap = 4f;
    private readonly Stack<(string Name, Rect Area, float Next)> _groups = new();
    private float _next;
    private float _row;
    private Rect _area = new(0f, 0f, Screen.width, Screen.height);
    private string _label = "";

    public List<DrawnControl> Controls { get; } = [];

    public Rect Next(float height)
    {
        if (_groups.Count == 0)
            throw new InvalidOperationException("GUILayout is used outside of an area.");
        var line = new Rect(_area.xMin, _area.yMin + _next, _area.width, height);
        if (_groups.Peek().Name == "horizontal")
            _row = Math.Max(_row, height + k_Gap);
        else
            _next += height + k_Gap;
        if (_next > _area.height)
            throw new InvalidOperationException($"The area at {_area} is too low for its lines, which need {_next} pixels.");
        return line;
    }

    public bool Add(ControlKind kind, Rect at, GUIContent content, string value)
    {
        Controls.Add(new DrawnControl(kind, at, content.text, content.tooltip ?? "", value, GUI.enabled));
        if (kind == ControlKind.Label)
            _label = content.text;
        bool pressed = GUI.enabled && act is { WasFound: false, Pressed: not null } && act.Pressed == content.text
            && kind is ControlKind.Button or ControlKind.Toggle;
        if (pressed && act != null)
            act.WasFound = true;
        return pressed;
    }

    public object Put(GUIContent label, object value) => throw new NotSupportedException("A game has no fields of the editor.");

    public int Changes => throw new NotSupportedException("A game has no fields of the editor.");

    public float Slide(float value, float left, float right)
    {
        Rect at = Next(18f);
        bool isMeant = act is { WasFound: false, Slid: not null } && _label.StartsWith(act.Slid, StringComparison.Ordinal);
        Controls.Add(new DrawnControl(ControlKind.Field, at, _label, "", $"{value} of {left} to {right}", GUI.enabled));
        if (!isMeant)
            return value;
        act.WasFound = true;
        return Math.Clamp(act.Value, Math.Min(left, right), Math.Max(left, right));
    }

    public void Begin(string group)
    {
        _groups.Push((group, _area, _next));
        _row = 0f;
    }

    public void BeginArea(Rect area)
    {
        if (area.xMin < 0f || area.yMin < 0f || area.xMax > Screen.width || area.yMax > Screen.height)
            throw new InvalidOperationException($"The area at {area} is not on the screen.");
        Begin("area");
        (_area, _next) = (area, 0f);
    }

    public void End(string group)
    {
        if (_groups.Count == 0 || _groups.Peek().Name != group)
            throw new InvalidOperationException($"The group '{group}' is closed and was not the last one opened.");
        (_, Rect area, float next) = _groups.Pop();
        if (group == "area")
            (_area, _next) = (area, next);
        else if (group == "horizontal")
            _next += _row;
    }

    /// <summary>Every group must be closed.</summary>
    public void Close()
    {
        if (_groups.Count > 0)
            throw new InvalidOperationException($"The group '{_groups.Peek().Name}' was not closed.");
    }
}
