using System;

namespace Alate.Cli.Flights;

/// <summary>What to fly, how, and with which model.</summary>
internal sealed class FlightPlan
{
    public string Species { get; init; }
    public string MeshFile { get; init; }
    public string SkeletonFile { get; init; }
    public double Speed { get; init; }
    public double Climb { get; init; }
    public double PitchDegrees { get; init; }
    public double? Seconds { get; init; }
    public double[] Wind { get; init; }
    public double? Lag { get; init; }
    public double Elasticity { get; init; }
    public int? Substeps { get; init; }
    public int Patches { get; init; }
    public CoefficientSet? Coefficients { get; init; }
    public ModelPreset Preset { get; init; }
    public bool NoWave { get; init; }
    public bool Rigid { get; init; }

    /// <summary>|u| of Eq. 6–7, m/s.</summary>
    public double BodySpeed => Math.Sqrt(Speed * Speed + Climb * Climb);

    /// <summary>The species' parameters with this plan's changes.</summary>
    public WingParameters ParametersOf(WingSpecies species)
    {
        WingParameters parameters = species.ToParameters();
        parameters.elasticity *= (float)Elasticity;
        parameters.substepsPerBeat = Substeps ?? parameters.substepsPerBeat;
        parameters.chordDelay = (float)(Lag ?? parameters.chordDelay);
        parameters.options.coefficients = Coefficients ?? parameters.options.coefficients;
        if (NoWave || Rigid)
            parameters.chordDelay = parameters.spanDelay = 0f;
        if (Rigid)
        {
            parameters.rootShare = 1f;
            parameters.jointLimit = 0f;
        }

        return parameters;
    }
}
