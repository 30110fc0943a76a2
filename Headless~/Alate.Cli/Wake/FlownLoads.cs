namespace Alate.Cli;

/// <summary>Loads that a recorded flight has by itself, beside those of its wake; newtons, axes of the body.</summary>
internal static class FlownLoads
{
    /// <summary>Force on a wing at a time, in beats.</summary>
    public static float3 Force(RecordedWing wing, double turns)
    {
        (RecordedFrame before, RecordedFrame after, float share) = wing.Around(turns);
        return Newtons(wing, math.lerp(before.AirForce, after.AirForce, share));
    }

    /// <summary>Mean force on all wings.</summary>
    public static float3 Mean(FlightRecord flight) => flight.Wings.Aggregate(default(float3), (sum, wing) => sum
        + wing.Frames.Aggregate(default(float3), (total, frame) => total + Newtons(wing, frame.AirForce)) / wing.Frames.Count);

    /// <summary>Mean power that all wings give to the air, watts; needs recorded loads of the air.</summary>
    public static double Power(FlightRecord flight) => flight.Wings.Sum(wing =>
    {
        PresetSize size = wing.Wing.Preset.Size;
        return size.wingMass * size.wingLength * size.wingLength * Enumerable.Range(0, wing.Frames.Count).Average(wing.Power);
    });

    private static float3 Newtons(RecordedWing wing, float3 force)
    {
        PresetSize size = wing.Wing.Preset.Size;
        return size.wingMass * size.wingLength * wing.Placement.DirectionToBody(force);
    }
}
