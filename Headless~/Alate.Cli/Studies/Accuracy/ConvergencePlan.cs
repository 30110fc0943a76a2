namespace Alate.Cli;

/// <summary>Insects to measure, with the numbers of substeps.</summary>
/// <param name="Flights">[species] Level flight at the species' cruise.</param>
internal sealed record ConvergencePlan(IReadOnlyList<FlightPlan> Flights)
{
    /// <summary>Substeps of the reference.</summary>
    public const int ReferenceSubsteps = 480;

    /// <summary>Pitch of the flight whose lift is compared, degrees: level flight has next to none.</summary>
    public const double LiftPitch = 30.0;

    /// <summary>Numbers of substeps, all multiples of 4, the steps of a beat whose time is taken.</summary>
    public static IReadOnlyList<int> Substeps { get; } = [12, 16, 24, 32, 48, 96];

    /// <summary>Both schemes, the default first.</summary>
    public static IReadOnlyList<TimeScheme> Schemes { get; } = [TimeScheme.SecondOrder, TimeScheme.BackwardEuler];
}
