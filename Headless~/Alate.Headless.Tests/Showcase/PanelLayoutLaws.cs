using System.Collections;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using Alate.Showcase;
using NUnit.Framework;
using StandIns;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play.Showcase;

/// <summary>Places of a panel's controls, and what a panel leaves behind.</summary>
public sealed class PanelLayoutLaws : PlayFixture
{
    [TearDown]
    public void GiveBackTheScreen()
    {
        Unity.StandIns.ShownScreen.Dpi = 96f;
        Input.HoldMouse(0, false);
        Input.Scroll(0f);
    }

    [UnityTest]
    public IEnumerator APanel_IsAsWideAroundItsControls_OnAllSides()
    {
        Show();
        yield return Frames(2);
        var all = DrawnScreen.Controls.Select(control => control.Place).ToList();
        float left = all.Min(place => place.xMin), right = all.Max(place => place.xMax);
        float top = all.Min(place => place.yMin), bottom = all.Max(place => place.yMax);
        float padding = left - Edge(new Vector2(left, top), -Vector2.right);
        Assert.That(padding, Is.GreaterThan(2f));
        Assert.That(Edge(new Vector2(right, top), Vector2.right) - right, Is.EqualTo(padding).Within(0.2f));
        Assert.That(top - Edge(new Vector2(left, top), -Vector2.up), Is.EqualTo(padding).Within(0.2f));
        Assert.That(Edge(new Vector2(left, bottom), Vector2.up) - bottom, Is.EqualTo(padding).Within(0.2f));
        Assert.That(Edge(new Vector2(left, top), -Vector2.right), Is.EqualTo(Edge(new Vector2(left, top), -Vector2.up)).Within(0.2f),
            "as far from both sides of the screen");
    }

    [UnityTest]
    public IEnumerator Gaps_AreAlike_DownThePanelAndAlongARow()
    {
        Show();
        yield return Frames(2);
        var rows = DrawnScreen.Controls.Select(control => control.Place).GroupBy(place => place.yMin)
            .OrderBy(row => row.Key).Select(row => row.OrderBy(place => place.xMin).ToList()).ToList();
        Assert.That(rows.Select(row => row.Count), Is.EqualTo(new[] { 1, 1, 2, 3, 1 }));
        float gap = rows[1][0].yMin - rows[0][0].yMax;
        Assert.That(gap, Is.GreaterThan(1f));
        for (int row = 1; row < rows.Count; row++)
            Assert.That(rows[row][0].yMin - rows[row - 1][0].yMax, Is.EqualTo(gap).Within(1e-3f), $"above row {row}");
        foreach (List<Rect> row in rows)
        {
            Assert.That(row[0].xMin, Is.EqualTo(rows[0][0].xMin).Within(1e-3f));
            Assert.That(row[^1].xMax, Is.EqualTo(rows[0][0].xMax).Within(1e-3f), "from side to side");
            Assert.That(row.Select(place => place.width), Is.All.EqualTo(row[0].width).Within(1e-3f));
            for (int k = 1; k < row.Count; k++)
                Assert.That(row[k].xMin - row[k - 1].xMax, Is.EqualTo(gap).Within(1e-3f));
        }
    }

    [UnityTest]
    public IEnumerator TwoColumns_HoldForOneRow()
    {
        ShownPanel shown = Show();
        yield return Frames(2);
        DrawnControl left = Control("left"), last = Control("last");
        Assert.That(Control("right").Place.yMin, Is.EqualTo(left.Place.yMin));
        Assert.That(last.Place.width, Is.GreaterThan(2f * left.Place.width), "the whole width again");
        Assert.That(shown.Panel, Is.Not.Null);

        DrawnControl Control(string text) => DrawnScreen.Controls.Single(control => control.Text == text);
    }

    // What is drawn after a panel, of the game or of another panel, is where it is asked for.
    [UnityTest]
    public IEnumerator APanel_LeavesNoScaleBehind()
    {
        Unity.StandIns.ShownScreen.Dpi = 192f;
        ShownPanel shown = Show();
        yield return Frames(2);
        Assert.That(shown.Within.m00, Is.EqualTo(2f));
        Assert.That(shown.Behind, Is.EqualTo(Matrix4x4.identity));
    }

    [UnityTest]
    public IEnumerator PanelsThatAreDrawnNoMore_AreForgotten()
    {
        var drawn = (List<ScreenPanel>)typeof(ScreenPanel).GetField("s_Drawn", BindingFlags.NonPublic | BindingFlags.Static).GetValue(null);
        ShownPanel staying = Show(), going = Show();
        yield return Frames(3);
        Assert.That(drawn, Is.EquivalentTo(new[] { staying.Panel, going.Panel }));
        going.enabled = false;
        yield return Frames(3);
        Assert.That(drawn, Is.EqualTo(new[] { staying.Panel }));
    }

    [UnityTest]
    public IEnumerator TheWheel_OverAPanel_LeavesTheCameraWhereItIs([Values] bool isOver)
    {
        Show();
        var orbit = OrbitCamera.Create(Keep(new GameObject("stage")).transform, Vector3.zero, 2f);
        yield return Frames(2);
        Input.MoveMouse(new Vector2(isOver ? 30f : 900f, Screen.height - 30f));
        Input.Scroll(1f);
        yield return Frames(1);
        Assert.That(orbit.Distance < 2f, Is.Not.EqualTo(isOver));
        Assert.That(orbit.Distance, Is.LessThanOrEqualTo(2f));
    }

    // The last place on the way, a tenth of a unit a step, that the panel covers.
    private static float Edge(Vector2 from, Vector2 way)
    {
        Vector2 place = from;
        while (ScreenPanel.Covers(place + 0.1f * way))
            place += 0.1f * way;
        return way.x != 0f ? place.x : place.y;
    }

    private ShownPanel Show() => Keep(new GameObject("shown")).AddComponent<ShownPanel>();

    private sealed class ShownPanel : MonoBehaviour
    {
        private static readonly string[] s_Words = ["one", "two", "three"];

        public ScreenPanel Panel { get; } = new(280f);

        public Matrix4x4 Within { get; private set; }

        public Matrix4x4 Behind { get; private set; }

        private void OnGUI()
        {
            if (!Panel.Begin())
                return;
            Within = GUI.matrix;
            Panel.Label("one line");
            Panel.Toggle("tick", true);
            Panel.Row(2);
            Panel.Button("left");
            Panel.Button("right");
            Panel.Choose(1, s_Words);
            Panel.Button("last");
            Panel.End();
            Behind = GUI.matrix;
        }
    }
}
