namespace Alate.Cli;

/// <summary>Beat and air of a wake.</summary>
/// <param name="Period">Seconds of a beat; 0 before the wings have beaten.</param>
/// <param name="Air">Velocity of the air against the body, axes of the body, m/s.</param>
internal readonly record struct WakePace(float Period, float3 Air);
