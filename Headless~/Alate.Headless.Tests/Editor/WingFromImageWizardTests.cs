using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Alate.Editor;
using NUnit.Framework;
using StandIns;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Alate.Tests.Editor;

/// <summary>The window that traces a wing, as it is drawn: from a picture to the assets.</summary>
public sealed class WingFromImageWizardTests
{
    private const string k_Menu = "Assets/Create/Alate/Wing from Image...";
    private const string k_Picture = "Assets/blade.png";

    private Texture2D m_Drawn;
    private EditorWindow m_Window;
    private Action m_Gui;

    [SetUp]
    public void Open()
    {
        // An ellipse with the base on the left, its leading edge above: 100 pixels long, in rows that count from below.
        m_Drawn = new Texture2D(120, 80) { name = "blade" };
        m_Drawn.SetPixels32([.. Enumerable.Range(0, 120 * 80).Select(k =>
        {
            double x = (k % 120 - 59.5) / 50, y = (k / 120 - 39.5) / 22;
            return x * x + y * y < 1 ? new Color32(30, 20, 10, 255) : new Color32(240, 240, 240, 255);
        })]);
        m_Drawn.Apply();
        Selection.activeObject = null;
        EditorMenu.Choose(k_Menu);
        m_Window = OpenWindows.All.Single();
        m_Gui = DrawnInspector.Of(m_Window);
    }

    [TearDown]
    public void Close()
    {
        foreach (EditorWindow window in OpenWindows.All)
            Object.DestroyImmediate(window);
        OpenWindows.All.Clear();
        DrawnLines.Calls = null;
        Selection.activeObject = null;
        ProjectAssets.Clear();
        Object.DestroyImmediate(m_Drawn);
    }

    [Test]
    public void WithoutAPicture_OnlyOneIsAskedFor()
    {
        var page = DrawnInspector.Of(m_Gui);

        Assert.That(page.HelpBoxes.Single(), Does.StartWith("Pick a picture"));
        Assert.That(page.Buttons, Is.Empty);
        Assert.That(m_Window.titleContent.text, Is.EqualTo("Wing from Image"));
    }

    [Test]
    public void APictureThatWasSelected_IsTaken()
    {
        Selection.activeObject = m_Drawn;
        EditorMenu.Choose(k_Menu);

        Assert.That(DrawnInspector.Of(DrawnInspector.Of(OpenWindows.All[1])).Control("Image").Value, Is.EqualTo("blade"));
    }

    [Test]
    public void ATrace_HasWhatTheFieldsSay_AndIsSavedOnce()
    {
        Take(Import());
        var page = DrawnInspector.Of(m_Gui);
        Assert.That(new[] { "Chains", "Joints", "Triangles", "Length", "Leading Edge", "Vein Widths", "Set Hinge" }
            .Select(label => page.Control(label).Value), Is.EqualTo(new[] { "5", "5", "1000", "1", "Automatic", "off", "off" }));
        Assert.That(page.Controls.Where(control => control.Kind == ControlKind.Field).Select(field => field.Tooltip), Has.None.Empty);

        Put("Chains", 6);
        Put("Joints", 4);
        Put("Triangles", 7);
        Assert.That(DrawnInspector.Of(m_Gui).Control("Triangles").Value, Is.EqualTo("50"), "clamped");
        Put("Triangles", 300);
        Put("Length", 2.5f);
        Assert.That(DrawnInspector.Press(m_Gui, "Trace").Buttons, Has.Member("Save Mesh and Skeleton"));
        page = DrawnInspector.Press(m_Gui, "Save Mesh and Skeleton");
        Assert.That(page.Buttons, Has.No.Member("Save Mesh and Skeleton"), "once");

        WingSkeleton skeleton = AssetDatabase.LoadAssetAtPath<WingSkeleton>("Assets/blade Skeleton.asset");
        Mesh mesh = AssetDatabase.LoadAssetAtPath<Mesh>("Assets/blade.asset");
        Assert.That((skeleton.ChainCount, skeleton.JointsPerChain, skeleton.name), Is.EqualTo((6, 4, "blade Skeleton")));
        Assert.That((mesh.triangles.Length / 3, mesh.tangents.Length), Is.EqualTo((300, mesh.vertexCount)));
        Assert.That(mesh.bounds.size.x, Is.EqualTo(2.5f).Within(0.1f), "from hinge to tip");
        Assert.That(mesh.bounds.size.z, Is.EqualTo(2.5f * 44f / 100f).Within(0.1f));

        // A changed field begins anew; what was saved stays.
        Put("Chains", 5);
        Assert.That(skeleton == null, Is.False);
        DrawnInspector.Press(m_Gui, "Trace");
        DrawnInspector.Press(m_Gui, "Save Mesh and Skeleton");
        Assert.That(AssetDatabase.LoadAssetAtPath<WingSkeleton>("Assets/blade Skeleton 1.asset").ChainCount, Is.EqualTo(5));
        Assert.That(AssetDatabase.LoadAssetAtPath<Mesh>("Assets/blade 1.asset"), Is.Not.Null);
    }

