namespace Alate.Cli;

/// <summary>A quantity over the beat, at t/T = 0, 1/n, …</summary>
/// <param name="Key">Name of a user's file of it, without .csv.</param>
/// <param name="Title">Name and unit.</param>
/// <param name="Ours">The model's curves by their names.</param>
/// <param name="Measured">The published curve, or the user's, not a number where it has a hole; null for none.</param>
/// <param name="Published">What is published of it, and where; or that nothing was found.</param>
internal sealed record ValidationCurve(
    string Key, string Title, IReadOnlyList<(string Name, double[] Values)> Ours, double[] Measured, string Published = "")
{
    /// <summary>Names of its unit in the heading of a user's file; the first is that of messages.</summary>
    public IReadOnlyList<string> Units { get; init; } = ["°", "deg", "degrees"];

    /// <summary>Least and largest value that a user's file may have, in that unit.</summary>
    public (double Least, double Most) Range { get; init; } = (-180, 180);
}
