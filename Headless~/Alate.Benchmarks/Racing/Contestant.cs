using System;

namespace Alate.Benchmarks;

/// <summary>One way to do a piece of work.</summary>
/// <param name="Name">What the table calls it.</param>
/// <param name="Units">Pieces (vertices, joints, frames) that one call does: times are reported per piece.</param>
/// <param name="Work">Does the work and leaves its result where it can be read, so that none of it can be left out.</param>
/// <param name="Phases">
/// Calls that make a cycle. Where no two of them cost the same (the frames of a beat), the best of each is taken, and their mean.
/// </param>
internal sealed record Contestant(string Name, double Units, Action Work, int Phases = 1)
{
    /// <summary>Done before every round and not timed.</summary>
    public Action Prepare { get; init; }
}