    [Test]
    public void TheTrace_IsDrawnOverThePicture_AndGoesWithAChange()
    {
        Take(m_Drawn);
        Assert.That(Lines(), Is.Empty);
        DrawnInspector.Press(m_Gui, "Trace");
        List<(Color Colour, Vector3[] Points)> drawn = Lines();
        Rect frame = Frame();

        Assert.That(frame.width / frame.height, Is.EqualTo(1.5f).Within(1e-3f), "as the picture");
        Vector3[] rim = drawn[0].Points;
        Assert.That(rim[^1], Is.EqualTo(rim[0]), "closed");
        foreach (Vector3 at in rim)
        {
            double x = ((at.x - frame.x) / frame.width * 120 - 60) / 50, y = ((at.y - frame.y) / frame.height * 80 - 40) / 22;
            Assert.That(x * x + y * y, Is.EqualTo(1).Within(0.06), $"{at} is on the wing's rim");
        }

        // Five chains of five joints: a line each, a disc a joint at its place.
        (Color Colour, Vector3[] Points)[] chains = [.. drawn.Where(line => line.Points.Length == 5)];
        Assert.That(chains, Has.Length.EqualTo(5));
        foreach ((_, Vector3[] joints) in chains)
        {
            foreach (Vector3 joint in joints)
            {
                Vector3[] disc = [joint, 3f * Vector3.forward];
                Assert.That(drawn.Any(line => line.Points.SequenceEqual(disc)));
                double x = ((joint.x - frame.x) / frame.width * 120 - 60) / 50, y = ((joint.y - frame.y) / frame.height * 80 - 40) / 22;
                Assert.That(x * x + y * y, Is.LessThan(1.06), "in the wing");
            }
        }

        Assert.That(chains[0].Points.Average(joint => joint.y), Is.LessThan(chains[4].Points.Average(joint => joint.y)), "led from above");
        Assert.That(chains[0].Points[4].x, Is.GreaterThan(chains[0].Points[0].x), "from the base on the left");
        Put("Joints", 6);
        Assert.That(Lines(), Is.Empty);
        Put("Leading Edge", WingImageSide.Down);
        DrawnInspector.Press(m_Gui, "Trace");
        chains = [.. Lines().Where(line => line.Points.Length == 6)];
        Assert.That(chains[0].Points.Average(joint => joint.y), Is.GreaterThan(chains[4].Points.Average(joint => joint.y)), "from below");
    }

