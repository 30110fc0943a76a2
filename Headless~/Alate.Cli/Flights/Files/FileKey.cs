namespace Alate.Cli;

/// <summary>A key of an object of a file.</summary>
/// <param name="Name">With its unit in words.</param>
/// <param name="Shape">The value.</param>
/// <param name="Help">One or two sentences.</param>
internal record FileKey(string Name, FileShape Shape, string Help)
{
    /// <summary>True for a key that every such object must have.</summary>
    public bool IsNeeded { get; init; }
}
