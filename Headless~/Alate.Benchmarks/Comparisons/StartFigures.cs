using System;
using System.Collections.Generic;
using Unity.StandIns;
using UnityEngine;

namespace Alate.Benchmarks;

/// <summary>
/// Measures how long a frame takes to start insects of a swarm that appears at once, after its first frame: the longest of a start, the
/// best of some starts.
/// </summary>
internal static class StartFigures
{
    private const int k_Insects = 1000, k_Rounds = 3;
    private const float k_FrameTime = 1f / 60f;

    public static void Run(Report report)
    {
        // The first round compiles.
        Longest(WingSkinning.Cpu);
        report.Figure("start_1000_cpu_ms", $"start of {k_Insects} monarchs by the processor, longest frame", "ms", Best(WingSkinning.Cpu));
        Longest(WingSkinning.Gpu);
        report.Bounded(Targets.Start, Best(WingSkinning.Gpu));
    }

    private static double Best(WingSkinning skinning)
    {
        double best = double.MaxValue;
        for (int round = 0; round < k_Rounds; round++)
            best = Math.Min(best, Longest(skinning));
        return best;
    }

    private static double Longest(WingSkinning skinning)
    {
        PlayerLoop.EnterPlayMode();
        var monarch = new Brood(skinning);
        for (int k = 0; k < k_Insects; k++)
            monarch.Hatch(k, Vector3.forward);
        PlayerLoop.Tick(k_FrameTime);
        GC.Collect();
        double longest = 0.0;
        while (WingSystem.InsectCount < k_Insects)
        {
            MarkerTimes.Clear();
            MarkerTimes.On = true;
            PlayerLoop.Tick(k_FrameTime);
            MarkerTimes.On = false;
            longest = Math.Max(longest, 1e3 * MarkerTimes.Seconds().GetValueOrDefault("Alate.Start"));
        }

        PlayerLoop.ExitPlayMode();
        return longest;
    }
}
