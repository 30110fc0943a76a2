using System.Reflection;
using System.Security.Cryptography;

namespace Alate.Cli;

/// <summary>
/// Files of the page, by their names behind the address: a list of its own, so that no path of a request is ever one of the disk.
/// </summary>
internal sealed class PageFiles
{
    /// <summary>The page itself.</summary>
    public const string Index = "index.html";

    private const string k_Folder = "Page/", k_SceneFolder = "ScenePage/", k_MapMark = "/*IMPORT MAP*/", k_ModeMark = "/*MODE*/",
        k_FirstFolder = "First/", k_FirstMark = "<!--FIRST-->";

    private readonly Dictionary<string, Func<byte[]>> m_Files = [];

    /// <param name="three">Where three.js is.</param>
    /// <param name="kind">What the page shows.</param>
    /// <param name="first">Insect that it shows first; null for none.</param>
    public PageFiles(ThreeSource three, PageKind kind, InsectDefinition first = null)
    {
        string map = three.ImportMap();
        Add(k_Folder);
        if (kind == PageKind.Scene)
            Add(k_SceneFolder);
        byte[] index = Encoding.UTF8.GetBytes(Encoding.UTF8.GetString(Find(Index)).Replace(k_MapMark, map)
            .Replace(k_ModeMark, kind.ToString().ToLowerInvariant()).Replace(k_FirstMark, AddFirst(first)));
        m_Files[Index] = () => index;
        foreach (string name in three.Names)
            m_Files[$"three/{name}"] = () => three.Read(name);
        string scripts = three.IsPublic ? " " + ThreeSource.Server : "";
        SecurityPolicy = "default-src 'none'; script-src 'self' "
            + $"'sha256-{Convert.ToBase64String(SHA256.HashData(Encoding.UTF8.GetBytes(map)))}'{scripts}; style-src 'self'; "
            + "connect-src 'self' ws://127.0.0.1:* ws://localhost:*; img-src 'self' blob: data:; base-uri 'none'; form-action 'none'; "
            + "frame-ancestors 'none'";
    }

    /// <summary>Sources that the page may load from, as the header of an answer.</summary>
    public string SecurityPolicy { get; }

    public IEnumerable<string> Names => m_Files.Keys;

    /// <summary>A file by its name; null where there is none.</summary>
    public byte[] Find(string name) => m_Files.TryGetValue(name, out Func<byte[]> read) ? read() : null;

    /// <summary>Content type of a file.</summary>
    public static string TypeOf(string name) => Path.GetExtension(name) switch
    {
        ".html" => "text/html; charset=utf-8",
        ".css" => "text/css; charset=utf-8",
        ".js" => "text/javascript; charset=utf-8",
        ".svg" => "image/svg+xml",
        ".png" => "image/png",
        _ => "application/octet-stream",
    };

    /// <summary>Name of the picture of an insect that a page shows until it has drawn the insect itself.</summary>
    public static string FirstPicture(string insect) => $"first-{insect}.png";

    // Insects of the catalogue have one. An insect of a file may have the name of one of them.
    private string AddFirst(InsectDefinition first)
    {
        if (first == null || !InsectCatalogue.All.Contains(first))
            return "";
        string name = FirstPicture(first.Name);
        m_Files[name] = () => Resource(k_FirstFolder + name);
        return $"<img id=\"first\" elementtiming=\"first\" src=\"{name}\" alt=\"\">";
    }

    // A file of a later folder is in place of one of the same name.
    private void Add(string folder)
    {
        foreach (string resource in typeof(PageFiles).Assembly.GetManifestResourceNames()
            .Where(name => name.StartsWith(folder, StringComparison.Ordinal)))
        {
            m_Files[resource[folder.Length..]] = () => Resource(resource);
        }
    }

    private static byte[] Resource(string name)
    {
        using Stream stream = Assembly.GetExecutingAssembly().GetManifestResourceStream(name);
        using var content = new MemoryStream();
        stream.CopyTo(content);
        return content.ToArray();
    }
}
