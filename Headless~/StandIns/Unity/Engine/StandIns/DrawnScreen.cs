using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace StandIns;

/// <summary>
/// The screen that OnGUI of playing scripts draws on, at the end of each frame: for layout and for repaint, which must lay out the same
/// controls. Areas lie on the screen and hold their lines, and every group is closed. A test moves mouse and keys, which scripts find in
/// <see cref="Input"/>; no event of them reaches OnGUI, as where the Input System is the only back end.
/// </summary>
[Unity.StandIns.StandInExtension]
public static class DrawnScreen
{
    private static readonly Queue<Action> s_Acts = new();
    private static ScreenPage s_Page = new();

    /// <summary>Controls of the last frame, in the order in which they were drawn.</summary>
    public static IReadOnlyList<DrawnControl> Controls => s_Page.Controls;

    /// <summary>Places of the boxes of the last frame, in the order in which they were drawn.</summary>
    public static IReadOnlyList<Rect> Boxes => s_Page.Boxes;

    /// <summary>Sliders of the last frame in the order in which they were drawn.</summary>
    public static IReadOnlyList<DrawnSlider> Sliders => s_Page.Sliders;

    /// <summary>All texts of the last frame, joined.</summary>
    public static string Text => string.Join("\n", Controls.Select(control => control.Text));

    /// <summary>True where a test has acts that no frame has done yet.</summary>
    public static bool IsBusy => s_Acts.Count > 0;

    /// <summary>Presses a button or toggle in the next frame, and lets it go in the one after it.</summary>
    public static void Press(string text)
    {
        s_Acts.Enqueue(() => Hold(Find(text).Place.center));
        s_Acts.Enqueue(Release);
    }

    /// <summary>Takes the slider below the label that begins with a text in the next frame, and lets it go in the one after it.</summary>
    public static void Slide(string label, float value)
    {
        s_Acts.Enqueue(() =>
        {
            DrawnSlider found = s_Page.Sliders.Find(slider => slider.Label.StartsWith(label, StringComparison.Ordinal))
                ?? throw new InvalidOperationException($"There is no slider '{label}' on the screen.");
            float share = Math.Clamp((value - found.Left) / (found.Right - found.Left), 0f, 1f);
            Hold(new Vector2(found.Place.xMin + share * found.Place.width, found.Place.center.y));
        });
        s_Acts.Enqueue(Release);
    }

    /// <summary>Presses a key, which the frame after the next sees go down.</summary>
    public static void Key(KeyCode key)
    {
        s_Acts.Enqueue(() => Input.Press(key));
        s_Acts.Enqueue(() => Input.Release(key));
    }

    /// <summary>Moves the mouse with its left button held, beside all controls: three frames.</summary>
    /// <param name="way">Pixels to the right and down.</param>
    public static void Drag(Vector2 way)
    {
        var corner = new Vector2(Screen.width - 1f, Screen.height - 1f);
        s_Acts.Enqueue(() => Hold(corner - way));
        s_Acts.Enqueue(() => Hold(corner));
        s_Acts.Enqueue(Release);
    }

    /// <summary>Turns the mouse's wheel in the next frame, beside all controls.</summary>
    /// <param name="notches">Away from the user positive.</param>
    public static void Scroll(float notches)
    {
        s_Acts.Enqueue(() =>
        {
            Input.MoveMouse(new Vector2(Screen.width - 1f, 1f));
            Input.Scroll(notches);
        });
        s_Acts.Enqueue(() => Input.Scroll(0f));
    }

    /// <summary>Does the next act of the test.</summary>
    internal static void BeginFrame()
    {
        if (s_Acts.TryDequeue(out Action act))
            act();
    }

    /// <summary>Forgets all acts, as between two tests.</summary>
    internal static void Forget()
    {
        s_Acts.Clear();
        Release();
        Input.Scroll(0f);
        s_Page = new ScreenPage();
    }

    /// <summary>Draws a frame.</summary>
    internal static void Draw(Action sendAll)
    {
        ScreenPage layout = Pass(sendAll, EventType.Layout), repaint = Pass(sendAll, EventType.Repaint);
        if (!layout.LaidOut.SequenceEqual(repaint.LaidOut))
            throw new InvalidOperationException("Layout and repaint have other controls.");
        s_Page = repaint;
    }

    private static DrawnControl Find(string text) =>
        Controls.FirstOrDefault(control => control.Text == text && control.Kind is ControlKind.Button or ControlKind.Toggle)
        ?? throw new InvalidOperationException($"There is nothing on the screen to do '{text}' to.");

    // GUI counts from the upper left corner, Input from the lower left one.
    private static void Hold(Vector2 place)
    {
        Input.MoveMouse(new Vector2(place.x, Screen.height - place.y));
        Input.HoldMouse(0, true);
    }

    private static void Release() => Input.HoldMouse(0, false);

    private static ScreenPage Pass(Action sendAll, EventType what)
    {
        var page = new ScreenPage();
        GuiPage.Current = page;
        Event.current = new Event { type = what };
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

        return page;
    }
}
