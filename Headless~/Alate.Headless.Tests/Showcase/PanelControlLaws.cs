using System.Collections;
using System.Collections.Generic;
using System.Linq;
using Alate.Showcase;
using NUnit.Framework;
using StandIns;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play.Showcase;

/// <summary>Room of a panel's controls, what reaches them, and a panel that is painted twice.</summary>
public sealed class PanelControlLaws : PlayFixture
{
    private const float k_Gap = 4f, k_Line = 22f, k_Slider = 14f, k_Edge = 8f;

    [TearDown]
    public void LetGo()
    {
        Input.HoldMouse(0, false);
        Input.Release(KeyCode.Alpha7);
    }

    // The box is as large as what the panel covers, and in front of it are the controls.
    [UnityTest]
    public IEnumerator BehindTheControls_LiesABox_WhereThePanelCoversTheScreen()
    {
        Show(200f, panel =>
        {
            panel.Label("one");
            panel.Button("two");
        });
        yield return Frames(3);
        Rect box = DrawnScreen.Boxes.Single();
        Assert.That((box.x, box.y, box.width, box.height), Is.EqualTo((10f, 10f, 200f, 2f * k_Line + k_Gap + 2f * k_Edge)));
        foreach (DrawnControl control in DrawnScreen.Controls)
        {
            Assert.That(control.Place.xMin - box.xMin, Is.EqualTo(k_Edge));
            Assert.That(box.xMax - control.Place.xMax, Is.EqualTo(k_Edge));
        }

        Assert.That(ScreenPanel.Covers(box.min + 0.1f * Vector2.one) && ScreenPanel.Covers(box.max - 0.1f * Vector2.one));
        Assert.That(ScreenPanel.Covers(box.min - 0.1f * Vector2.one) || ScreenPanel.Covers(box.max + 0.1f * Vector2.one), Is.False);
    }

    // One of a line is as high as a button; one of more as high as its lines, 18 each here.
    [UnityTest]
    public IEnumerator ALabel_IsAsHighAsItsText_AndALineAtLeast()
    {
        Show(200f, panel =>
        {
            panel.Label("one line");
            panel.Label("one\ntwo\nthree");
            panel.Row(2);
            panel.Label("broken in half a row");
            panel.Button("beside");
            panel.Slider("value", 1f, 0f, 2f);
        });
        yield return Frames(2);
        Assert.That(Place("one line").height, Is.EqualTo(k_Line));
        Assert.That(Place("one\ntwo\nthree").height, Is.EqualTo(3f * 18f));
        Assert.That(Place("broken in half a row").height, Is.EqualTo(2f * 18f), "20 letters of 7 in 90 pixels");
        Assert.That(DrawnScreen.Controls.Single(control => control.Kind == ControlKind.Field).Place.height, Is.EqualTo(k_Slider));
    }

    // A gap around it on all sides; beyond that a press is none of its.
    [UnityTest]
    public IEnumerator ASlider_IsTaken_AGapBesideItToo([Values] bool isWithin, [Values(0, 1, 2, 3)] int side)
    {
        float value = 1f;
        Show(200f, panel =>
        {
            panel.Label("above");
            value = panel.Slider("value", value, 0f, 2f);
        });
        yield return Frames(2);
        Rect slider = DrawnScreen.Controls.Single(control => control.Kind == ControlKind.Field).Place;
        float away = isWithin ? 0.95f * k_Gap : 1.05f * k_Gap, across = slider.xMin + 0.25f * slider.width;
        Vector2 place = side switch
        {
            0 => new Vector2(slider.xMin - away, slider.center.y),
            1 => new Vector2(slider.xMax + away, slider.center.y),
            2 => new Vector2(across, slider.yMin - away),
            _ => new Vector2(across, slider.yMax + away),
        };
        Point(place, true);
        yield return Frames(2);
        Assert.That(value, Is.EqualTo(!isWithin ? 1f : side == 0 ? 0f : side == 1 ? 2f : 0.5f).Within(1e-4f));
    }

