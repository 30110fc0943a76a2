using System;
using System.Collections.Generic;
using UnityEngine;

namespace StandIns;

/// <summary>One pass over the screen: what was drawn where, and whether it fits.</summary>
internal sealed class ScreenPage : IGuiPage
{
    private const float k_Gap = 4f;
    private readonly Stack<(string Name, Rect Area, float Next)> _groups = new();
    private float _next;
    private float _row;
    private Rect _area = new(0f, 0f, Screen.width, Screen.height);
    private string _label = "";
    private bool _isLaidOut;

    public List<DrawnControl> Controls { get; } = [];

    /// <summary>Places of boxes, which are behind the controls.</summary>
    public List<Rect> Boxes { get; } = [];

    /// <summary>Kinds of the controls whose places GUILayout found.</summary>
    public List<ControlKind> LaidOut { get; } = [];

    public List<DrawnSlider> Sliders { get; } = [];

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
        _isLaidOut = true;
        return line;
    }

    public bool Add(ControlKind kind, Rect at, GUIContent content, string value)
    {
        Controls.Add(new DrawnControl(kind, at, content.text, content.tooltip ?? "", value, GUI.enabled));
        if (_isLaidOut)
            LaidOut.Add(kind);
        _isLaidOut = false;
        if (kind is ControlKind.Label or ControlKind.Area)
            _label = content.text;
        return false;
    }

    public object Put(GUIContent label, object value) => throw new NotSupportedException("A game has no fields of the editor.");

    public int Changes => throw new NotSupportedException("A game has no fields of the editor.");

    public float Slide(Rect at, float value, float left, float right)
    {
        Sliders.Add(new DrawnSlider(_label, at, value, left, right));
        Add(ControlKind.Field, at, new GUIContent(_label), $"{value} of {left} to {right}");
        return value;
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
