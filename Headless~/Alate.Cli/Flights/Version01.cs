namespace Alate.Cli.Flights;

/// <summary>
/// The model as version 0.1 had it: backward Euler, bends that do not know of the membrane, wind as it is, and its numbers of substeps and patches.
/// What is better now is shown beside it.
/// </summary>
internal static class Version01
{
    /// <summary>Aerodynamic patches of a wing.</summary>
    public const int Patches = 256;

    private const int k_Substeps = 24, k_SoftSubsteps = 48;

    /// <summary>Large enough to bound no wind.</summary>
    private const float k_AnyWind = 1000f;

    /// <summary>A flight by version 0.1 at its defaults.</summary>
    public static FlightPlan Of(FlightPlan plan) => plan with
    {
        IsVersion01 = true,
        Substeps = plan.Variant == SpeciesVariant.Expressive ? k_SoftSubsteps : k_Substeps,
        Patches = Patches,
    };

    /// <summary>Leaves out of the model what came later.</summary>
    public static void ApplyTo(ref WingParameters parameters)
    {
        parameters.options.timeScheme = TimeScheme.BackwardEuler;
        parameters.options.coupling = MembraneCoupling.OneWay;
        parameters.strongestWind = k_AnyWind;
    }
}
