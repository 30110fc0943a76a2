using System.Text.Json.Nodes;

namespace Alate.Cli;

/// <summary>The folder of the package that this program was built from.</summary>
internal static class PackageRoot
{
    /// <summary>The package's name in Unity.</summary>
    public const string Name = "com.alate.insect-wings";

    private const string k_File = "package.json";

    /// <summary>The package's version.</summary>
    /// <exception cref="UserException">The package was not found.</exception>
    public static string Version => (string)Describe(Find())["version"];

    /// <summary>The nearest folder above the program that holds the package's description, without a slash at its end.</summary>
    /// <exception cref="UserException">There is none.</exception>
    public static string Find()
    {
        for (var folder = new DirectoryInfo(AppContext.BaseDirectory); folder != null; folder = folder.Parent)
        {
            if (File.Exists(Path.Combine(folder.FullName, k_File)) && (string)Describe(folder.FullName)["name"] == Name)
                return folder.FullName.TrimEnd(Path.DirectorySeparatorChar);
        }

        throw new UserException("The package's folder was not found above this program; run it from a checkout of the package.");
    }

    private static JsonNode Describe(string folder) => JsonNode.Parse(File.ReadAllText(Path.Combine(folder, k_File)));
}
