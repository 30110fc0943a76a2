namespace Alate.Cli;

/// <summary>Opens files that users name: regular ones that are not larger than their kind can be.</summary>
internal static class InputFile
{
    /// <summary>Largest file of tables, skeletons, motions and pages, of meshes, and of pictures, bytes.</summary>
    public const long Text = 16L << 20, Mesh = 256L << 20, Picture = 1L << 30;

    /// <summary>Opens a file.</summary>
    /// <param name="path">Its path.</param>
    /// <param name="most">Largest size, bytes.</param>
    /// <exception cref="UserException">There is no such file, it is none to read, or it is too large.</exception>
    public static FileStream Open(string path, long most)
    {
        if (FileProblem.IsNoName(path))
            throw new UserException("Cannot read '': a file needs a name.");
        try
        {
            if (Directory.Exists(path))
                throw new UserException($"Cannot read '{path}': it is a folder.");
            if (!File.Exists(path))
                throw new UserException($"Cannot read '{path}': there is no such file.");

            // Pipes and devices have no length, and opening one may wait for ever.
            long length = new FileInfo(File.ResolveLinkTarget(Path.GetFullPath(path), true)?.FullName ?? path).Length;
            if (length == 0)
                throw new UserException($"Cannot read '{path}': it is empty, or no regular file.");
            if (length > most)
                throw new UserException($"Cannot read '{path}': it is larger than {most >> 20} MiB.");
            ReadFiles.Add(path);
            return new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete);
        }
        catch (FileNotFoundException)
        {
            throw new UserException($"Cannot read '{path}': it links to no file.");
        }
        catch (Exception problem) when (FileProblem.Is(problem))
        {
            throw new UserException($"Cannot read '{path}': {problem.Message}");
        }
    }

    /// <summary>Copies a file into a stream.</summary>
    /// <param name="path">Its path.</param>
    /// <param name="most">Largest size, bytes.</param>
    /// <param name="stream">Where to.</param>
    /// <exception cref="UserException">There is no such file, it is none to read, or it is too large.</exception>
    public static void Copy(string path, long most, Stream stream)
    {
        using FileStream file = Open(path, most);
        file.CopyTo(stream);
    }
}
