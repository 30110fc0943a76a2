using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using System.Threading.Tasks;
using Alate.Cli;
using Alate.Tests.Cli;
using NUnit.Framework;

namespace Alate.Tests.Shaders;

/// <summary>
/// Every pass of Alate/Wing that ships, compiled by glslang on includes of our own, which have the names and signatures of Unity's: with
/// every two keywords (built-in pipeline: with each of them), and in the long tests with every keyword set. Skipped where glslang is not
/// installed (Debian: glslang-tools).
/// </summary>
public sealed class WingShaderCompileTests
{
    private static readonly string[] s_Stages = ["vertex", "fragment"];

    private static string Root => PackageRoot.Find();

    private static string ShaderFolder => Path.Combine(Root, "Runtime", "Catalogue", "Materials", "Resources", "Alate");

    private static string Includes => Path.Combine(Root, "Headless~", "Alate.Headless.Tests", "Shaders", "Includes");

    private static ShaderFile Shader => new(File.ReadAllText(Path.Combine(ShaderFolder, "Wing.shader")));

    // The versions of URP in Unity 2022.3, 6000.0 and 6000.1.
    [TestCase("17.1.0", 1701)]
    public void InUrp_EveryPassCompiles_WithEachKeyword(string version, int macros) => CompileInUrp(version, macros, KeywordSets.EachOf);

    [TestCase("14.0.11", 1400)]
    [TestCase("17.0.4", 1700)]
    [TestCase("17.1.0", 1701)]
    [Explicit]
    [Category("Long")]
    public void InUrp_EveryPassCompiles_WithEveryTwoKeywords(string version, int macros) =>
        CompileInUrp(version, macros, KeywordSets.PairsOf);

    [TestCase("14.0.11", 1400)]
    [TestCase("17.0.4", 1700)]
    [TestCase("17.1.0", 1701)]
    [Explicit]
    [Category("Long")]
    public void InUrp_EveryPassCompiles_WithEveryKeywordSet(string version, int macros) => CompileInUrp(version, macros, KeywordSets.Of);

    [Test]
    public void InTheBuiltInPipeline_EveryPassCompiles_WithEachKeyword() => CompileInTheBuiltInPipeline(KeywordSets.EachOf);

    [Test]
    [Explicit]
    [Category("Long")]
    public void InTheBuiltInPipeline_EveryPassCompiles_WithEveryKeywordSet() => CompileInTheBuiltInPipeline(KeywordSets.Of);

    [TestCase("BuiltIn/WingInput.cginc", "sampler2D_float _BakeMap;")]
    [TestCase("Universal/WingInput.hlsl", "TEXTURE2D_FLOAT(_BakeMap);")]
    public void BakedPlaces_AreReadWithAllTheirBits_OnPhonesToo(string file, string declared)
    {
        string text = File.ReadAllText(Path.Combine(Root, "Runtime", "Catalogue", "Materials", file));
        Assert.That(text.Split('\n').Where(line => Regex.IsMatch(line, @"^\S+[ (]_BakeMap\b")), Is.EqualTo(new[] { declared }));
    }

    [Test]
    public void EveryTwoKeywords_ThatMayMeet_Do()
    {
        foreach (ShaderFile.SubShader sub in Shader.SubShaders)
        {
            string includes = Path.Combine(Includes, sub.Universal == null ? "BuiltIn" : "Universal");
            foreach (ShaderFile.Pass pass in sub.Passes)
            {
                string text = IncludedText.Of(pass.Program, ShaderFolder, [includes]);
                foreach (string stage in s_Stages)
                {
                    List<string[]> all = [.. KeywordSets.Of(pass.Program, stage, text)];
                    Assert.That(Meeting(KeywordSets.PairsOf(pass.Program, stage, text)), Is.EquivalentTo(Meeting(all)), pass.Name);
                    Assert.That(
                        KeywordSets.EachOf(pass.Program, stage, text).SelectMany(set => set).Distinct(),
                        Is.EquivalentTo(all.SelectMany(set => set).Distinct()), pass.Name);
                }
            }
        }
    }

    [TestCase("14.0.11", "_FORWARD_PLUS", "_CLUSTER_LIGHT_LOOP")]
    [TestCase("17.0.4", "_FORWARD_PLUS", "_CLUSTER_LIGHT_LOOP")]
    [TestCase("17.1.0", "_CLUSTER_LIGHT_LOOP", "_FORWARD_PLUS")]
    public void ClusteredLights_HaveTheKeyword_ThatTheVersionOfUrpKnows(string version, string known, string unknown)
    {
        ShaderFile.SubShader taken = Shader.SubShaders.First(sub => sub.Takes(Version.Parse(version)));

        string forward = taken.Passes.Single(pass => pass.LightMode == "UniversalForwardOnly").Program;
        Assert.That(forward, Does.Contain(known).And.Not.Contain(unknown));
    }

    [Test]
    public void EveryVersionOfUrp_From14On_TakesOneSubShader_WithPassesForShadowsDepthNormalsAndMotion()
    {
        string[] modes = ["UniversalForwardOnly", "ShadowCaster", "DepthOnly", "DepthNormalsOnly", "MotionVectors"];
        foreach (string version in new[] { "14.0.0", "14.0.11", "15.0.7", "16.0.6", "17.0.3", "17.1.0", "17.5.0", "18.0.0" })
        {
            ShaderFile.SubShader[] fitting = [.. Shader.SubShaders.Where(sub => sub.Takes(Version.Parse(version)))];
            Assert.That(fitting, Has.Length.EqualTo(1), version);
            Assert.That(fitting[0].Passes.Select(pass => pass.LightMode), Is.EqualTo(modes), version);
        }

        Assert.That(Shader.SubShaders.Any(sub => sub.Takes(Version.Parse("12.1.7"))), Is.False);
    }

