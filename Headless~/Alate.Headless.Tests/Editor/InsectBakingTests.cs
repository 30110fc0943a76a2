using System.Globalization;
using System.Linq;
using System.Text.RegularExpressions;
using Alate.Catalogue;
using Alate.Crowds;
using Alate.Editor;
using NUnit.Framework;
using Unity.StandIns;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Alate.Tests.Editor;

/// <summary>Baking an insect in the editor, and its asset.</summary>
public sealed class InsectBakingTests
{
    private readonly InsectBaking m_Baking = new();
    private InsectWings m_Insect;

    [SetUp]
    public void MakeAnInsect()
    {
        ProjectShaders.Add(WingMaterial.ShaderName, "Alate/Wing");
        m_Insect = InsectFactory.Create("monarch");
    }

    [TearDown]
    public void TakeAllAway()
    {
        m_Baking.Dispose();
        Object.DestroyImmediate(m_Insect.gameObject);
        AssetDatabase.DeleteAsset("Assets/Monarch Baked.asset");
        AssetDatabase.DeleteAsset("Assets/Monarch Baked 1.asset");
        ProjectShaders.Clear();
    }

    [Test]
    public void Baked_SizeAndErrorsAreSaid_BeforeAnythingIsSaved()
    {
        m_Baking.Bake(m_Insect, ["cruise", "rest"], 24);
        string[] lines = m_Baking.Describe().ToArray();

        Assert.That(m_Baking.Problem, Is.Null);
        Assert.That(lines, Has.Length.EqualTo(1 + 2 + m_Baking.Made.Sizes.Count));
        Assert.That(lines[0], Does.Match(@"^Texture: \d+ x \d+ pixels, \d+ kB$"));
        Assert.That(lines[1], Does.StartWith("cruise: 24 frames at 10.0"));
        double[] told = [.. Regex.Matches(lines[1].Split("Hz; ")[1], @"\d+\.\d+")
            .Select(number => double.Parse(number.Value, CultureInfo.InvariantCulture))];
        Assert.That(told[0], Is.InRange(0.05, 5), "per cent of the wing length");
        Assert.That(told[1], Is.InRange(0.1, 20), "degrees");
        Assert.That(lines[3], Does.Match(@"^Mesh of 2000 triangles: 0\.\d\d % of the wing length$"));
    }

    [Test]
    public void WhatIsTold_IsInKilobytesAndPerCent_OfWhatTheBakerGives()
    {
        m_Baking.Bake(m_Insect, ["cruise"], 12);
        InsectBake bake = InsectBaker.Bake(m_Insect, [BakeMotion.Find("cruise")], new BakeSettings(12));
        double[][] told = [.. m_Baking.Describe().Select(line => Regex.Matches(line, @"\d+(\.\d+)?")
            .Select(number => double.Parse(number.Value, CultureInfo.InvariantCulture)).ToArray())];

        Assert.That(told[0], Is.EqualTo(new[]
        {
            m_Baking.Made.Texture.width, m_Baking.Made.Texture.height, m_Baking.Made.TextureBytes / 1024.0,
        }).Within(0.51));
        BakedClip clip = bake.Clips.Single();
        Assert.That(told[1],
            Is.EqualTo(new[] { 12.0, clip.Frequency, 100.0 * clip.Error.between, clip.Error.normalBetween }).Within(0.051));
        Assert.That(told[1][2], Is.EqualTo(100.0 * clip.Error.between).Within(0.0051));
        for (int k = 0; k < m_Baking.Made.Sizes.Count; k++)
        {
            CrowdSize size = m_Baking.Made.Sizes[k];
            Assert.That(told[2 + k], Is.EqualTo(new[] { size.triangles, 100.0 * size.error }).Within(0.0051));
        }
    }

    [Test]
    public void WhatIsDropped_LeavesNothing_AndCanBeDroppedAgain()
    {
        int before = Resources.FindObjectsOfTypeAll<Object>().Length;
        m_Baking.Bake(m_Insect, ["rest"], 4);
        m_Baking.Dispose();

        Assert.That((m_Baking.Made, m_Baking.Preview, m_Baking.Problem, m_Baking.Clips.Length),
            Is.EqualTo((default(BakedInsect), default(LoopPreview), default(string), 0)));
        Assert.That(ReferenceEquals(m_Baking.Made, null), Is.True, "not even a destroyed one");
        Assert.That(m_Baking.Describe(), Is.Empty);
        Assert.That(Resources.FindObjectsOfTypeAll<Object>(), Has.Length.EqualTo(before), "assets are destroyed with their parts");
        Assert.That(m_Baking.Dispose, Throws.Nothing);
        m_Baking.Bake(m_Insect, [], 24);
        Assert.That(m_Baking.Problem, Is.Not.Null);
        m_Baking.Dispose();
        Assert.That(m_Baking.Problem, Is.Null);
    }

