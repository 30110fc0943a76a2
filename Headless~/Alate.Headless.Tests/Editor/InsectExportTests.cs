using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using Alate.Catalogue;
using Alate.Editor;
using Alate.Flight;
using Alate.Tests.Cli;
using NUnit.Framework;
using StandIns;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Alate.Tests.Editor;

/// <summary>Insects of a scene as insect files.</summary>
public sealed class InsectExportTests
{
    private const string k_Menu = "CONTEXT/InsectWings/Export Insect File…";

    private readonly List<GameObject> m_Made = [];
    private CommandRun m_Run;

    [SetUp]
    public void MakeAFolder() => m_Run = new CommandRun();

    [TearDown]
    public void TakeAllAway()
    {
        AnsweredDialogs.Clear();
        m_Made.ForEach(Object.DestroyImmediate);
        m_Made.Clear();
        m_Run.Dispose();
    }

    [TestCase("monarch", "wing")]
    [TestCase("dragonfly", "fore wing", "hind wing")]
    public void AnInsect_IsReadAsItWas(string species, params string[] names)
    {
        InsectWings insect = Made(species);
        insect.transform.SetPositionAndRotation(new Vector3(3f, -1f, 2f), Quaternion.Euler(10f, 70f, 30f));
        insect.transform.localScale = new Vector3(0.5f, 0.5f, 0.5f);
        foreach (Wing wing in insect.Wings)
            (wing.Preset != null ? wing.Preset : insect.Preset).Size.insectMass = 1.25e-3f;
        string file = Path.Combine(m_Run.Folder, "My Own.insect.json");

        Assert.That(InsectExport.Write(insect, file), Is.Null);
        InsectDefinition read = InsectFile.Read(file), known = InsectCatalogue.Find(species);

        Assert.That((read.Name, read.DisplayName), Is.EqualTo(("my-own", insect.name)));
        Assert.That(read.Wings.Select(wing => wing.Name), Is.EqualTo(names));
        float metresPerUnit = insect.Preset.WingLength / FrameOf(known.Wings[0]).length;
        for (int k = 0; k < names.Length; k++)
        {
            Wing wing = insect.Wings.First(one => one.Pair == (k == 0 ? WingPair.Fore : WingPair.Hind) && one.Side == WingSide.Right);
            WingPreset preset = wing.Preset != null ? wing.Preset : insect.Preset;
            foreach (InsectVariant variant in read.Wings[k].Variants)
                AssertEqual(read.Wings[k].CreatePreset(variant: variant), preset);
            WingFrame frame = FrameOf(known.Wings[k]);
            Vector3 hinge = metresPerUnit * (known.Wings[k].HingeOn(WingSide.Right) + (Vector3)frame.origin);
            Assert.That((read.Wings[k].Hinge - hinge).magnitude, Is.LessThan(1e-7f), "metres");
            SurfaceMesh there = read.Wings[k].CreateSurface(WingSide.Right), here = known.Wings[k].CreateSurface(WingSide.Right);
            float size = frame.length / (InsectDefinition.UnitsPerMetre * preset.WingLength), farthest = 0f;
            Assert.That(there.triangles, Has.Length.EqualTo(here.triangles.Length));
            for (int corner = 0; corner < here.triangles.Length; corner++)
            {
                Vector3 place = size * there.positions[there.triangles[corner]] + (Vector3)frame.origin;
                farthest = Mathf.Max(farthest, (place - here.positions[here.triangles[corner]]).magnitude);
            }

            Assert.That(farthest, Is.LessThan(1e-5f * frame.length));
        }
    }

    [Test]
    public void WhatIsExported_Flies()
    {
        string file = Path.Combine(m_Run.Folder, "own.insect.json");
        Assert.That(InsectExport.Write(Made("monarch"), file), Is.Null);
        double[] lifts = Array.ConvertAll(new[] { file, "monarch" }, insect =>
        {
            Assert.That(m_Run.Run("fly", insect, "--seconds", "0.3", "--no-pictures", "--out", m_Run.Out), Is.Zero, m_Run.Errors);
            using var summary = JsonDocument.Parse(File.ReadAllText(Path.Combine(m_Run.Out, "summary.json")));
            return summary.RootElement.GetProperty("lift_over_weight").GetDouble();
        });

        Assert.That(lifts[0], Is.EqualTo(lifts[1]).Within(0.5).Percent);
    }

