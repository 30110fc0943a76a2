namespace Alate.Cli;

/// <summary>Results of a flight and its wake: means over the beat, of all wings.</summary>
/// <param name="Wake">Force with the wake over the weight, axes of the world.</param>
/// <param name="Replayed">Force of the flight, in which the air of the wake before was replayed, over the weight.</param>
/// <param name="Power">Given to the air with the wake, W/kg.</param>
/// <param name="ReplayedPower">Given to the air in the flight, W/kg.</param>
/// <param name="Change">Difference between the air of this wake and the one that was replayed, over the size of this.</param>
internal sealed record WakeRound(float3 Wake, float3 Replayed, double Power, double ReplayedPower, double Change)
{
    public static WakeRound Of(FlightRecord flight, IReadOnlyList<WakeMoment> beat, double change)
    {
        PresetSize size = flight.Wings[0].Wing.Preset.Size;
        float weight = size.insectMass * (float)EarthGravity.Precise;
        float3 force = beat.Aggregate(default(float3), (sum, at) => sum + at.Force) / beat.Count;
        return new WakeRound(flight.Plan.ToWorld(force) / weight, flight.Plan.ToWorld(FlownLoads.Mean(flight)) / weight,
            beat.Average(at => at.Power) / size.insectMass, FlownLoads.Power(flight) / size.insectMass, change);
    }
}
