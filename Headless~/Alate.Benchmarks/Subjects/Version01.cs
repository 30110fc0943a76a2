namespace Alate.Benchmarks;

/// <summary>
/// The model as version 0.1 had it: backward Euler, chains that bend each by itself, and its numbers of substeps and patches. What is
/// better now is shown beside it.
/// </summary>
internal static class Version01
{
    /// <summary>Aerodynamic patches of a wing.</summary>
    public const int Patches = 256;

    /// <summary>Substeps of a beat, and those of expressive variants.</summary>
    public const int Substeps = 24, SoftSubsteps = 48;

    /// <summary>Leaves out of the model what came later.</summary>
    public static void ApplyTo(ref WingParameters parameters)
    {
        parameters.options.timeScheme = TimeScheme.BackwardEuler;
        parameters.options.coupling = MembraneCoupling.OneWay;
    }
}
