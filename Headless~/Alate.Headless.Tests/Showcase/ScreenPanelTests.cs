using System.Collections;
using System.Linq;
using Alate.Showcase;
using NUnit.Framework;
using StandIns;
using UnityEngine;
using UnityEngine.InputSystem;
using UnityEngine.TestTools;

namespace Alate.Tests.Play.Showcase;

public sealed class ScreenPanelTests : PlayFixture
{
    private static readonly string[] s_Words = ["one", "two", "three"];

    private Mouse m_Mouse;

    [TearDown]
    public void RemoveMouse()
    {
        if (m_Mouse != null)
            InputSystem.RemoveDevice(m_Mouse);
        m_Mouse = null;
        Unity.StandIns.ShownScreen.Dpi = 96f;
    }

    [UnityTest]
    public IEnumerator ASlider_HasTheValueThatThePointerIsAt()
    {
        TriedPanel shown = Show();
        yield return Frames(2);
        DrawnScreen.Slide("Speed", 3.25f);
        yield return Frames(3);
        Assert.That(shown.Speed, Is.EqualTo(3.25f).Within(1e-4f));
    }

    [UnityTest]
    public IEnumerator AHeldSlider_FollowsThePointerAnywhere_AndStopsAtItsEnds([Values] bool bySystem)
    {
        TriedPanel shown = Show();
        yield return Frames(2);
        Rect slider = DrawnScreen.Controls.Single(control => control.Kind == ControlKind.Field).Place;
        foreach ((float x, float y, float speed) in new[]
            { (slider.center.x, slider.center.y, 3f), (slider.xMax + 500f, 900f, 4f), (slider.xMin - 5f, 0f, 2f) })
        {
            Point(bySystem, new Vector2(x, y), true);
            yield return Frames(1);
            Assert.That(shown.Speed, Is.EqualTo(speed).Within(1e-4f));
        }

        Point(bySystem, new Vector2(slider.xMin, slider.center.y), false);
        yield return Frames(2);
        Point(bySystem, slider.center + new Vector2(0f, 300f), true);
        yield return Frames(2);
        Point(bySystem, slider.center, true);
        yield return Frames(2);
        Assert.That(shown.Speed, Is.EqualTo(2f), "a press that began beside the panel takes nothing");
        Point(bySystem, slider.center, false);
    }

    [UnityTest]
    public IEnumerator AButton_ActsOnce_WhenItIsLetGo([Values] bool bySystem, [Values] bool isLetGoBeside)
    {
        TriedPanel shown = Show();
        yield return Frames(2);
        Vector2 button = DrawnScreen.Controls.Single(control => control.Text == "Go").Place.center;
        Point(bySystem, button, true);
        yield return Frames(4);
        Assert.That(shown.Presses, Is.Zero);
        Point(bySystem, isLetGoBeside ? button + new Vector2(400f, 0f) : button, false);
        yield return Frames(4);
        Assert.That(shown.Presses, Is.EqualTo(isLetGoBeside ? 0 : 1));
    }

    [UnityTest]
    public IEnumerator ATick_ChangesAtEachPress_AndAChoiceIsTheLastPressed()
    {
        TriedPanel shown = Show();
        yield return Frames(2);
        foreach (bool value in new[] { true, false, true })
        {
            DrawnScreen.Press("Tick");
            yield return Frames(3);
            Assert.That(shown.IsTicked, Is.EqualTo(value));
        }

        foreach (string word in new[] { "three", "one", "one", "two" })
        {
            DrawnScreen.Press(word);
            yield return Frames(3);
            Assert.That(s_Words[shown.Word], Is.EqualTo(word));
        }
    }

    [UnityTest]
    public IEnumerator Controls_LieOnThePanel_AndNotOnOneAnother()
    {
        Show();
        yield return Frames(2);
        var all = DrawnScreen.Controls.ToList();
        Assert.That(all, Has.Count.EqualTo(7));
        foreach (DrawnControl control in all)
        {
            Assert.That(ScreenPanel.Covers(control.Place.min) && ScreenPanel.Covers(control.Place.max - Vector2.one), Is.True);
            foreach (DrawnControl other in all.Where(other => !ReferenceEquals(other, control)))
                Assert.That(control.Place.Overlaps(other.Place), Is.False, $"{control} and {other}");
        }

        Assert.That(ScreenPanel.Covers(new Vector2(600f, 20f)), Is.False);
    }

    [UnityTest]
    public IEnumerator APanelThatIsDrawnNoMore_CoversNothing()
    {
        TriedPanel shown = Show();
        yield return Frames(2);
        Assert.That(ScreenPanel.Covers(new Vector2(20f, 20f)), Is.True);
        UnityEngine.Object.Destroy(shown.gameObject);
        yield return Frames(3);
        Assert.That(ScreenPanel.Covers(new Vector2(20f, 20f)), Is.False);
    }

    [UnityTest]
    public IEnumerator TheCamera_StaysWhileTheSliderIsDragged_AndTurnsOtherwise([Values] bool bySystem)
    {
        Show();
        var orbit = OrbitCamera.Create(Keep(new GameObject("stage")).transform, Vector3.zero, 2f);
        yield return Frames(2);
        float yaw = orbit.Yaw;
        Vector2 slider = DrawnScreen.Controls.Single(control => control.Kind == ControlKind.Field).Place.center;
        foreach (Vector2 from in new[] { slider, new Vector2(900f, 500f) })
        {
            Point(bySystem, from, true);
            yield return Frames(2);
            Point(bySystem, from + new Vector2(200f, 0f), true);
            yield return Frames(2);
            Point(bySystem, from, false);
            yield return Frames(2);
            Assert.That(orbit.Yaw - yaw, Is.EqualTo(from == slider ? 0f : 60f).Within(1e-3f), "0.3 degrees a pixel");
        }
    }

