namespace Alate.Cli;

/// <summary>Loads of the air on a wing, in axes of the body.</summary>
/// <param name="Force">Newtons.</param>
/// <param name="Moment">About the middle of the thorax, newton metres.</param>
/// <param name="Power">That the wing gives to the air, watts.</param>
/// <param name="Inflow">Mean velocity of the air that vortices have set moving, m/s.</param>
/// <param name="Strips">From the root to the tip.</param>
internal readonly record struct WakeLoad(
    float3 Force, float3 Moment, double Power, float3 Inflow, IReadOnlyList<WakeStrip> Strips);

/// <summary>Moment of a beat with its wake.</summary>
/// <param name="Turns">Time, beats.</param>
/// <param name="Wings">[wing with a lattice]</param>
/// <param name="IsSymmetric">True where each wing has a mirror image.</param>
internal sealed record WakeMoment(double Turns, IReadOnlyList<WakeLoad> Wings, bool IsSymmetric)
{
    /// <summary>Force on all wings, newtons.</summary>
    public float3 Force => Both(Wings.Aggregate(default(float3), (sum, wing) => sum + wing.Force));

    /// <summary>Power of all wings, watts.</summary>
    public double Power => (IsSymmetric ? 2 : 1) * Wings.Sum(wing => wing.Power);

    private float3 Both(float3 right) => IsSymmetric ? new float3(0f, 2f * right.y, 2f * right.z) : right;
}
