using System;
using System.Collections.Generic;
using System.Linq;

namespace Alate.Tests.Shaders;

/// <summary>
/// HLSL front end of glslang (Debian: glslang-tools), which checks names, types and semantics as far as a shader's text goes.
/// </summary>
internal static class Glslang
{
    /// <summary>Path of the program; null where it is not installed.</summary>
    public static string Path { get; } = InstalledProgram.Find("glslangValidator", "glslang");

    /// <summary>Compiles one stage of one variant.</summary>
    /// <returns>What is wrong with it; empty where nothing is.</returns>
    public static string Errors(string file, string stage, string entry, IEnumerable<string> includes, IEnumerable<string> macros)
    {
        string[] arguments = ["-D", "-V", "-S", Stage(stage), "-e", entry, "-o", file + "." + Guid.NewGuid().ToString("N") + ".spv"];
        (int code, string output) = Run(arguments, includes, macros, file);
        return code == 0 ? "" : string.Join(
            "\n", output.Split('\n').Where(line => line.StartsWith("ERROR", StringComparison.Ordinal)).DefaultIfEmpty(output));
    }

    /// <summary>Text of one stage after its directives.</summary>
    public static string Preprocess(string file, string stage, IEnumerable<string> includes, IEnumerable<string> macros) =>
        Run(["-D", "-E", "-S", Stage(stage)], includes, macros, file).output;

    private static string Stage(string stage) => stage == "vertex" ? "vert" : "frag";

    /// <summary>Compiles one stage of one variant to SPIR-V, with places for all that goes in and out.</summary>
    /// <exception cref="InvalidOperationException">It does not compile.</exception>
    public static void Compile(
        string file, string stage, string entry, IEnumerable<string> includes, IEnumerable<string> macros, string spirv)
    {
        string[] arguments =
            ["-D", "-V", "--auto-map-bindings", "--auto-map-locations", "-S", Stage(stage), "-e", entry, "-o", spirv];
        (int code, string output) = Run(arguments, includes, macros, file);
        if (code != 0)
            throw new InvalidOperationException(output);
    }

    private static (int code, string output) Run(
        string[] arguments, IEnumerable<string> includes, IEnumerable<string> macros, string file)
    {
        IEnumerable<string> folders = includes.Select(folder => "-I" + folder);
        IEnumerable<string> defined = macros.Select(macro => "-D" + (macro.Contains('=') ? macro : macro + "=1"));
        return InstalledProgram.Run(Path, [.. arguments, .. folders, .. defined, file]);
    }
}
