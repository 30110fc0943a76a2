namespace Alate.Cli;

/// <summary>Choice of flights with the deformation wave, without it, or both.</summary>
internal enum SweepWaves
{
    On,
    Off,

    /// <summary>Flights with and without the wave, as in the paper's Fig. 14.</summary>
    Both,
}
