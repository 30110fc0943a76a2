using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using UnityEditor;
using UnityEngine;

namespace StandIns;

/// <summary>
/// Draws an inspector without a window: once for layout and once more, which must have the same controls; controls of a drawer lie inside
/// the lines that it asked for, and every group is closed.
/// </summary>
[Unity.StandIns.StandInExtension]
public sealed class DrawnInspector : IGuiPage
{
    private const float k_Width = 400f, k_Gap = 2f;
    private readonly List<DrawnControl> _controls = [];
    private readonly Stack<string> _groups = [];
    private readonly string _pressed, _put;
    private readonly object _value;
    private float _next;
    private bool _wasPressed, _wasPut;

    private DrawnInspector(string pressed, string put, object value) => (_pressed, _put, _value) = (pressed, put, value);

    /// <summary>The controls from top to bottom.</summary>
    public IReadOnlyList<DrawnControl> Controls => _controls;

    /// <summary>Texts of all help boxes.</summary>
    public IEnumerable<string> HelpBoxes => Texts(ControlKind.HelpBox);

    /// <summary>Texts of all buttons that can be pressed.</summary>
    public IEnumerable<string> Buttons => _controls.Where(c => c.Kind == ControlKind.Button && c.Enabled).Select(c => c.Text);

    /// <summary>Draws an inspector as it is.</summary>
    public static DrawnInspector Of(Editor editor) => Of(editor.OnInspectorGUI);

    /// <summary>Draws a panel as it is.</summary>
    public static DrawnInspector Of(Action draw)
    {
        DrawnInspector layout = Pass(draw, EventType.Layout, null), repaint = Pass(draw, EventType.Repaint, null);
        var before = layout.Controls.Where(c => c.Kind != ControlKind.Area).Select(c => c.Text).ToList();
        var after = repaint.Controls.Where(c => c.Kind != ControlKind.Area).Select(c => c.Text).ToList();
        if (!before.SequenceEqual(after))
            throw new InvalidOperationException($"Layout and repaint differ: [{string.Join(", ", before)}], [{string.Join(", ", after)}].");
        return repaint;
    }

    /// <summary>Presses the button, toggle or foldout with a text, and draws the inspector as it is then.</summary>
    public static DrawnInspector Press(Editor editor, string text) => Press(editor.OnInspectorGUI, text);

    /// <summary>Presses the first button, toggle or foldout of a panel with a text, and draws the panel as it is then.</summary>
    public static DrawnInspector Press(Action draw, string text)
    {
        Of(draw);
        if (!Pass(draw, EventType.MouseUp, text)._wasPressed)
            throw new InvalidOperationException($"There is nothing to press that says '{text}'.");
        return Of(draw);
    }

    /// <summary>Puts a value into the first field with a label, and draws the panel as it is then.</summary>
    public static DrawnInspector Put(Action draw, string label, object value)
    {
        Of(draw);
        if (!Pass(draw, EventType.MouseUp, null, label, value)._wasPut)
            throw new InvalidOperationException($"There is no field '{label}'.");
        return Of(draw);
    }

    /// <summary>Presses the mouse in a panel, and draws it as it is then.</summary>
    public static DrawnInspector Click(Action draw, Vector2 at)
    {
        Of(draw);
        Pass(draw, EventType.MouseDown, null, mouse: at);
        return Of(draw);
    }

    /// <summary>Method that draws a window.</summary>
    public static Action Of(EditorWindow window) => window.GetType().GetMethod("OnGUI", BindingFlags.Instance | BindingFlags.NonPublic)
        .CreateDelegate<Action>(window);

    /// <summary>The only control with a text.</summary>
    public DrawnControl Control(string text) => _controls.Single(c => c.Text == text);

    Rect IGuiPage.Next(float height)
    {
        var line = new Rect(0f, _next, k_Width, height);
        _next += height + k_Gap;
        return line;
    }

    bool IGuiPage.Add(ControlKind kind, Rect at, GUIContent content, string value)
    {
        bool enabled = !_groups.Contains("disabled");
        if (at.xMin < 0f || at.xMax > k_Width || at.yMin < 0f || at.yMax > _next)
            throw new InvalidOperationException($"'{content.text}' lies outside its lines: {at}.");
        if (kind != ControlKind.Area && _controls.Exists(c => c.Kind != ControlKind.Area && Overlap(c.Place, at)))
            throw new InvalidOperationException($"'{content.text}' lies over another control.");
        _controls.Add(new DrawnControl(kind, at, content.text, content.tooltip ?? "", value, enabled));
        bool pressed = enabled && !_wasPressed && content.text == _pressed
            && kind is (ControlKind.Button or ControlKind.Toggle or ControlKind.Foldout);
        _wasPressed |= pressed;
        return pressed;
    }

    object IGuiPage.Put(GUIContent label, object value)
    {
        if (_put == null || _wasPut || label.text != _put || _groups.Contains("disabled"))
            return value;
        _wasPut = true;
        return _value;
    }

    int IGuiPage.Changes => (_wasPressed ? 1 : 0) + (_wasPut ? 1 : 0);

    float IGuiPage.Slide(Rect at, float value, float left, float right) =>
        throw new NotSupportedException("Inspectors have no plain sliders yet.");

    void IGuiPage.BeginArea(Rect area) => throw new NotSupportedException("Inspectors have no areas yet.");

    void IGuiPage.Begin(string group) => _groups.Push(group);

    void IGuiPage.End(string group)
    {
        if (_groups.Count == 0 || !_groups.Peek().EndsWith(group, StringComparison.Ordinal))
            throw new InvalidOperationException($"The group '{group}' is closed and was not the last one opened.");
        _groups.Pop();
    }

    private IEnumerable<string> Texts(ControlKind kind) => _controls.Where(c => c.Kind == kind).Select(c => c.Text);

    private static DrawnInspector Pass(
        Action draw, EventType type, string pressed, string put = null, object value = null, Vector2 mouse = default)
    {
        var page = new DrawnInspector(pressed, put, value);
        Event before = Event.current;
        GuiPage.Current = page;
        Event.current = new Event { type = type, mousePosition = mouse };
        bool left = false;
        try
        {
            draw();
        }
        catch (ExitGUIException)
        {
            left = true;
        }
        finally
        {
            GuiPage.Current = null;
            Event.current = before;
        }

        if (!left && page._groups.Count > 0)
            throw new InvalidOperationException($"The group '{page._groups.Peek()}' was not closed.");
        return page;
    }

    private static bool Overlap(Rect a, Rect b) => a.xMin < b.xMax && b.xMin < a.xMax && a.yMin < b.yMax && b.yMin < a.yMax;
}
