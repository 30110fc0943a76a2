using System;
using System.Collections.Generic;
using System.IO;

namespace Alate.Cli.Flights;

/// <summary>
/// A folder whose files appear all together or not at all: they are written beside their place under other names, and moved when all
/// are there. Opening it proves that it can be written, before the work is done.
/// </summary>
internal sealed class OutputFolder : IDisposable
{
    private const string k_Suffix = ".alate-part";

    private readonly List<string> _written = [];
    private readonly bool _made;

    /// <exception cref="UserException">The folder cannot be made or written.</exception>
    public OutputFolder(string folder)
    {
        Path = folder;
        try
        {
            _made = !Directory.Exists(folder);
            Directory.CreateDirectory(folder);
            string probe = Part("probe");
            File.WriteAllBytes(probe, []);
            File.Delete(probe);
        }
        catch (Exception problem) when (IsFileProblem(problem))
        {
            throw new UserException($"Cannot write into the folder '{folder}': {problem.Message}");
        }
    }

    public string Path { get; }

    public void Write(string name, Action<Stream> write)
    {
        try
        {
            _written.Add(name);
            using FileStream stream = File.Create(Part(name));
            write(stream);
        }
        catch (Exception problem) when (IsFileProblem(problem))
        {
            throw new UserException($"Cannot write '{name}' into '{Path}': {problem.Message}");
        }
    }

    /// <summary>Moves what was written to its place.</summary>
    public void Commit()
    {
        try
        {
            foreach (string name in _written)
                File.Move(Part(name), System.IO.Path.Combine(Path, name), overwrite: true);
        }
        catch (Exception problem) when (IsFileProblem(problem))
        {
            throw new UserException($"Cannot write into the folder '{Path}': {problem.Message}");
        }

        _written.Clear();
    }

    public void Dispose()
    {
        foreach (string name in _written)
            File.Delete(Part(name));
        if (_made && Directory.GetFileSystemEntries(Path).Length == 0)
            Directory.Delete(Path);
    }

    private string Part(string name) => System.IO.Path.Combine(Path, name + k_Suffix);

    private static bool IsFileProblem(Exception problem) =>
        problem is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException;
}
