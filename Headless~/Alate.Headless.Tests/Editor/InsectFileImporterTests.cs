using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using System.Text.RegularExpressions;
using Alate.Editor;
using Alate.Flight;
using Alate.Tests.Cli;
using NUnit.Framework;
using StandIns;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Alate.Tests.Editor;

/// <summary>Insect files in a project, and the menu item that saves one from elsewhere.</summary>
public sealed class InsectFileImporterTests
{
    private const string k_Path = "Assets/Moths/moth.insect.json", k_Menu = "Assets/Import Insect File…",
        k_Own = "\"wings\": { \"wing\": { \"mesh\": \"wing.obj\", \"skeleton\": \"wing.json\" } }";

    [TearDown]
    public void TakeAllAway()
    {
        AnsweredDialogs.Clear();
        Selection.activeObject = null;
        AssetDatabase.DeleteAsset("Assets/Moth");
        Undo.ClearAll();
    }

    [Test]
    public void AnInsect_IsAPrefabWhoseWingsBeat_WithAllItsPartsInTheAsset()
    {
        int before = Resources.FindObjectsOfTypeAll<InsectWings>().Length;
        using ImportedAsset asset = Import(Moth("firefly", "\"massMilligrams\": 33"));
        var main = (GameObject)asset.Main;
        InsectWings insect = main.GetComponent<InsectWings>();

        Assert.That(asset.Errors, Is.Empty);
        Assert.That((main.name, main.activeSelf), Is.EqualTo(("Moth", true)));
        Assert.That(insect.Preset.Size.insectMass, Is.EqualTo(33e-6f));
        Assert.That(InsectStatus.Of(insect).Problem.IsProblem, Is.False, InsectStatus.Of(insect).Problem.Message);
        foreach (Object part in PartsOf(main))
            Assert.That(asset.Objects.Values, Has.Member(part), part.name);
        Assert.That(asset.Objects.Keys, Is.EquivalentTo(new[]
        {
            "insect", "body mesh", "body material", "body material picture", "flight trims",
            "hind wing mesh", "hind wing skeleton", "hind wing material", "hind wing material picture",
            "hind wing preset standard", "hind wing preset biological", "hind wing preset expressive", "hind wing preset flight",
        }));
        Assert.That(asset.Dependencies, Is.Empty);
        Assert.That(asset.Objects.Values.All(AssetLock.IsLocked), "what is edited would be lost");
        Assert.That(main.GetComponent<InsectFlight>() == null, Is.True);
        Assert.That(Resources.FindObjectsOfTypeAll<InsectWings>(), Has.Length.EqualTo(before + 1), "none that no asset holds");
    }

    [Test]
    public void AnInsectThatFlies_HasItsTrimsAndAPilot()
    {
        using ImportedAsset asset = Import(Moth("firefly", "\"massMilligrams\": 33"), new InsectFileImporter { Flies = true });
        var main = (GameObject)asset.Main;

        Assert.That(main.GetComponent<InsectFlight>().Trims, Is.SameAs(asset.Objects["flight trims"]));
        Assert.That(main.GetComponent<WanderPilot>() != null, Is.True);
        Assert.That(main.GetComponent<InsectWings>().Preset, Is.SameAs(asset.Objects["hind wing preset flight"]));
    }

    [Test]
    public void FilesThatItNames_ImportItAgain_WhetherTheyAreThereOrNot()
    {
        const string k_Wing = "\"wings\": { \"fore wing\": { \"mesh\": \"../Wings/wing.obj\", \"skeleton\": \"late.json\" } }";
        ImportedAsset.Write("Assets/Wings/wing.obj", Encoding.UTF8.GetBytes(OwnWing.Obj()));
        using (ImportedAsset asset = Import(Moth("firefly", k_Wing)))
        {
            Assert.That(asset.Main == null, Is.True);
            Assert.That(asset.Errors.Single(), Does.Contain("late.json").And.EndsWith("there is no such file."));
            Assert.That(asset.Dependencies, Is.EqualTo(new[] { "Assets/Wings/wing.obj", "Assets/Moths/late.json" }));
        }

        ImportedAsset.Write("Assets/Moths/late.json", Encoding.UTF8.GetBytes(OwnWing.Skeleton()));
        using (ImportedAsset asset = Import(Moth("firefly", k_Wing)))
        {
            Assert.That(asset.Errors, Is.Empty);
            Assert.That(((Mesh)asset.Objects["fore wing mesh"]).triangles, Has.Length.EqualTo(TestWings.Ellipse().triangles.Length));
            Assert.That(asset.Dependencies, Is.EqualTo(new[] { "Assets/Wings/wing.obj", "Assets/Moths/late.json" }));
        }
    }

