using Unity.Mathematics;

namespace Alate.Benchmarks;

/// <summary>Measures what the air of a wake adds to the beat of wings at which it is replayed.</summary>
internal static class InflowComparison
{
    public static void Run(Report report, Specimen specimen, Swarm without)
    {
        using var swarm = new Swarm([specimen], without.Insects);
        WingParameters parameters = specimen.Parameters;
        parameters.inflow = new WingInflow
        {
            mean = new float3(0f, -2f, -1f),
            cosine1 = new float3(0f, 1f, 0.5f),
            sine2 = new float3(0.2f, -0.5f, 1f),
        };
        foreach (WingHandle wing in swarm.Wings)
            swarm.World.SetParameters(wing, parameters);
        double[] time = Race.Run(swarm.Beats, without.Beats);
        report.Ratio(Targets.Inflow, time[0], time[1], time[0] / time[1]);
    }
}