    [Test]
    public void AClick_SetsTheHinge_WhereItWasAskedFor()
    {
        Take(m_Drawn);
        DrawnInspector.Press(m_Gui, "Trace");
        Rect frame = Frame();
        Vector2 middle = frame.position + new Vector2(0.1f * frame.width, 0.5f * frame.height);
        DrawnInspector.Click(m_Gui, middle);
        Assert.That(DrawnInspector.Of(m_Gui).Buttons, Has.Member("Save Mesh and Skeleton"), "no hinge is asked for");

        DrawnInspector.Press(m_Gui, "Set Hinge");
        frame = Frame();
        DrawnInspector.Click(m_Gui, new Vector2(frame.center.x, frame.yMax + 50f));
        Assert.That(DrawnInspector.Of(m_Gui).Control("Hinge").Value, Is.EqualTo("(0.00, 0.00)"), "beside the picture");
        DrawnInspector.Press(m_Gui, "Trace");
        frame = Frame();
        var page = DrawnInspector.Click(m_Gui, frame.position + new Vector2(0.1f * frame.width, 0.5f * frame.height));
        Assert.That(page.Control("Hinge").Value, Is.EqualTo("(12.00, 40.00)"), "pixels from the top left");
        Assert.That(page.Buttons, Has.No.Member("Save Mesh and Skeleton"), "the trace is another one's");
        Put("Hinge", new Vector2(11f, 41f));
        Assert.That(DrawnInspector.Of(m_Gui).Control("Hinge").Value, Is.EqualTo("(11.00, 41.00)"));
    }

    [Test]
    public void WhatCannotBeTracedOrRead_IsSaid_AndAnotherPictureBeginsAnew()
    {
        var plain = new Texture2D(60, 40) { name = "plain" };
        plain.SetPixels32([.. Enumerable.Repeat(new Color32(90, 90, 90, 255), 2400)]);
        plain.Apply();
        Take(plain);
        var page = DrawnInspector.Press(m_Gui, "Trace");
        Assert.That(page.HelpBoxes.Count(), Is.EqualTo(1));
        Assert.That(page.Buttons, Is.EqualTo(new[] { "Trace" }));

        var closed = new Texture2D(4, 4) { name = "closed" };
        closed.Apply(false, true);
        Take(closed);
        page = DrawnInspector.Of(m_Gui);
        Assert.That(page.HelpBoxes.Single(), Does.StartWith("The file of 'closed' cannot be read"));
        Assert.That(page.Buttons, Is.Empty);

        Take(m_Drawn);
        Assert.That(DrawnInspector.Of(m_Gui).Buttons, Is.EqualTo(new[] { "Trace" }));
        Take(null);
        Assert.That(DrawnInspector.Of(m_Gui).HelpBoxes.Single(), Does.StartWith("Pick a picture"));
        Object.DestroyImmediate(plain);
        Object.DestroyImmediate(closed);
    }

    [Test]
    public void AWindowThatCloses_LeavesNothing()
    {
        int before = Count();
        Take(m_Drawn);
        DrawnInspector.Press(m_Gui, "Trace");
        Assert.That(Count(), Is.GreaterThan(before));
        Object.DestroyImmediate(m_Window);
        OpenWindows.All.Clear();
        Assert.That(Count(), Is.EqualTo(before));
    }

    private static int Count() =>
        Resources.FindObjectsOfTypeAll<Texture2D>().Length + Resources.FindObjectsOfTypeAll<WingSkeleton>().Length;

    private Texture2D Import()
    {
        File.WriteAllBytes(FileUtil.GetPhysicalPath(k_Picture), m_Drawn.EncodeToPNG());
        AssetDatabase.ImportAsset(k_Picture);
        return AssetDatabase.LoadAssetAtPath<Texture2D>(k_Picture);
    }

    private void Take(Texture2D picture) => Put("Image", picture);

    private void Put(string label, object value) => DrawnInspector.Put(m_Gui, label, value);

    private Rect Frame() => DrawnInspector.Of(m_Gui).Controls.Single(control => control.Kind == ControlKind.Area).Place;

    private List<(Color Colour, Vector3[] Points)> Lines()
    {
        DrawnLines.Calls = [];
        DrawnInspector.Of(m_Gui);
        List<(Color Colour, Vector3[] Points)> all = DrawnLines.Calls;
        DrawnLines.Calls = null;

        // Layout and repaint draw the same.
        Assert.That(all.Count % 2, Is.Zero);
        return all.GetRange(0, all.Count / 2);
    }
}