    [Test]
    public void ThePictureOfAMaterial_IsFoundInTheProject_AndAMeshElsewhereIsNoDependency()
    {
        string far = Path.GetTempFileName();
        File.WriteAllText(far, OwnWing.Obj());
        Write("Assets/Moths/wing.json", OwnWing.Skeleton());
        using (ImportedAsset asset = Import(Moth("firefly", $"\"wings\": {{ \"wing\": {{ \"mesh\": {JsonText.Line(FileValue.Of(far))}, "
            + "\"skeleton\": \"wing.json\" } }")))
        {
            Assert.That(asset.Errors, Is.Empty);
            Assert.That(asset.Dependencies, Is.EqualTo(new[] { "Assets/Moths/wing.json" }));
        }

        File.Delete(far);
        string mapped = Regex.Replace(OwnWing.Obj(), @"^f (\d+) (\d+) (\d+)", "f $1/1 $2/1 $3/1", RegexOptions.Multiline);
        Write("Assets/Moths/wing.obj", "mtllib wing.mtl\nvt 0 0\n" + mapped);
        Write("Assets/Moths/wing.mtl", ObjMaterial.Write("wing", "paint.png"));
        string[] all = ["Assets/Moths/wing.obj", "Assets/Moths/wing.json", "Assets/Moths/wing.mtl", "Assets/Moths/paint.png"];
        using (ImportedAsset waits = Import(Moth("firefly", k_Own)))
        {
            Assert.That(waits.Errors, Is.Empty);
            Assert.That(waits.Dependencies, Is.EqualTo(all));
            Assert.That(waits.Objects.Keys, Has.No.Member("wing material picture"));
        }

        var paint = new Texture2D(2, 1);
        Color32[] pixels = [new(200, 100, 50, 255), new(10, 20, 30, 128)];
        paint.SetPixels32(pixels);
        byte[] png = paint.EncodeToPNG();
        Object.DestroyImmediate(paint);
        ImportedAsset.Write("Assets/Moths/paint.png", png);
        using (ImportedAsset painted = Import(Moth("firefly", k_Own)))
        {
            Assert.That(painted.Errors, Is.Empty);
            Assert.That(painted.Dependencies, Is.EqualTo(all));
            Assert.That(((Texture2D)painted.Objects["wing material picture"]).GetPixels32(), Is.EqualTo(pixels));
        }

        ImportedAsset.Write("Assets/Moths/paint.png", png[..20]);
        using ImportedAsset damaged = Import(Moth("firefly", k_Own));
        Assert.That(damaged.Errors, Is.EqualTo(new[] { "The picture of the wing is damaged, or neither a PNG nor a JPEG." }));
    }

    [TestCase("{ \"version\": 1,\n \"name\": \"moth\" }", "Assets/Moths/moth.insect.json: line 1: 'like' is missing.")]
    [TestCase("{ \"version\": 1,\n \"name\": \"moth\", \"like\": \"monarch\",\n \"mass\": 3 }",
        "Assets/Moths/moth.insect.json: line 3, mass: unknown key; is it massMilligrams?.")]
    [TestCase("{ \"version\": 1,", "Assets/Moths/moth.insect.json: line 1: not JSON at column 16.")]
    public void AWrongFile_IsAnErrorOfTheImport_WithLineAndKey(string text, string told)
    {
        using ImportedAsset asset = Import(text);

        Assert.That(asset.Errors, Is.EqualTo(new[] { told.Replace("?.", "?") }));
        Assert.That(asset.Objects, Is.Empty);
    }

    [Test]
    public void AFileFromElsewhere_IsSavedAsAPrefabThatCanBeChanged()
    {
        string file = Path.GetTempFileName();
        File.WriteAllText(file, Moth("firefly", "\"massMilligrams\": 33"));
        AnsweredDialogs.Answers.Enqueue(file);
        EditorMenu.Choose(k_Menu);
        File.WriteAllText(file, "{}");
        AnsweredDialogs.Answers.Enqueue(file);
        AnsweredDialogs.Answers.Enqueue("");
        EditorMenu.Choose(k_Menu);
        EditorMenu.Choose(k_Menu);
        File.Delete(file);

        Assert.That(AssetDatabase.GetAssetPath(Selection.activeObject), Is.EqualTo("Assets/Moth/Moth.prefab"));
        WingPreset preset = ((GameObject)Selection.activeObject).GetComponent<InsectWings>().Preset;
        Assert.That(preset.Size.insectMass, Is.EqualTo(33e-6f));
        Assert.That(AssetLock.IsLocked(preset), Is.False);
        Assert.That(AnsweredDialogs.Texts, Is.EqualTo(new[]
        {
            "Import Insect File: /*.json", "Import Insect File: /*.json",
            $"Import Insect File: {file}: line 1: 'version' is missing. [OK]", "Import Insect File: /*.json",
        }));
    }

    private static void Write(string path, string text) => ImportedAsset.Write(path, Encoding.UTF8.GetBytes(text));

    private static string Moth(string like, string more) =>
        $"{{ \"version\": 1, \"name\": \"moth\", \"like\": \"{like}\",\n {more} }}";

    private static ImportedAsset Import(string text, InsectFileImporter importer = null)
    {
        ImportedAsset.Write(k_Path, Encoding.UTF8.GetBytes(text));
        return ImportedAsset.Of(importer ?? new InsectFileImporter(), k_Path);
    }

    private static IEnumerable<Object> PartsOf(GameObject insect)
    {
        foreach (MeshRenderer renderer in insect.GetComponentsInChildren<MeshRenderer>())
        {
            yield return renderer.GetComponent<MeshFilter>().sharedMesh;
            yield return renderer.sharedMaterial;
        }

        foreach (Wing wing in insect.GetComponent<InsectWings>().Wings)
        {
            yield return wing.Skeleton;
            if (wing.Preset != null)
                yield return wing.Preset;
        }
    }
}
