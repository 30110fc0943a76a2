namespace Alate.Cli;

/// <summary>Insects and the winds they meet.</summary>
/// <param name="Flights">[species] Level flight at the species' cruise; the wind is added.</param>
/// <param name="Speeds">In order, m/s in air.</param>
/// <param name="InGusts">In gusts instead of a steady wind.</param>
internal sealed record WindPlan(IReadOnlyList<FlightPlan> Flights, IReadOnlyList<double> Speeds, bool InGusts)
{
    public const double MinSpeed = 0.0, MaxSpeed = 100.0;
    public const int MostSpeeds = 12;

    /// <summary>Water is slower than wind.</summary>
    private const double k_WaterShare = 0.1;

    /// <summary>Denser than that is a liquid, kg/m³.</summary>
    private const double k_Liquid = 100.0;

    public static IReadOnlyList<double> DefaultSpeeds { get; } = [0, 1, 2, 3, 5, 10];

    /// <summary>Factor on the speeds for a species: a tenth in water, else 1.</summary>
    public static double ShareOf(InsectDefinition definition)
    {
        WingPreset preset = definition.Wings[0].CreatePreset();
        double share = preset.Size.fluidDensity > k_Liquid ? k_WaterShare : 1.0;
        UnityEngine.Object.DestroyImmediate(preset);
        return share;
    }
}
