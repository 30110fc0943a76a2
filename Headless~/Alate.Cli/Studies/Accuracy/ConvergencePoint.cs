namespace Alate.Cli;

/// <summary>Cost and error of a wing's beat at one number of substeps.</summary>
/// <param name="Scheme">How time advances.</param>
/// <param name="Substeps">Of a beat.</param>
/// <param name="ErrorPct">RMS of the joints' distance from the reference of the same scheme, % of the wing's length.</param>
/// <param name="Cost">Time of a beat over that of version 0.1 at its defaults, on this machine.</param>
internal sealed record ConvergencePoint(TimeScheme Scheme, int Substeps, double ErrorPct, double Cost);