    // Steps of one half, so that lines stay sharp; never below one.
    [UnityTest]
    public IEnumerator OnAFineScreen_ThePanelIsAsLarge_AndThePointerMeetsWhatIsDrawn(
        [Values(0f, 72f, 96f, 130f, 192f, 460f)] float dpi, [Values] bool bySystem)
    {
        Unity.StandIns.ShownScreen.Dpi = dpi;
        float scale = Mathf.Max(1f, Mathf.Round(dpi / 48f) / 2f);
        TriedPanel shown = Show();
        yield return Frames(2);
        Assert.That(ScreenPanel.Covers(scale * new Vector2(289f, 20f)), Is.True);
        Assert.That(ScreenPanel.Covers(scale * new Vector2(291f, 20f)), Is.False, "280 units beside a margin of 10");
        Rect slider = DrawnScreen.Controls.Single(control => control.Kind == ControlKind.Field).Place;
        Point(bySystem, scale * slider.center, true);
        yield return Frames(1);
        Point(bySystem, scale * new Vector2(Mathf.Lerp(slider.xMin, slider.xMax, 0.75f), slider.center.y), true);
        yield return Frames(1);
        Assert.That(shown.Speed, Is.EqualTo(3.5f).Within(1e-4f));
        Point(bySystem, slider.center, false);
        yield return Frames(1);
    }

    [UnityTest]
    public IEnumerator APanelThatWentWhileItsSliderWasHeld_TakesNothingOfALaterPress([Values] bool bySystem)
    {
        TriedPanel other = Show();
        yield return Frames(2);
        Rect slider = DrawnScreen.Controls.Single(control => control.Kind == ControlKind.Field).Place;

        // Of two in one place the one that is drawn later takes the press.
        TriedPanel gone = Show();
        yield return Frames(2);
        Point(bySystem, slider.center, true);
        yield return Frames(2);
        float speed = gone.Speed;
        gone.enabled = false;
        Point(bySystem, slider.center, false);
        yield return Frames(2);
        Point(bySystem, new Vector2(900f, 500f), true);
        yield return Frames(2);
        gone.enabled = true;
        Point(bySystem, new Vector2(slider.xMax, slider.center.y), true);
        yield return Frames(2);
        Assert.That(gone.Speed, Is.EqualTo(speed));
        Point(bySystem, slider.center, false);
        yield return Frames(2);
        Assert.That(other.enabled, Is.True);
    }

    // One panel is drawn after the other: in between, what the other covers is still covered.
    [UnityTest]
    public IEnumerator BetweenTwoPanels_BothCoverTheirPlaces()
    {
        PairOfPanels pair = Keep(new GameObject("pair")).AddComponent<PairOfPanels>();
        yield return Frames(4);
        Assert.That(pair.Seen, Is.GreaterThan(2));
        Assert.That(pair.Covered, Is.EqualTo(pair.Seen - 1), "in all frames but the first");
    }

    /// <summary>A narrow panel, and a wide one that is drawn after it.</summary>
    private sealed class PairOfPanels : MonoBehaviour
    {
        private readonly ScreenPanel m_Narrow = new(100f), m_Wide = new(300f);

        public int Seen { get; private set; }

        public int Covered { get; private set; }

        private void OnGUI()
        {
            if (!m_Narrow.Begin())
                return;
            m_Narrow.Label("narrow");
            m_Narrow.End();
            Seen++;
            Covered += ScreenPanel.Covers(new Vector2(250f, 20f)) ? 1 : 0;
            if (!m_Wide.Begin())
                return;
            m_Wide.Label("wide");
            m_Wide.End();
        }
    }

    private TriedPanel Show() => Keep(new GameObject("shown")).AddComponent<TriedPanel>();

    private void Point(bool bySystem, Vector2 place, bool isDown)
    {
        var fromBelow = new Vector2(place.x, Screen.height - place.y);
        if (bySystem)
        {
            m_Mouse ??= InputSystem.AddDevice<Mouse>();
            m_Mouse.position.Set(fromBelow);
            m_Mouse.leftButton.Set(isDown ? 1f : 0f);
            return;
        }

        Input.MoveMouse(fromBelow);
        Input.HoldMouse(0, isDown);
    }

    /// <summary>A panel with one control of each kind.</summary>
    private sealed class TriedPanel : MonoBehaviour
    {
        private readonly ScreenPanel m_Panel = new(280f);

        public float Speed { get; private set; } = 2.5f;

        public bool IsTicked { get; private set; }

        public int Presses { get; private set; }

        public int Word { get; private set; }

        private void OnGUI()
        {
            if (!m_Panel.Begin())
                return;
            Speed = m_Panel.Slider("Speed", Speed, 2f, 4f);
            IsTicked = m_Panel.Toggle("Tick", IsTicked);
            if (m_Panel.Button("Go"))
                Presses++;
            Word = m_Panel.Choose(Word, s_Words);
            m_Panel.End();
        }
    }
}
