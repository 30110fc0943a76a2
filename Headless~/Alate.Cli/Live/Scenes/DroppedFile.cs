namespace Alate.Cli;

/// <summary>File that a viewer dropped on the page.</summary>
/// <param name="Name">Its name, without a folder.</param>
/// <param name="Content">Its content.</param>
internal sealed record DroppedFile(string Name, byte[] Content);
