using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
using Alate.Crowds;
using NUnit.Framework;
using StandIns;
using Unity.StandIns;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Alate.Tests.Editor;

/// <summary>The window that bakes insects, as it is drawn: from the insect to the asset and its prefab.</summary>
public sealed class BakeWindowTests
{
    private const string k_Menu = "Assets/Create/Alate/Baked Insect...";

    private InsectWings m_Insect;
    private EditorWindow m_Window;
    private Action m_Gui;

    [SetUp]
    public void Open()
    {
        ProjectShaders.Add(WingMaterial.ShaderName, "Alate/Wing");
        m_Insect = InsectFactory.Create("monarch");
        Selection.activeGameObject = m_Insect.gameObject;
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
        AnsweredDialogs.Clear();
        DrawnLines.Calls = null;
        ShownProgress.Begin();
        Selection.activeObject = null;
        AssetDatabase.DeleteAsset("Assets/Fire Crowd.prefab");
        AssetDatabase.DeleteAsset("Assets/Fire.asset");
        ProjectAssets.Clear();
        Object.DestroyImmediate(m_Insect.gameObject);
        ProjectShaders.Clear();
    }

    [Test]
    public void TheSelectedInsect_IsTaken_AndWithoutOneItIsAskedFor()
    {
        var page = DrawnInspector.Of(m_Gui);
        Assert.That((page.Control("Insect").Value, page.Control("Frames").Value), Is.EqualTo((m_Insect.name, "48")));
        Assert.That(page.Controls.Where(control => control.Kind == ControlKind.Toggle).Select(clip => (clip.Text, clip.Value)),
            Is.EqualTo(BakeMotion.Names.Select((name, k) => (name, k == 0 ? "on" : "off"))));

        Selection.activeGameObject = null;
        EditorMenu.Choose(k_Menu);
        page = DrawnInspector.Of(DrawnInspector.Of(OpenWindows.All[1]));
        Assert.That(page.HelpBoxes.Single(), Does.StartWith("Pick an insect"));
        Assert.That(page.Buttons, Is.Empty);
    }

    [Test]
    public void ABake_ShowsItsProgress_AndCanBeCancelled([Values] bool isCancelled)
    {
        ShownProgress.Begin();
        ShownProgress.CancelAfter = isCancelled ? 3 : int.MaxValue;
        DrawnInspector.Press(m_Gui, "rest");
        DrawnInspector.Press(m_Gui, "Bake");

        Assert.That(ShownProgress.IsOpen, Is.False);
        Assert.That(ShownProgress.Shown.Select(shown => shown.Share), Is.Ordered.And.All.InRange(0f, 1f));
        Assert.That(ShownProgress.Shown.Select(shown => shown.Info).Distinct().Count(), Is.EqualTo(isCancelled ? 1 : 2), "a clip each");
        var page = DrawnInspector.Of(m_Gui);
        Assert.That(page.Buttons.Contains("Save..."), Is.EqualTo(!isCancelled));
        Assert.That(page.HelpBoxes.Count(), Is.EqualTo(isCancelled ? 0 : 1));
        if (isCancelled)
            Assert.That(ShownProgress.Shown, Has.Count.EqualTo(4));
    }

