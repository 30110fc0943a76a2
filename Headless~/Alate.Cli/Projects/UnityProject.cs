using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Json.Nodes;

namespace Alate.Cli;

/// <summary>Makes a Unity project that hosts this package by its path.</summary>
internal static class UnityProject
{
    /// <summary>The editor that the project names; newer ones upgrade it.</summary>
    public const string UnityVersion = "2022.3.62f1";

    private const string k_Readme =
        "# Assets\n\nAn empty project that hosts the package Alate Insect Wings from the folder that Packages/manifest.json names.\n"
        + "Begin with GameObject > Alate > Monarch and press Play; run the package's tests from Window > General > Test Runner.\n";

    private const string k_GitIgnore = "Library/\nTemp/\nLogs/\nUserSettings/\nobj/\n*.csproj\n*.sln\n";

    /// <summary>Makes the project in a new or empty folder.</summary>
    /// <returns>Its full path.</returns>
    /// <exception cref="UserException">The folder is not empty or cannot be written.</exception>
    public static string Make(string folder)
    {
        if (File.Exists(folder))
            throw new UserException($"'{folder}' is a file; name a new or empty folder.");
        if (Directory.Exists(folder) && Directory.EnumerateFileSystemEntries(folder).Any())
            throw new UserException($"'{folder}' is not empty; name a new or empty folder.");
        string manifest = Manifest(PackageRoot.Find());
        using var project = OutputFolder.Prepare(folder);
        Write(project, "Packages/manifest.json", manifest);
        Write(project, "ProjectSettings/ProjectVersion.txt", $"m_EditorVersion: {UnityVersion}\n");
        Write(project, "Assets/README.md", k_Readme);
        Write(project, ".gitignore", k_GitIgnore);
        project.Commit();
        return project.Root;
    }

    private static void Write(OutputFolder project, string name, string text) =>
        project.Write(name, stream => stream.Write(Encoding.UTF8.GetBytes(text)));

    // The package keeps the pins of a hosting project in a manifest of its own; only the path differs.
    private static string Manifest(string package)
    {
        var manifest = JsonNode.Parse(File.ReadAllText(Path.Combine(package, "Packages", "manifest.json")));
        manifest["dependencies"][PackageRoot.Name] = "file:" + package.Replace('\\', '/');
        var options = new JsonSerializerOptions { WriteIndented = true, Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping };
        return manifest.ToJsonString(options) + "\n";
    }
}
