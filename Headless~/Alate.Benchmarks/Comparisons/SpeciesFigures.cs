using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;

namespace Alate.Benchmarks;

/// <summary>Bake time and frame time of every species there is, and what a beat of it costs beside one of version 0.1.</summary>
internal static class SpeciesFigures
{
    private const int k_Rounds = 10;
    private const int k_Insects = 32;

    /// <summary>One pack of each kind of wing: short rounds are seldom disturbed.</summary>
    private const int k_BeatInsects = WingPack.Lanes / 2;

    public static void Run(Report report)
    {
        foreach (InsectDefinition species in InsectCatalogue.All)
        {
            var kinds = species.Wings.Select(wing => new Specimen(wing)).ToList();
            var earlierKinds = species.Wings.Select(Specimen.OfVersion01).ToList();
            using (var swarm = new Swarm(kinds, k_Insects))
            {
                double[] time = Race.Run(k_Rounds, new Contestant("bake", 1e6, () => Bake(kinds)), swarm.Contestant);
                report.Figure("bake_ms", species.Name, $"bake of a {species.Name}", "ms", time[0]);
                report.Figure("us_per_insect_frame", species.Name, $"frame of a {species.Name}", "us/insect", time[1]);
            }

            using (Swarm swarm = new(kinds, k_BeatInsects), earlier = new(earlierKinds, k_BeatInsects))
            {
                double[] time = Race.Run(swarm.Beats, earlier.Beats);
                report.Ratio(Targets.BeatShare, species.Name, time[0], time[1], time[0] / time[1]);
            }

            kinds.ForEach(kind => kind.Dispose());
            earlierKinds.ForEach(kind => kind.Dispose());
        }
    }

    // The wings of one side: the other side's rigs are their mirror images.
    private static void Bake(List<Specimen> kinds)
    {
        foreach (Specimen kind in kinds)
            kind.Bake().Release();
    }
}
