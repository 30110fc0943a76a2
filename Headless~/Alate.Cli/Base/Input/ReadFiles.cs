using System.Security.Cryptography;
using System.Threading;

namespace Alate.Cli;

/// <summary>Files that a command has read, as it named them.</summary>
internal sealed class ReadFiles : IDisposable
{
    private static readonly AsyncLocal<ReadFiles> s_Current = new();

    private readonly List<string> m_Paths = [];

    private ReadFiles()
    {
    }

    /// <summary>Paths of the files read so far in this flow of control, each once; none where nobody asked.</summary>
    public static IReadOnlyList<string> Paths => s_Current.Value?.m_Paths ?? [];

    /// <summary>Notes the files that are opened from now on, in this flow of control.</summary>
    public static ReadFiles Begin() => s_Current.Value = new ReadFiles();

    /// <summary>Notes a file.</summary>
    public static void Add(string path)
    {
        if (s_Current.Value is not { } current)
            return;
        lock (current.m_Paths)
        {
            if (!current.m_Paths.Contains(path))
                current.m_Paths.Add(path);
        }
    }

    /// <summary>SHA-256 of a file, lower-case hexadecimal.</summary>
    /// <exception cref="UserException">It cannot be read.</exception>
    public static string HashOf(string path)
    {
        using FileStream file = InputFile.Open(path, InputFile.Picture);
        return Convert.ToHexStringLower(SHA256.HashData(file));
    }

    /// <summary>Stops noting.</summary>
    public void Dispose() => s_Current.Value = null;
}
