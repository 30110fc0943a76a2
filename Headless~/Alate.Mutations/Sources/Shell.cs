using System;
using System.Diagnostics;
using System.IO;

namespace Alate.Mutations.Sources;

/// <summary>Programs that a run needs.</summary>
internal static class Shell
{
    /// <summary>Runs a program to its end.</summary>
    /// <returns>What it wrote to its output.</returns>
    /// <exception cref="InvalidOperationException">It failed; the message has what it said.</exception>
    public static string Run(string folder, string program, params string[] arguments)
    {
        var start = new ProcessStartInfo(program, arguments) { WorkingDirectory = folder, RedirectStandardOutput = true };
        start.Environment["MSBUILDDISABLENODEREUSE"] = "1";
        using var process = Process.Start(start);
        string output = process.StandardOutput.ReadToEnd();
        process.WaitForExit();
        return process.ExitCode == 0
            ? output
            : throw new InvalidOperationException($"{program} {string.Join(' ', arguments)} failed:\n{output}");
    }

    /// <summary>Copies the files of the checkout that Git knows or would add, and a folder that was built.</summary>
    public static void CopyTree(string root, string built, string to)
    {
        string listed = Run(root, "git", "ls-files", "-z", "-co", "--exclude-standard");
        foreach (string path in listed.Split('\0', StringSplitOptions.RemoveEmptyEntries))
            Copy(Path.Combine(root, path), Path.Combine(to, path));
        foreach (string path in Directory.EnumerateFiles(built, "*", SearchOption.AllDirectories))
            Copy(path, Path.Combine(to, Path.GetRelativePath(root, path)));
    }

    private static void Copy(string from, string to)
    {
        if (!File.Exists(from))
            return;
        Directory.CreateDirectory(Path.GetDirectoryName(to));
        File.Copy(from, to, true);
    }
}
