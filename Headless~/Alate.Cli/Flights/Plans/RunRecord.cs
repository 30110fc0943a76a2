namespace Alate.Cli;

/// <summary>Record of a run beside its numbers: what was asked for, and the files that were read.</summary>
/// <param name="Command">Words of the command line, without the places of its own files.</param>
internal sealed record RunRecord(IReadOnlyList<string> Command)
{
    /// <summary>Files and their SHA-256 as a run before had them; null for those that this one has read.</summary>
    public IReadOnlyList<InputHash> Inputs { get; init; }

    /// <summary>The files with their hashes.</summary>
    /// <exception cref="UserException">One cannot be read any more.</exception>
    public IReadOnlyList<InputHash> Hashed() => Inputs
        ?? ReadFiles.Paths.Select(path => new InputHash(path, ReadFiles.HashOf(path))).ToList();
}
