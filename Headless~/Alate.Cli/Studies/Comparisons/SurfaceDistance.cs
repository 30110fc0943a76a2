namespace Alate.Cli;

/// <summary>Distance between two flights of one wing at equal phase, over all vertices and a beat, per cent of the wing's length.</summary>
internal readonly record struct SurfaceDistance(double MeanPct, double MaxPct)
{
    private const int k_Phases = 24;

    public static SurfaceDistance Between(RecordedWing wing, RecordedWing other)
    {
        SurfaceDistance[] phases = [.. Enumerable.Range(0, k_Phases).Select(phase => At(wing, other, phase / (double)k_Phases))];
        return new SurfaceDistance(phases.Average(phase => phase.MeanPct), phases.Max(phase => phase.MaxPct));
    }

    /// <summary>Phase at which the wings of two flights of one insect are farthest apart in the mean over all vertices, beats.</summary>
    public static double FarthestPhase(IEnumerable<RecordedWing> wings, IEnumerable<RecordedWing> others) =>
        Enumerable.Range(0, k_Phases).Select(phase => phase / (double)k_Phases)
            .MaxBy(phase => wings.Zip(others, (wing, other) => At(wing, other, phase).MeanPct).Sum());

    private static SurfaceDistance At(RecordedWing wing, RecordedWing other, double phase)
    {
        float3[] places = wing.At(phase).Positions, others = other.At(phase).Positions;
        double sum = 0.0, most = 0.0;
        for (int k = 0; k < places.Length; k++)
        {
            double distance = math.distance(places[k], others[k]);
            sum += distance;
            most = math.max(most, distance);
        }

        double unit = wing.Placement.Length / 100.0;
        return new SurfaceDistance(sum / places.Length / unit, most / unit);
    }
}
