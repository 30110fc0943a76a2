using System;
using System.CommandLine;
using System.IO;

namespace Alate.Cli.Commands;

/// <summary><c>new-project DIR</c>: a Unity project that hosts this package, with its tests enabled.</summary>
internal static class NewProjectCommand
{
    private const string k_PackageName = "com.alate.insect-wings";
    private const string k_UnityVersion = "2022.3.62f1";

    public static Command Create()
    {
        var folder = new Argument<string>("DIR") { Description = "A new or empty folder." };
        var command = new Command("new-project",
            "Makes a Unity project that hosts this package from its folder, with the tests enabled.\n\nExample:\n  new-project ../AlateProject") { folder };
        command.SetAction(parsed =>
        {
            Make(parsed.GetValue(folder));
            return 0;
        });
        return command;
    }

    private static void Make(string folder)
    {
        string root = Path.GetFullPath(folder);
        if (File.Exists(root))
            throw new UserException($"'{folder}' is a file; name a new or empty folder.");
        if (Directory.Exists(root) && Directory.EnumerateFileSystemEntries(root).GetEnumerator().MoveNext())
            throw new UserException($"'{folder}' is not empty; name a new or empty folder.");

        string package = FindPackage();
        string manifest = File.ReadAllText(Path.Combine(package, "Packages", "manifest.json"))
            .Replace("\"file:../..\"", $"\"file:{package.Replace('\\', '/')}\"");
        try
        {
            Write(root, "Packages/manifest.json", manifest);
            Write(root, "ProjectSettings/ProjectVersion.txt", $"m_EditorVersion: {k_UnityVersion}\n");
            Directory.CreateDirectory(Path.Combine(root, "Assets"));
        }
        catch (Exception problem) when (problem is IOException or UnauthorizedAccessException)
        {
            throw new UserException($"Cannot write the project into '{folder}': {problem.Message}");
        }

        Console.WriteLine($"Made a Unity project in {root}.");
        Console.WriteLine($"Open it with Unity {k_UnityVersion} or newer; the package's tests stand in Window > General > Test Runner.");
    }

    private static void Write(string root, string path, string text)
    {
        string file = Path.Combine(root, path);
        Directory.CreateDirectory(Path.GetDirectoryName(file)!);
        File.WriteAllText(file, text);
    }

    // The package root is the nearest folder above the program that holds its package.json.
    private static string FindPackage()
    {
        for (var folder = new DirectoryInfo(AppContext.BaseDirectory); folder != null; folder = folder.Parent)
        {
            string description = Path.Combine(folder.FullName, "package.json");
            if (File.Exists(description) && File.ReadAllText(description).Contains($"\"{k_PackageName}\""))
                return folder.FullName;
        }

        throw new UserException("The package's folder was not found above this program; run it from a checkout of the package.");
    }
}