    [Test]
    public void EveryPipeline_DrawsMotionVectors_AndUrpOfThoseThatStandStill()
    {
        foreach (ShaderFile.SubShader sub in Shader.SubShaders)
        {
            Assert.That(sub.Passes.Count(pass => pass.LightMode == "MotionVectors"), Is.EqualTo(1), sub.Universal);
            Assert.That(sub.Tags.Contains("\"AlwaysRenderMotionVectors\" = \"true\""), Is.EqualTo(sub.Universal != null));
        }
    }

    [Test]
    public void LightsOfOtherRenderingLayers_GiveNoLight_InEveryVersionOfUrp()
    {
        ShaderFile.Pass[] forward =
            [.. Shader.SubShaders.SelectMany(sub => sub.Passes).Where(pass => pass.LightMode == "UniversalForwardOnly")];
        Assert.That(forward, Has.Length.EqualTo(2));
        foreach (ShaderFile.Pass pass in forward)
        {
            string text = IncludedText.Of(pass.Program, ShaderFolder, [Path.Combine(Includes, "Universal")]);
            Assert.That(KeywordSets.EachOf(pass.Program, "fragment", text).SelectMany(set => set), Does.Contain("_LIGHT_LAYERS"));
        }
    }

    [Test]
    public void InstancedInsects_HaveAmbientLightOfTheirOwn_InEveryPassThatReadsIt()
    {
        int passes = 0;
        foreach (ShaderFile.SubShader sub in Shader.SubShaders)
        {
            string includes = Path.Combine(Includes, sub.Universal == null ? "BuiltIn" : "Universal");
            foreach (ShaderFile.Pass pass in sub.Passes)
            {
                string text = IncludedText.Of(pass.Program, ShaderFolder, [includes]);
                Match fragment = Regex.Match(text, @"half4 Fragment\(Varyings (\w)\).*?return", RegexOptions.Singleline);
                if (!Regex.IsMatch(fragment.Value, "SampleSH|ShadeSH9"))
                    continue;
                Assert.That(fragment.Value, Does.Contain($"UNITY_SETUP_INSTANCE_ID({fragment.Groups[1].Value})"), pass.Name);
                passes++;
            }
        }

        Assert.That(passes, Is.EqualTo(3));
    }

    private static void CompileInUrp(string version, int macros, Sets sets)
    {
        ShaderFile.SubShader taken = Shader.SubShaders.First(sub => sub.Takes(Version.Parse(version)));

        Compile("URP " + version, taken, sets, Path.Combine(Includes, "Universal"), $"STANDIN_URP={macros}");
    }

    private static void CompileInTheBuiltInPipeline(Sets sets) =>
        Compile("Built-in pipeline", Shader.SubShaders.Single(sub => sub.Universal == null), sets, Path.Combine(Includes, "BuiltIn"));

    private static HashSet<(string, string)> Meeting(IEnumerable<string[]> sets) =>
        [.. sets.SelectMany(set => set.SelectMany(one => set.Select(other => (one, other))))];

    private static void Compile(string pipeline, ShaderFile.SubShader taken, Sets sets, string includes, params string[] macros)
    {
        if (Glslang.Path == null)
        {
            TestContext.Progress.WriteLine($"{pipeline}: the shader was not compiled, glslang is not installed (Debian: glslang-tools).");
            Assert.Ignore("glslang is not installed.");
        }

        using var folder = new TemporaryFolder();
        var wrong = new ConcurrentBag<string>();
        List<Variant> variants = [.. taken.Passes.SelectMany(pass => Variants(pass, sets, includes, folder))];
        int count = variants.Count;
        Parallel.ForEach(variants, variant =>
        {
            string errors = Glslang.Errors(
                variant.File, variant.Stage, variant.Entry, [ShaderFolder, includes], variant.Keywords.Concat(macros));
            if (errors != "")
            {
                wrong.Add($"{variant.Name} "
                    + $"{variant.Stage} with {string.Join(" ", variant.Keywords.Where(word => !word.EndsWith("_DECLARED")))}: {errors}");
            }
        });

        TestContext.Progress.WriteLine(
            $"{pipeline}: {count} variants of {taken.Passes.Count} passes compiled, {wrong.Count} of them do not.");
        Assert.That(wrong.Order().Take(5), Is.Empty, $"{wrong.Count} of {count} variants");
        Assert.That(
            variants.SelectMany(variant => variant.Keywords).Distinct().Count(word => !word.EndsWith("_DECLARED")),
            Is.GreaterThan(6), "the pragmas were not found");
    }

    private static IEnumerable<Variant> Variants(ShaderFile.Pass pass, Sets sets, string includes, TemporaryFolder folder)
    {
        string file = folder.File(pass.Name + ".hlsl", pass.Program);
        string text = IncludedText.Of(pass.Program, ShaderFolder, [includes]);
        return s_Stages.SelectMany(stage => sets(pass.Program, stage, text)
            .Select(keywords => new Variant(pass.Name, file, stage, pass.EntryOf(stage), keywords)));
    }

    private delegate IEnumerable<string[]> Sets(string program, string stage, string mentioned);

    private sealed record Variant(string Name, string File, string Stage, string Entry, string[] Keywords);
}
