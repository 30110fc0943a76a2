namespace Alate.Cli;

/// <summary>Air that a wake sets moving at each wing of an insect over the beat, m/s in axes of the body.</summary>
/// <param name="Wings">[name of the kind of wing, side]</param>
internal sealed record FlightInflow(IReadOnlyDictionary<(string Name, WingSide Side), WingInflow> Wings)
{
    /// <summary>
    /// Inflow of a wing in the frame of a right one, wing lengths per second; that of its mirror image where it has none.
    /// </summary>
    public WingInflow Of(string name, WingSide side, float length)
    {
        WingSide other = side == WingSide.Right ? WingSide.Left : WingSide.Right;
        if (Wings.TryGetValue((name, side), out WingInflow own))
            return (side == WingSide.Left ? Mirrored(own) : own) * (1f / length);
        return Wings.TryGetValue((name, other), out WingInflow mirrored)
            ? (other == WingSide.Left ? Mirrored(mirrored) : mirrored) * (1f / length)
            : default;
    }

    /// <summary>Inflow between two: a share of the way to another one.</summary>
    public FlightInflow Towards(FlightInflow other, float share) => new(other.Wings.ToDictionary(
        wing => wing.Key, wing => Wings.GetValueOrDefault(wing.Key) * (1f - share) + wing.Value * share));

    /// <summary>Root of the mean square of the velocities over all wings and the beat, m/s.</summary>
    public double Size => Math.Sqrt(Wings.Values.Average(wing => wing.MeanSquare));

    /// <summary>Size of the difference from another one over the size of this, 1 where there is no other.</summary>
    public double ChangeFrom(FlightInflow other) => other == null || Size == 0.0
        ? 1.0
        : Math.Sqrt(Wings.Average(wing => (wing.Value + other.Wings.GetValueOrDefault(wing.Key) * -1f).MeanSquare)) / Size;

    private static WingInflow Mirrored(in WingInflow inflow) => new()
    {
        mean = Mirrored(inflow.mean),
        cosine1 = Mirrored(inflow.cosine1),
        sine1 = Mirrored(inflow.sine1),
        cosine2 = Mirrored(inflow.cosine2),
        sine2 = Mirrored(inflow.sine2),
    };

    private static float3 Mirrored(float3 velocity) => new(-velocity.x, velocity.y, velocity.z);
}
