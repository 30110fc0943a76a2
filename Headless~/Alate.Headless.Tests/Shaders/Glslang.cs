using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;

namespace Alate.Tests.Shaders;

/// <summary>
/// HLSL front end of glslang (Debian: glslang-tools), which checks names, types and semantics as far as a shader's text goes.
/// </summary>
internal static class Glslang
{
    /// <summary>Path of the program; null where it is not installed.</summary>
    public static string Path { get; } = Find();

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

    private static (int code, string output) Run(
        string[] arguments, IEnumerable<string> includes, IEnumerable<string> macros, string file)
    {
        var start = new ProcessStartInfo(Path) { RedirectStandardOutput = true, RedirectStandardError = true };
        IEnumerable<string> folders = includes.Select(folder => "-I" + folder);
        IEnumerable<string> defined = macros.Select(macro => "-D" + (macro.Contains('=') ? macro : macro + "=1"));
        foreach (string argument in arguments.Concat(folders).Concat(defined).Append(file))
            start.ArgumentList.Add(argument);
        using var run = Process.Start(start);
        string output = run.StandardOutput.ReadToEnd() + run.StandardError.ReadToEnd();
        run.WaitForExit();
        return (run.ExitCode, output);
    }

    private static string Find()
    {
        string[] names = OperatingSystem.IsWindows() ? ["glslangValidator.exe", "glslang.exe"] : ["glslangValidator", "glslang"];
        string[] folders = (Environment.GetEnvironmentVariable("PATH") ?? "")
            .Split(System.IO.Path.PathSeparator, StringSplitOptions.RemoveEmptyEntries);
        return folders.SelectMany(folder => names.Select(name => System.IO.Path.Combine(folder, name))).FirstOrDefault(File.Exists);
    }
}
