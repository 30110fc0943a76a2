namespace Alate.Cli.Sweeps;

/// <summary>Whether a sweep is flown with the deformation wave.</summary>
internal enum SweepWaves
{
    On,
    Off,

    /// <summary>With and without, as in the paper's Fig. 14.</summary>
    Both,
}