    [Test]
    public void ABake_HasTheClipsAndFramesThatWereChosen_MovesInItsPicture_AndIsSavedWithAPrefab()
    {
        string first = BakeMotion.Names[0];
        DrawnInspector.Press(m_Gui, "rest");
        DrawnInspector.Press(m_Gui, first);
        DrawnInspector.Press(m_Gui, "cruise");
        DrawnInspector.Put(m_Gui, "Frames", 12);
        var page = DrawnInspector.Press(m_Gui, "Bake");
        string[] told = page.HelpBoxes.Single().Split('\n');
        Assert.That((told[1].Split(" at")[0], told[2].Split(" at")[0]), Is.EqualTo(("rest: 1 frames", "cruise: 12 frames")), "as chosen");

        // The picture: a rim and chains a wing, within its place; another clip is drawn otherwise.
        List<(Color Colour, Vector3[] Points)> Shown()
        {
            DrawnLines.Calls = [];
            DrawnInspector.Of(m_Gui);
            List<(Color Colour, Vector3[] Points)> all = DrawnLines.Calls;
            DrawnLines.Calls = null;
            return all;
        }

        Rect place = page.Controls.Single(control => control.Kind == ControlKind.Area).Place;
        List<(Color Colour, Vector3[] Points)> shown = Shown();
        Assert.That(place.height, Is.EqualTo(180f));
        Assert.That(shown.SelectMany(line => line.Points), Is.All.Matches<Vector3>(point => place.Contains(point)));
        Assert.That(shown.Select(line => line.Colour).Distinct().Count(), Is.EqualTo(2), "chains and rims");
        Assert.That(shown, Has.Count.EqualTo(m_Insect.Wings.Sum(wing => wing.Skeleton.ChainCount + 1)));
        DrawnInspector.Put(m_Gui, "Shown, slowed down", 1);
        Assert.That(DrawnInspector.Of(m_Gui).Control("Shown, slowed down").Value, Is.EqualTo("cruise"));

        AnsweredDialogs.Answers.Enqueue("");
        DrawnInspector.Press(m_Gui, "Save...");
        Assert.That(AnsweredDialogs.Texts.Single(), Does.StartWith($"Bake Insect: {m_Insect.name} Baked.asset: One asset"));
        AnsweredDialogs.Answers.Enqueue("Packages/x.asset");
        page = DrawnInspector.Press(m_Gui, "Save...");
        Assert.That(page.HelpBoxes, Has.Some.Contains("is not in the project's Assets folder"));
        AnsweredDialogs.Answers.Enqueue("Assets/Fire.asset");
        page = DrawnInspector.Press(m_Gui, "Save...");
        Assert.That(page.Buttons, Is.EqualTo(new[] { "Bake" }), "saved");
        BakedInsect baked = AssetDatabase.LoadAssetAtPath<BakedInsect>("Assets/Fire.asset");
        Assert.That(baked.Loops, Has.Count.EqualTo(2));
        Assert.That(AssetDatabase.GetAssetPath(Selection.activeObject), Is.EqualTo("Assets/Fire Crowd.prefab"));
    }

    [Test]
    public void WithoutAPrefab_TheAssetIsShown_AndAChangedFieldDropsTheBake()
    {
        int before = Resources.FindObjectsOfTypeAll<BakedInsect>().Length;
        DrawnInspector.Put(m_Gui, "Frames", 6);
        DrawnInspector.Press(m_Gui, "Bake");
        Assert.That(Resources.FindObjectsOfTypeAll<BakedInsect>(), Has.Length.EqualTo(before + 1));
        Assert.That(DrawnInspector.Put(m_Gui, "Frames", 4).Buttons, Is.EqualTo(new[] { "Bake" }));
        Assert.That(Resources.FindObjectsOfTypeAll<BakedInsect>(), Has.Length.EqualTo(before));
        DrawnInspector.Press(m_Gui, "Bake");
        DrawnInspector.Press(m_Gui, "Prefab");
        AnsweredDialogs.Answers.Enqueue("Assets/Fire.asset");
        DrawnInspector.Press(m_Gui, "Save...");
        Assert.That(AssetDatabase.GetAssetPath(Selection.activeObject), Is.EqualTo("Assets/Fire.asset"));

        DrawnInspector.Press(m_Gui, "Bake");
        Object.DestroyImmediate(m_Window);
        OpenWindows.All.Clear();
        Assert.That(Resources.FindObjectsOfTypeAll<BakedInsect>(), Has.Length.EqualTo(before + 1), "a closed window keeps nothing");
    }
}
