namespace Alate.Cli;

/// <summary>Strip of a wing from its leading to its trailing edge, in axes of the body.</summary>
/// <param name="Span">Place of its middle between the root, 0, and the tip, 1.</param>
/// <param name="Circulation">Around the wing there, m²/s; above 0 where it lifts a wing that moves ahead.</param>
/// <param name="Force">Of the air, newtons per metre of span.</param>
/// <param name="Inflow">Velocity of the air that vortices have set moving, m/s.</param>
internal readonly record struct WakeStrip(double Span, double Circulation, float3 Force, float3 Inflow);