    [Test]
    public void ABakeThatIsStopped_MakesNothing_AndIsNoProblem()
    {
        m_Baking.Bake(m_Insect, ["rest"], 4);
        m_Baking.Bake(m_Insect, ["cruise"], 8, (_, _) => false);
        Assert.That((m_Baking.Made == null, m_Baking.Preview == null, m_Baking.Problem), Is.EqualTo((true, true, default(string))));
        Assert.That(m_Baking.Save("Assets/Monarch Baked.asset"), Is.Null);
        Assert.That(m_Baking.Problem, Is.Null);
    }

    [Test]
    public void Saved_NothingElseOfTheProjectIsWritten_AndTheFileIsBinary()
    {
        WingPreset other = ScriptableObject.CreateInstance<WingPreset>();
        try
        {
            EditorUtility.SetDirty(other);
            m_Baking.Bake(m_Insect, ["rest"], 4);
            BakedInsect saved = m_Baking.Save("Assets/Monarch Baked.asset");

            Assert.That((EditorUtility.IsDirty(other), EditorUtility.IsDirty(saved)), Is.EqualTo((true, false)));
            Assert.That(typeof(BakedInsect).IsDefined(typeof(PreferBinarySerialization), false), Is.True);
        }
        finally
        {
            Object.DestroyImmediate(other);
        }
    }

    [Test]
    public void Saved_OneAssetHoldsAllParts_AndNoneIsWrittenOver()
    {
        const string k_Path = "Assets/Monarch Baked.asset";
        m_Baking.Bake(m_Insect, ["rest"], 4);
        BakedInsect first = m_Baking.Save(k_Path);
        m_Baking.Bake(m_Insect, ["rest"], 4);
        BakedInsect second = m_Baking.Save(k_Path);

        Assert.That(AssetDatabase.LoadAssetAtPath<BakedInsect>(k_Path), Is.SameAs(first));
        Assert.That(AssetDatabase.GetAssetPath(second), Is.EqualTo("Assets/Monarch Baked 1.asset"));
        Assert.That(AssetDatabase.GetAssetPath(first.Texture), Is.EqualTo(k_Path));
        Assert.That(first.Sizes.Select(size => AssetDatabase.GetAssetPath(size.mesh)), Is.All.EqualTo(k_Path));
        Assert.That(first.Materials.Select(AssetDatabase.GetAssetPath), Is.All.EqualTo(k_Path));
        Assert.That(m_Baking.Made, Is.Null);
    }

    [Test]
    public void ThePreview_MovesWithinItsArea_AndEndsWhenTheAssetIsSaved()
    {
        var area = new Rect(10f, 20f, 300f, 180f);
        m_Baking.Bake(m_Insect, ["cruise"], 8);
        Vector3[][] Shown(float phase) => [.. m_Baking.Preview.Lines(area, 0, phase).Select(line => line.points)];
        Vector3[] top = [.. Shown(0f).SelectMany(line => line)], bottom = [.. Shown(0.5f).SelectMany(line => line)];

        Assert.That(m_Baking.Clips, Is.EqualTo(new[] { "cruise" }));
        Assert.That(top.Concat(bottom).All(point => area.Contains(point)), Is.True);
        Assert.That(top.Zip(bottom, (a, b) => (a - b).magnitude).Max(), Is.GreaterThan(20f), "pixels");
        Assert.That(Shown(1f)[0], Is.EqualTo(Shown(0f)[0]));
        m_Baking.Save("Assets/Monarch Baked.asset");
        Assert.That(m_Baking.Preview, Is.Null);
    }

    [Test]
    public void ThePrefab_HoldsACrowdOfTheAssetWithASpawner()
    {
        m_Baking.Bake(m_Insect, ["rest"], 4);
        BakedInsect saved = m_Baking.Save("Assets/Monarch Baked.asset");
        GameObject prefab = m_Baking.SavePrefab(saved, m_Insect);

        Assert.That(AssetDatabase.GetAssetPath(prefab), Is.EqualTo("Assets/Monarch Baked Crowd.prefab"));
        Assert.That(prefab.GetComponent<InsectCrowd>().Insect, Is.SameAs(saved));
        Assert.That(prefab.GetComponent<InsectCrowd>().LivePrefab, Is.Null, "an object of the scene cannot be in a prefab");
        Assert.That(prefab.TryGetComponent(out CrowdSpawner _), Is.True);
        AssetDatabase.DeleteAsset("Assets/Monarch Baked Crowd.prefab");
    }

    [Test]
    public void WhatKeepsItFromBeingBaked_IsOneLine()
    {
        m_Baking.Bake(m_Insect, [], 24);

        Assert.That(m_Baking.Problem, Does.StartWith("No clip is asked for."));
        Assert.That(m_Baking.Made, Is.Null);
    }

    [Test]
    public void APathOutsideOfAssets_IsRefused()
    {
        m_Baking.Bake(m_Insect, ["rest"], 4);

        Assert.That(m_Baking.Save("Packages/x.asset"), Is.Null);
        Assert.That(m_Baking.Problem, Does.Contain("is not in the project's Assets folder"));
    }
}
