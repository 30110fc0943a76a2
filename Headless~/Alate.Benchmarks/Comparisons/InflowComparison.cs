using Unity.Mathematics;

namespace Alate.Benchmarks;

/// <summary>Measures what the air of a wake adds to the beat of wings at which it is replayed.</summary>
internal static class InflowComparison
{
    // A breath: all of the work is done, and the wings move alike, with as many iterations of their springs.
    private const float k_Speed = 1e-3f;

    public static void Run(Report report, Specimen specimen)
    {
        using Swarm swarm = new([specimen], FrameComparison.Insects), without = new([specimen], FrameComparison.Insects);
        WingParameters parameters = specimen.Parameters;
        parameters.inflow = new WingInflow
        {
            mean = new float3(0f, -k_Speed, 0f),
            cosine1 = new float3(0f, k_Speed, 0f),
            sine2 = new float3(0f, 0f, k_Speed),
        };
        foreach (WingHandle wing in swarm.Wings)
            swarm.World.SetParameters(wing, parameters);
        double[] time = Race.Run(swarm.Beats, without.Beats);
        report.Ratio(Targets.Inflow, time[0], time[1], time[0] / time[1]);
    }
}
