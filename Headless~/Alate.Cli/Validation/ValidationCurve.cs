using System.Collections.Generic;

namespace Alate.Cli.Validation;

/// <summary>A quantity over the beat, at t/T = 0, 1/n, …</summary>
/// <param name="Key">Name of a user's file of it, without .csv.</param>
/// <param name="Title">Name and unit.</param>
/// <param name="Ours">The model's curves by their names.</param>
/// <param name="Measured">The published curve, or the user's; null for none.</param>
internal sealed record ValidationCurve(string Key, string Title, IReadOnlyList<(string Name, double[] Values)> Ours, double[] Measured);
