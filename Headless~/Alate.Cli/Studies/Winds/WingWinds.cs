namespace Alate.Cli;

/// <summary>One kind of wing in wind.</summary>
/// <param name="Name">The kind.</param>
/// <param name="Now">In order of speeds, by today's model.</param>
/// <param name="Before">The same by version 0.1.</param>
internal sealed record WingWinds(string Name, IReadOnlyList<WindPoint> Now, IReadOnlyList<WindPoint> Before);
