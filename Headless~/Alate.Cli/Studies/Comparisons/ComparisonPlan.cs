namespace Alate.Cli;

/// <summary>Insects to compare, with the columns of the model.</summary>
/// <param name="Flights">[species] What each flies by; the columns change it.</param>
/// <param name="Columns">From the least to the most flexible; <see cref="ComparisonColumn.FullModel"/> is among them.</param>
/// <param name="Phases">Rows of the pictures.</param>
internal sealed record ComparisonPlan(IReadOnlyList<FlightPlan> Flights, IReadOnlyList<ComparisonColumn> Columns, int Phases)
{
    public const int MinPhases = 1, MaxPhases = 12, DefaultPhases = 4;

    /// <summary>The paper's columns with another elasticity in the last.</summary>
    public static IReadOnlyList<ComparisonColumn> ColumnsWith(float elasticity) =>
        ComparisonColumn.All.SkipLast(1).Append(ComparisonColumn.Elasticity(elasticity)).ToList();
}
