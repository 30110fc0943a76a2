using System;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Alate.Cli;
using Alate.Tests.Cli;
using NUnit.Framework;

namespace Alate.Tests.Shaders;

/// <summary>
/// Both stages of a pass of Alate/Wing as WebGL 2 takes them, by glslang and SPIRV-Cross (Debian: glslang-tools, spirv-cross), on includes
/// of our own that place and light as Unity's do.
/// </summary>
internal sealed record WebStages(string Vertex, string Fragment)
{
    private static readonly string s_Path = InstalledProgram.Find("spirv-cross");

    private static string Materials => Path.Combine(PackageRoot.Find(), "Runtime", "Catalogue", "Materials");

    private static string Folder => Path.Combine(Materials, "Resources", "Alate");

    /// <summary>Text of the shader.</summary>
    public static string Text => File.ReadAllText(Path.Combine(Folder, "Wing.shader"));

    /// <summary>Skips the test where a program is missing.</summary>
    public static void Need()
    {
        if (Glslang.Path == null)
            Assert.Ignore("glslang is not installed.");
        if (s_Path == null)
            Assert.Ignore("spirv-cross is not installed.");
    }

    /// <summary>Translates the pass that lights a wing by the sun.</summary>
    /// <param name="builtIn">True for the built-in pipeline, else URP 17.1.</param>
    /// <param name="keywords">Those that are on.</param>
    public static WebStages Of(bool builtIn, params string[] keywords) =>
        Of(builtIn, builtIn ? "ForwardBase" : "UniversalForwardOnly", keywords);

    /// <summary>Translates the pass of motion vectors.</summary>
    /// <inheritdoc cref="Of(bool, string[])"/>
    public static WebStages OfMotion(bool builtIn, params string[] keywords) => Of(builtIn, "MotionVectors", keywords);

    private static WebStages Of(bool builtIn, string lightMode, string[] keywords)
    {
        ShaderFile.SubShader taken =
            new ShaderFile(Text).SubShaders.First(sub => builtIn ? sub.Universal == null : sub.Takes(new Version(17, 1, 0)));
        ShaderFile.Pass pass = taken.Passes.Single(pass => pass.LightMode == lightMode);
        string includes = Path.Combine(
            PackageRoot.Find(), "Headless~", "Alate.Headless.Tests", "Shaders", "Includes", builtIn ? "BuiltIn" : "Universal");
        using var folder = new TemporaryFolder();
        string file = folder.File("pass.hlsl", pass.Program);
        string[] macros = [.. keywords, "STANDIN_URP=1701", "DIRECTIONAL"];
        string vertex = Translated("vertex"), fragment = Translated("fragment");

        // What has no name has the number of its stage, which may be that of something else in the other one.
        return new WebStages(Named(vertex, "out"), Regex.Replace(Named(fragment, "in"), @"\b_(\d+)\b", "_of$1"));

        string Translated(string stage)
        {
            string spirv = Path.Combine(folder.Root, stage + ".spv");
            Glslang.Compile(file, stage, pass.EntryOf(stage), [Folder, includes], macros, spirv);
            (int code, string output) =
                InstalledProgram.Run(s_Path, ["--es", "--version", "300", "--glsl-emit-ubo-as-plain-uniforms", spirv]);
            return code == 0 ? output : throw new InvalidOperationException(output);
        }
    }

    // What goes from stage to stage has one name in both; integers are not blended.
    private static string Named(string stage, string direction)
    {
        foreach (Match varied in Regex.Matches(stage, $@"(?m)^(?:flat )?{direction} (?:\w+ )?(\w+) (\w+_(\w+));$"))
        {
            (string type, string name) = (varied.Groups[1].Value, varied.Groups[2].Value);
            string shared = "varied_" + varied.Groups[3].Value;
            string declared = $"{(type == "uint" ? "flat " : "")}{direction} highp {type} {shared};";
            stage = Regex.Replace(stage.Replace(varied.Value, declared), $@"\b{name}\b", shared);
        }

        return stage;
    }
}