    [UnityTest]
    public IEnumerator APanelThatIsPaintedTwiceInAFrame_ReactsOnce()
    {
        bool isTicked = false;
        int presses = 0, digits = 0;
        ShownPanel shown = Show(200f, panel =>
        {
            isTicked = panel.Toggle("tick", isTicked);
            presses += panel.Button("go") ? 1 : 0;
            digits += panel.Digit == 7 ? 1 : 0;
        });
        shown.Paints = 2;
        yield return Frames(2);
        foreach (string text in new[] { "tick", "go" })
        {
            Vector2 place = DrawnScreen.Controls.First(control => control.Text == text).Place.center;
            Point(place, true);
            yield return Frames(2);
            Point(place, false);
            yield return Frames(3);
        }

        Assert.That((isTicked, presses), Is.EqualTo((true, 1)));
        Input.Press(KeyCode.Alpha7);
        yield return Frames(3);
        Assert.That(digits, Is.EqualTo(1));
    }

    [UnityTest]
    public IEnumerator ARowThatWasNotFilled_EndsWithItsPanel()
    {
        Show(200f, panel =>
        {
            panel.Button("first");
            panel.Row(3);
            panel.Button("left");
            panel.Button("middle");
        });
        yield return Frames(3);
        Assert.That(ScreenPanel.Covers(Place("left").max + 0.9f * k_Edge * Vector2.up), "it is part of the panel");
        Assert.That(Place("first").width, Is.EqualTo(200f - 2f * k_Edge));
        Assert.That(Place("left").width, Is.EqualTo((200f - 2f * k_Edge - 2f * k_Gap) / 3f).Within(1e-4f));
    }

    [UnityTest]
    public IEnumerator ARow_IsAsHighAsItsHighestControl_AndTheNextIsBelowIt()
    {
        string[] words = ["a", "b"];
        Show(200f, panel =>
        {
            panel.Row(2);
            panel.Label("one\ntwo\nthree");
            panel.Button("low");
            panel.Row(3);
            panel.Button("left");
            panel.Choose(0, words);
            panel.Label("last");
        });
        yield return Frames(3);
        Rect high = Place("one\ntwo\nthree");
        Assert.That(Place("low").yMin, Is.EqualTo(high.yMin));
        Assert.That(Place("left").yMin, Is.EqualTo(high.yMax + k_Gap));
        Assert.That(Place("a").yMin, Is.EqualTo(Place("left").yMax + k_Gap), "another row, though the one above has room");
        Assert.That(Place("last").yMin, Is.EqualTo(Place("b").yMax + k_Gap));
    }

    [UnityTest]
    public IEnumerator AChoice_IsAsItWas_UntilOneIsPressed([Values(0, 2)] int first)
    {
        string[] words = ["a", "b", "c"];
        int chosen = first;
        Show(200f, panel => chosen = panel.Choose(chosen, words));
        yield return Frames(3);
        Assert.That(chosen, Is.EqualTo(first));
        IEnumerable<string> ticked = DrawnScreen.Controls.Where(control => control.Value == "True").Select(control => control.Text);
        Assert.That(ticked, Is.EqualTo(new[] { words[first] }));
    }

    private static Rect Place(string text) => DrawnScreen.Controls.First(control => control.Text == text).Place;

    private static void Point(Vector2 place, bool isDown)
    {
        Input.MoveMouse(new Vector2(place.x, Screen.height - place.y));
        Input.HoldMouse(0, isDown);
    }

    private ShownPanel Show(float width, System.Action<ScreenPanel> controls)
    {
        ShownPanel shown = Keep(new GameObject("shown")).AddComponent<ShownPanel>();
        shown.Panel = new ScreenPanel(width);
        shown.Controls = controls;
        return shown;
    }

    /// <summary>A panel with the controls of a test.</summary>
    private sealed class ShownPanel : MonoBehaviour
    {
        public ScreenPanel Panel { get; set; }

        public System.Action<ScreenPanel> Controls { get; set; }

        public int Paints { get; set; } = 1;

        private void OnGUI()
        {
            for (int paint = 0; paint < Paints; paint++)
            {
                if (!Panel.Begin())
                    return;
                Controls(Panel);
                Panel.End();
            }
        }
    }
}
