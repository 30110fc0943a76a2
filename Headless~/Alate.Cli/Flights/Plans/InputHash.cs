namespace Alate.Cli;

/// <summary>A file that a run has read.</summary>
/// <param name="File">Its path as the run named it, from the folder in which it was started.</param>
/// <param name="Sha256">Lower-case hexadecimal.</param>
internal sealed record InputHash(string File, string Sha256);
