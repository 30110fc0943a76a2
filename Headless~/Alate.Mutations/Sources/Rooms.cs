using System;
using System.IO;

namespace Alate.Mutations.Sources;

/// <summary>Rooms of the sources, by their paths.</summary>
internal static class Rooms
{
    /// <summary>
    /// Room of a file: a folder of Runtime, and of Runtime/Model; Authoring, Files and Editor; a folder of the command line. Null for what
    /// has none: tests, generated files.
    /// </summary>
    /// <param name="path">Path from the root of the checkout, with slashes.</param>
    public static string Of(string path)
    {
        string[] parts = path.Split('/');
        if (path.Contains("/obj/", StringComparison.Ordinal) || Path.GetFileName(path) is "AssemblyInfo.cs")
            return null;
        return parts switch
        {
            ["Runtime", "Model", _] => "Model",
            ["Runtime", "Model", var room, ..] => $"Model/{room}",
            ["Runtime", var room, ..] => room,
            ["Editor", "Authoring", ..] => "Authoring",
            ["Editor", "Files", ..] => "Files",
            ["Editor", ..] => "Editor",
            ["Headless~", var project, _] => Project(project),
            ["Headless~", var project, var folder, ..] => $"{Project(project)}/{folder}",
            _ => null,
        };
    }

    private static string Project(string name) => name is "Alate.Cli" ? "Cli" : name.Replace("Alate.", "");
}
