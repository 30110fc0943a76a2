namespace Alate.Cli;

/// <summary>Request for the air that the wings draw along, by momentum theory.</summary>
/// <param name="Factor">Wake factor: speed of the air over that of the even, steady wake; 0 to 3, 1 is the ideal.</param>
/// <param name="Density">Of the air, kg/m³; null is that of the insect's first wing.</param>
internal sealed record InducedFlow(double Factor, double? Density = null)
{
    /// <summary>Largest factor.</summary>
    public const double MostFactor = 3;
}