    [Test]
    public void PartsOfTheFlight_AreThoseOfTheFile()
    {
        InsectWings insect = Made("firefly");
        InsectFlight flight = insect.gameObject.AddComponent<InsectFlight>();
        flight.Parts.Add(new BodyEllipsoid { centre = new Vector3(0f, 0.001f, 0.002f), halfAxes = 0.003f * Vector3.one, share = 2f });
        string file = Path.Combine(m_Run.Folder, "own.insect.json");

        Assert.That(InsectExport.Write(insect, file), Is.Null);
        Assert.That(InsectFile.Read(file).FlightParts, Is.EqualTo(flight.Parts));
    }

    [Test]
    public void ThePictureOfTheMaterial_IsThatOfTheFile()
    {
        InsectWings insect = Made("firefly");
        var paint = new Texture2D(2, 1);
        Color32[] pixels = [new(200, 100, 50, 255), new(10, 20, 30, 128)];
        paint.SetPixels32(pixels);
        insect.Wings[0].Renderer.sharedMaterial.SetSurfaceTexture(paint);
        string file = Path.Combine(m_Run.Folder, "own.insect.json");

        Assert.That(InsectExport.Write(insect, file), Is.Null);
        Material read = WingMaterial.ForWing(InsectFile.Read(file).Wings[0], 64, true);
        Assert.That(((Texture2D)read.SurfaceTexture()).GetPixels32(), Is.EqualTo(pixels));
        WingMaterial.Destroy(read);
        Object.DestroyImmediate(paint);
    }

    [Test]
    public void WhatCannotBeWritten_IsSaid()
    {
        InsectWings insect = Made("firefly");
        string file = Path.Combine(m_Run.Folder, "own.insect.json");
        WingSkeleton skeleton = insect.Wings[0].Skeleton;
        insect.Wings[0].Skeleton = null;
        Assert.That(InsectExport.Write(insect, file), Is.EqualTo("The wing of 'Firefly' has no valid skeleton."));
        insect.Wings[0].Skeleton = skeleton;
        insect.Wings[0].Part = WingPart.Submesh;
        Assert.That(InsectExport.Write(insect, file), Is.EqualTo("The wing of 'Firefly' is a part of a mesh: give it a mesh of its own."));
        insect.Wings.Clear();
        Assert.That(InsectExport.Write(insect, file), Is.EqualTo("'Firefly' has no wings."));
        Assert.That(Directory.GetFiles(m_Run.Folder), Is.Empty);
        Assert.That(InsectExport.Write(Made("firefly"), Path.Combine(m_Run.Folder, "no", "own.insect.json")), Does.Contain("no"));
    }

    [TestCase("own.json")]
    [TestCase("own.insect.json")]
    public void TheMenu_WritesAFileThatEndsAsInsectFilesDo(string chosen)
    {
        InsectWings insect = Made("firefly");
        AnsweredDialogs.Answers.Enqueue(Path.Combine(m_Run.Folder, chosen));
        AnsweredDialogs.Answers.Enqueue("");
        EditorMenu.Choose(k_Menu, insect);
        EditorMenu.Choose(k_Menu, insect);
        insect.Wings.Clear();
        AnsweredDialogs.Answers.Enqueue(Path.Combine(m_Run.Folder, chosen));
        EditorMenu.Choose(k_Menu, insect);

        Assert.That(Directory.GetFiles(m_Run.Folder).Select(Path.GetFileName),
            Is.EquivalentTo(new[] { "own.insect.json", "own-wing.obj", "own-wing.json" }));
        Assert.That(AnsweredDialogs.Texts.Last(), Is.EqualTo("Export Insect File: 'Firefly' has no wings. [OK]"));
    }

    private static WingFrame FrameOf(WingDefinition wing) =>
        WingFiles.FrameOf(wing.CreateSkeleton(WingSide.Right), wing.CreateSurface(WingSide.Right), wing.Name);

    private InsectWings Made(string species)
    {
        InsectWings insect = InsectFactory.Create(species);
        m_Made.Add(insect.gameObject);
        return insect;
    }

    private static void AssertEqual(WingPreset read, WingPreset written)
    {
        foreach (PresetKey key in InsectKeys.OfInsect.Concat(InsectKeys.OfWing).Concat(InsectKeys.Groups.SelectMany(group => group.Keys)))
            Assert.That(key.Of(read), Is.EqualTo(key.Of(written)), key.Name);
        Object.DestroyImmediate(read);
    }
}
