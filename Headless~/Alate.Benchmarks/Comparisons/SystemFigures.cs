using System.Collections.Generic;
using System.Linq;
using Unity.StandIns;
using UnityEngine;

namespace Alate.Benchmarks;

/// <summary>
/// Measures the component's cost on the main thread of a scene, phase by phase, besides waiting for the jobs. The transforms, meshes and
/// renderers are stand-ins, so that the figures show how the cost grows with the crowd, not the cost of Unity's own calls.
/// </summary>
internal static class SystemFigures
{
    private const int k_WarmUp = 30, k_Frames = 60;
    private const float k_FrameTime = 1f / 60f;

    /// <summary>Marker of the time in which the main thread waits for jobs.</summary>
    public const string Wait = "Alate.Wait";

    private static readonly int[] s_Crowds = [1, 100, 400];

    public static void Run(Report report)
    {
        foreach (int insects in s_Crowds)
        {
            PlayerLoop.EnterPlayMode();
            Hatch(insects);
            Measure(report, insects);
            PlayerLoop.ExitPlayMode();
        }
    }

    private static void Hatch(int insects)
    {
        var monarch = new Brood(WingSkinning.Cpu);
        for (int k = 0; k < insects; k++)
            monarch.Hatch(k, new Vector3(2f * (k % 20), 0f, 2f * (k / 20)));
    }

    private static void Measure(Report report, int insects)
    {
        for (int frame = 0; frame < k_WarmUp || WingSystem.InsectCount < insects; frame++)
            PlayerLoop.Tick(k_FrameTime);
        MarkerTimes.Clear();
        MarkerTimes.On = true;
        for (int frame = 0; frame < k_Frames; frame++)
            PlayerLoop.Tick(k_FrameTime);
        MarkerTimes.On = false;

        IReadOnlyDictionary<string, double> seconds = MarkerTimes.Seconds();
        double busy = seconds.Where(p => p.Key != Wait).Sum(p => p.Value);
        report.Figure("main_thread_us", $"{insects}", $"main thread, {insects} insects", "us/frame", 1e6 * busy / k_Frames);
        foreach ((string name, double time) in seconds.Where(p => p.Key != Wait && p.Value > 0.02 * busy).OrderByDescending(p => p.Value))
            report.Figure($"main_thread_{insects}_us", name, $"  {name}", "us/frame", 1e6 * time / k_Frames);
    }
}
