namespace Alate.Cli;

/// <summary>A single file that a user names: it is written as a whole or stays as it was.</summary>
internal static class OutputFile
{
    /// <summary>Folders of files that are devices: they are written to, never replaced.</summary>
    private static readonly string[] s_Devices = ["/dev/", "/proc/"];

    /// <summary>Folder of ordinary files in memory among them.</summary>
    private const string k_SharedMemory = "/dev/shm/";

    /// <summary>Tries whether the file can be written, and leaves no trace.</summary>
    /// <exception cref="UserException">It cannot.</exception>
    public static void Check(string file) => Try(file, () =>
    {
        if (FileProblem.IsNoName(file))
            throw new UserException("Cannot write '': a file needs a name.");
        if (Directory.Exists(file) || Path.GetFileName(file).Length == 0)
            throw new UserException($"Cannot write '{file}': it is a folder, not a file.");
        lock (Interruption.Files)
        {
            bool existed = File.Exists(file);
            File.Open(file, FileMode.OpenOrCreate, FileAccess.Write).Dispose();
            if (!existed)
                File.Delete(file);
        }
    });

    /// <summary>Writes the file: under another name beside it, which is changed at the end.</summary>
    /// <exception cref="UserException">It cannot be written; what was there before is there still.</exception>
    public static void Write(string file, Action<Stream> write)
    {
        Check(file);
        using var content = new MemoryStream();
        write(content);

        // What a link points to is written, not the link.
        string final = File.Exists(file) ? File.ResolveLinkTarget(Path.GetFullPath(file), true)?.FullName ?? file : file;
        if (IsDevice(final))
        {
            Try(file, () => WriteBytes(final, content));
            return;
        }

        using var folder = OutputFolder.Around(final, file);
        folder.Write(Path.GetFileName(final), content.WriteTo);
        folder.Commit();
    }

    private static bool IsDevice(string file)
    {
        string path = Path.GetFullPath(file);
        return Array.Exists(s_Devices, folder => path.StartsWith(folder, StringComparison.Ordinal))
            && !path.StartsWith(k_SharedMemory, StringComparison.Ordinal);
    }

    private static void WriteBytes(string file, MemoryStream content)
    {
        using var stream = new FileStream(file, FileMode.Open, FileAccess.Write, FileShare.ReadWrite, bufferSize: 0);
        content.WriteTo(stream);
    }

    private static void Try(string file, Action action)
    {
        try
        {
            action();
        }
        catch (Exception problem) when (FileProblem.Is(problem))
        {
            throw new UserException($"Cannot write '{file}': {FileProblem.Reason(problem)}");
        }
    }
}
