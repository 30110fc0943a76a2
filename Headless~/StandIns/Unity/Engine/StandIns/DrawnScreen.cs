using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace StandIns;

/// <summary>
/// The screen that OnGUI of playing scripts draws on, at the end of each frame: once for what a test does to it, then for layout and for
/// repaint, which must have the same controls. Areas lie on the screen and hold their lines, and every group is closed.
/// </summary>
[Unity.StandIns.StandInExtension]
public static class DrawnScreen
{
    private static readonly Queue<ScreenAct> s_Acts = new();
    private static IReadOnlyList<DrawnControl> s_Controls = [];

    /// <summary>Controls of the last frame, in the order in which they were drawn.</summary>
    public static IReadOnlyList<DrawnControl> Controls => s_Controls;

    /// <summary>All texts of the last frame, joined.</summary>
    public static string Text => string.Join("\n", s_Controls.Select(control => control.Text));

    /// <summary>True where a test has acts for the screen.</summary>
    internal static bool IsExpectingActs => s_Acts.Count > 0;

    /// <summary>Presses a button or toggle in the next frame.</summary>
    public static void Press(string text) => s_Acts.Enqueue(new ScreenAct(new Event { type = EventType.MouseUp }) { Pressed = text });

    /// <summary>Moves the slider below the label that begins with a text in the next frame.</summary>
    public static void Slide(string label, float value) =>
        s_Acts.Enqueue(new ScreenAct(new Event { type = EventType.MouseDrag }) { Slid = label, Value = value });

    /// <summary>Presses a key in the next frame.</summary>
    public static void Key(KeyCode key) => s_Acts.Enqueue(new ScreenAct(new Event { type = EventType.KeyDown, keyCode = key }));

    /// <summary>Moves the mouse with its left button held, beside all controls, in the next frame.</summary>
    public static void Drag(Vector2 way) => s_Acts.Enqueue(new ScreenAct(new Event { type = EventType.MouseDrag, delta = way }));

    /// <summary>Turns the mouse's wheel in the next frame.</summary>
    public static void Scroll(float lines) =>
        s_Acts.Enqueue(new ScreenAct(new Event { type = EventType.ScrollWheel, delta = new Vector2(0f, lines) }));

    /// <summary>Draws a frame.</summary>
    internal static void Draw(Action sendAll)
    {
        if (s_Acts.TryDequeue(out ScreenAct act))
        {
            Pass(sendAll, new ScreenPage(act), act.Event);
            if (!act.IsDone)
                throw new InvalidOperationException($"There is nothing on the screen to do '{act.Pressed ?? act.Slid}' to.");
        }

        List<DrawnControl> layout = Pass(sendAll, new ScreenPage(null), new Event { type = EventType.Layout });
        List<DrawnControl> repaint = Pass(sendAll, new ScreenPage(null), new Event { type = EventType.Repaint });
        if (!layout.Select(control => control.Kind)
            .SequenceEqual(repaint.Where(control => control.Kind != ControlKind.Area).Select(control => control.Kind)))
        {
            throw new InvalidOperationException("Layout and repaint have other controls.");
        }
        s_Controls = repaint;
    }

    private static List<DrawnControl> Pass(Action sendAll, ScreenPage page, Event what)
    {
        GuiPage.Current = page;
        Event.current = what;
        try
        {
            sendAll();
            page.Close();
        }
        finally
        {
            GuiPage.Current = null;
            Event.current = null;
        }

        return what.type == EventType.Layout ? page.Controls.FindAll(control => control.Kind != ControlKind.Area) : page.Controls;
    }
}
