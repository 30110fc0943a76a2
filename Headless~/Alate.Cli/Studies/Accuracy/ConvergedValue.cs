namespace Alate.Cli;

/// <summary>A number of the manual at the default substeps, and its converged limit.</summary>
/// <param name="Key">Its name in files.</param>
/// <param name="Title">Its name to show, with the unit.</param>
/// <param name="AtDefaults">At the default substeps.</param>
/// <param name="Converged">At the reference's.</param>
internal sealed record ConvergedValue(string Key, string Title, double AtDefaults, double Converged)
{
    /// <summary>Difference of the default from the limit, % of the limit.</summary>
    public double DifferencePct => 100.0 * (AtDefaults - Converged) / System.Math.Abs(Converged);
}
