using System.Security.Cryptography;
using System.Text.Json.Nodes;

namespace Alate.Cli;

/// <summary>
/// Source that the page loads three.js from: a folder of the user's, or a public server, whose files must have the hashes named here.
/// </summary>
internal sealed class ThreeSource
{
    /// <summary>Version of the files on the public server.</summary>
    public const string Version = "0.187.0";

    /// <summary>Start of their addresses.</summary>
    public const string Server = "https://cdn.jsdelivr.net";

    private const string k_Main = "build/three.module.js", k_Orbit = "examples/jsm/controls/OrbitControls.js";

    /// <summary>The files by their places in the package three, with their SHA-384.</summary>
    public static readonly IReadOnlyDictionary<string, string> Hashes = new Dictionary<string, string>
    {
        [k_Main] = "sha384-T/E3B9AvPtLn5PKD7aTSFqizQcA4kHDfU0lub7u0fvM4w9BMGcSb3yI7r5LqMAMn",
        ["build/three.core.js"] = "sha384-drH6BueSlcvoXCwAqWkNJvXwu2Ax3mnGOmZnIXaomedIw+uXSP9Bf/XIUINgLUW+",
        [k_Orbit] = "sha384-ZVBN/wmVxgX0mUGjFJXakzzdZrAF4g4aHfKyusbjoF0WsVXSoGpeM/qRaVnXtaFo",
    };

    private readonly Dictionary<string, string> m_Files;

    private ThreeSource(Dictionary<string, string> files)
    {
        m_Files = files;
    }

    /// <summary>The public server.</summary>
    public static ThreeSource Public { get; } = new(null);

    /// <summary>Start of the addresses of the scripts.</summary>
    public string Root => m_Files == null ? $"{Server}/npm/three@{Version}" : "three";

    /// <summary>True where the page asks another server.</summary>
    public bool IsPublic => m_Files == null;

    /// <summary>Files of a folder; none for the public server.</summary>
    public IEnumerable<string> Names => m_Files?.Keys ?? Enumerable.Empty<string>();

    /// <summary>
    /// The package three of npm in the folder in which the program was started, beside the program, or above one of the two; the public
    /// server where there is none with these files.
    /// </summary>
    public static ThreeSource Find() => Find(Environment.CurrentDirectory, AppContext.BaseDirectory);

    /// <inheritdoc cref="Find()"/>
    /// <param name="starts">Folders at which the search begins.</param>
    public static ThreeSource Find(params string[] starts)
    {
        foreach (string start in starts)
        {
            for (var folder = new DirectoryInfo(start); folder != null; folder = folder.Parent)
            {
                foreach (string place in s_Places)
                {
                    string three = Path.Combine(folder.FullName, place);
                    if (IsThree(three))
                        return Of(three);
                }
            }
        }

        return Public;
    }

    /// <summary>A folder with the package three: its files in their folders, or beside one another.</summary>
    /// <exception cref="UserException">A file is missing.</exception>
    public static ThreeSource Of(string folder)
    {
        var files = new Dictionary<string, string>();
        foreach (string name in Hashes.Keys)
        {
            string[] places = [Path.Combine(folder, name), Path.Combine(folder, Path.GetFileName(name))];
            files[name] = places.FirstOrDefault(File.Exists)
                ?? throw new UserException(
                    $"--three: there is no '{name}' in '{folder}'. 'npm install three@{Version}' puts the files into node_modules/three.");
        }

        return new ThreeSource(files);
    }

    /// <summary>Content of a file of the folder.</summary>
    public byte[] Read(string name) => File.ReadAllBytes(m_Files[name]);

    /// <summary>The import map of the page.</summary>
    public string ImportMap()
    {
        string root = m_Files == null ? Root : "./three";
        var map = new JsonObject { ["imports"] = new JsonObject { ["three"] = $"{root}/{k_Main}", ["three/orbit"] = $"{root}/{k_Orbit}" } };
        if (IsPublic)
            map["integrity"] = new JsonObject(Hashes.Select(file => KeyValuePair.Create($"{root}/{file.Key}", (JsonNode)file.Value)));
        return map.ToJsonString(s_Plain);
    }

    private static readonly string[] s_Places =
    [
        Path.Combine("node_modules", "three"), Path.Combine("Web", "node_modules", "three"),
        Path.Combine("Headless~", "Web", "node_modules", "three"),
    ];

    // Nobody named it, so that only the files that are known are taken.
    private static bool IsThree(string folder)
    {
        try
        {
            return Hashes.All(file => File.Exists(Path.Combine(folder, file.Key)) && HashOf(Path.Combine(folder, file.Key)) == file.Value);
        }
        catch (Exception problem) when (FileProblem.Is(problem))
        {
            return false;
        }
    }

    private static string HashOf(string path) => "sha384-" + Convert.ToBase64String(SHA384.HashData(File.ReadAllBytes(path)));

    private static readonly System.Text.Json.JsonSerializerOptions s_Plain =
        new() { Encoder = System.Text.Encodings.Web.JavaScriptEncoder.UnsafeRelaxedJsonEscaping };
}
