namespace Alate.Cli;

/// <summary>Distance between two flights of one wing at equal phase, over all vertices and a beat, per cent of the wing's length.</summary>
internal readonly record struct SurfaceDistance(double MeanPct, double MaxPct)
{
    private const int k_Phases = 24;

    public static SurfaceDistance Between(RecordedWing wing, RecordedWing other)
    {
        int count = wing.Rest.Length;
        double sum = 0.0, most = 0.0;
        for (int phase = 0; phase < k_Phases; phase++)
        {
            float3[] places = wing.At(phase / (double)k_Phases).Positions, others = other.At(phase / (double)k_Phases).Positions;
            for (int k = 0; k < count; k++)
            {
                double distance = math.distance(places[k], others[k]);
                sum += distance;
                most = math.max(most, distance);
            }
        }

        double unit = wing.Placement.Length / 100.0;
        return new SurfaceDistance(sum / (k_Phases * count) / unit, most / unit);
    }
}
