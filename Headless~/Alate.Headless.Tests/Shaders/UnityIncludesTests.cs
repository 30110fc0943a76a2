using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using System.Threading;
using System.Threading.Tasks;
using Alate.Cli;
using Alate.Tests.Cli;
using NUnit.Framework;

namespace Alate.Tests.Shaders;

/// <summary>
/// Every pass of Alate/Wing for URP, compiled on URP's own includes with every two of its keywords. Skipped where the variable
/// ALATE_UNITY_SHADERS names no folder with trees <c>urp-VERSION/Packages/com.unity.render-pipelines.core</c> and <c>.universal</c>.
/// </summary>
public sealed class UnityIncludesTests
{
    private static readonly string[] s_Macros = ["SHADER_API_D3D11=1", "SHADER_TARGET=45", "UNITY_VERSION=202230"];

    private static readonly Regex s_Define = new(@"^[ \t]*#[ \t]*define[ \t]+(\w+)", RegexOptions.Multiline);

    private static string ShaderFolder => Path.Combine(PackageRoot.Find(), "Runtime", "Catalogue", "Materials", "Resources", "Alate");

    [Test]
    [Explicit]
    [Category("Long")]
    public void EveryPassCompiles_OnUrpsOwnIncludes_WithEveryTwoKeywords()
    {
        string sources = Environment.GetEnvironmentVariable("ALATE_UNITY_SHADERS") ?? "";
        string[] versions = Directory.Exists(sources) ? Directory.GetDirectories(sources, "urp-*") : [];
        if (versions.Length == 0 || Glslang.Path == null)
            Assert.Ignore("ALATE_UNITY_SHADERS names no folder of URP's includes, or glslang is not installed.");
        foreach (string includes in versions)
            Compile(Version.Parse(Path.GetFileName(includes)["urp-".Length..]), includes);
    }

    [Test]
    public void FunctionsOfHalves_AreThoseOfFloats_AndOthersStay()
    {
        const string program = "half Less(half a, in half2 b) { if (a > 0) { return a; } return b.x; } "
            + "float Less(float x, float2 y) { return x; }\n"
            + "float Less(float x) { return x; }\nmin16float3x3 Turn(int n) { return 0; }";
        Assert.That(OneFloatType.Of(program), Is.EqualTo(
            "float Less(float a, in float2 b) { if (a > 0) { return a; } return b.x; }\n"
            + "float Less(float x) { return x; }\nfloat3x3 Turn(int n) { return 0; }"));
    }

    private static void Compile(Version version, string includes)
    {
        string file = Path.Combine(ShaderFolder, "Wing.shader");
        ShaderFile.SubShader taken = new ShaderFile(File.ReadAllText(file)).SubShaders.First(sub => sub.Takes(version));
        using var folder = new TemporaryFolder();
        string redefining = CopyTo(folder, includes);
        var wrong = new ConcurrentBag<string>();
        int count = 0;
        Parallel.ForEach(taken.Passes.SelectMany(Variants), variant =>
        {
            int number = Interlocked.Increment(ref count);
            string program = folder.File($"{number}.hlsl", variant.pass.Program), entry = variant.pass.EntryOf(variant.stage);
            IEnumerable<string> macros = s_Macros.Concat(variant.keywords).Append($"SHADER_STAGE_{variant.stage.ToUpperInvariant()}");
            string plain = Glslang.Preprocess(program, variant.stage, [ShaderFolder, redefining], macros);
            plain = Regex.Replace(plain, "(?m)^#line.*$", "");
            string errors = Glslang.Errors(folder.File($"{number} plain.hlsl", OneFloatType.Of(plain)), variant.stage, entry, [], []);
            if (errors != "")
                wrong.Add($"{variant.pass.Name} {variant.stage} with {string.Join(" ", variant.keywords)}: {errors}");
        });

        TestContext.Progress.WriteLine($"URP {version}, its own includes: {count} variants compiled, {wrong.Count} of them do not.");
        Assert.That(wrong.Order().Take(5), Is.Empty, $"{wrong.Count} of {count} variants");
        Assert.That(count, Is.GreaterThan(4 * taken.Passes.Count), "the pragmas were not found");
    }

    // Unity's compilers let a macro be defined again, and its includes do; glslang does not.
    private static string CopyTo(TemporaryFolder folder, string includes)
    {
        string copy = folder.PathOf("urp");
        foreach (string file in Directory.GetFiles(includes, "*.hlsl", SearchOption.AllDirectories))
        {
            string to = Path.Combine(copy, Path.GetRelativePath(includes, file));
            Directory.CreateDirectory(Path.GetDirectoryName(to));
            File.WriteAllText(to, s_Define.Replace(File.ReadAllText(file), "#undef $1\n$0"));
        }

        return copy;
    }

    // Which keywords a pass asks for, the project's own includes tell: those of URP name all that there are.
    private static IEnumerable<(ShaderFile.Pass pass, string stage, string[] keywords)> Variants(ShaderFile.Pass pass)
    {
        string names = Path.Combine(PackageRoot.Find(), "Headless~", "Alate.Headless.Tests", "Shaders", "Includes", "Universal");
        string text = IncludedText.Of(pass.Program, ShaderFolder, [names]);
        return new[] { "vertex", "fragment" }
            .SelectMany(stage => KeywordSets.PairsOf(pass.Program, stage, text).Select(keywords => (pass, stage, keywords)));
    }
}
