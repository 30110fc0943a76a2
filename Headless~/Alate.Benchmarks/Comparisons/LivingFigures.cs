using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;
using Unity.StandIns;
using UnityEngine;

namespace Alate.Benchmarks;

/// <summary>
/// Measures frames of living monarchs as the component runs them: with vertices of the processor, with joints for the graphics card, with
/// levels of detail, and with a budget. Meshes, textures and renderers are stand-ins that copy.
/// </summary>
internal static class LivingFigures
{
    /// <summary>Milliseconds of the main thread that the wings may take.</summary>
    public const float Budget = 4f;

    private const int k_WarmUp = 30, k_Settling = 400, k_Frames = 90;
    private const float k_FrameTime = 1f / 60f;

    // Wings are a unit long: near ones fill a third of the picture's height, others from a fifth to a fiftieth.
    private const float k_NearBy = 5f, k_Nearest = 9f, k_Farthest = 80f;

    /// <summary>Numbers of insects.</summary>
    public static IReadOnlyList<int> Crowds { get; } = [100, 400, 1000, 3000];

    /// <summary>Measures all crowds.</summary>
    public static List<LivingFrame> Run(Report report)
    {
        var frames = new List<LivingFrame>();
        foreach (int insects in Crowds)
        {
            foreach (LivingCrowd crowd in new[]
                { LivingCrowd.Cpu, LivingCrowd.Gpu, LivingCrowd.GpuWithLevels, LivingCrowd.GpuWithBudget })
            {
                frames.Add(Measure(crowd, insects));
                Tell(report, frames[^1]);
            }

            LivingFrame cpu = frames[^4], gpu = frames[^3];
            double each = 1e3 / insects;
            report.Ratio(Targets.GpuFrame, $"{insects}", each * gpu.Frame, each * cpu.Frame, gpu.Frame / cpu.Frame);
            report.Ratio(Targets.GpuMain, $"{insects}", 1e3 * gpu.Main, 1e3 * cpu.Main, gpu.Main / cpu.Main);
            LivingFrame smaller = Measure(LivingCrowd.CpuWithLevels, insects), whole = Measure(LivingCrowd.CpuWithLevels, insects, true);
            report.Ratio(Targets.SmallerMeshes, $"{insects}", each * smaller.Frame, each * whole.Frame, smaller.Frame / whole.Frame);
        }

        return frames;
    }

    private static void Tell(Report report, LivingFrame frame)
    {
        string what = $"{frame.Insects} monarchs, {frame.Crowd}";
        report.Figure("living_frame_ms", what, $"{what}: a frame", "ms", frame.Frame);
        report.Figure("living_main_ms", what, $"{what}: main thread", "ms", frame.Main);
    }

    private static LivingFrame Measure(LivingCrowd crowd, int insects, bool whole = false)
    {
        PlayerLoop.EnterPlayMode();
        var monarch = new Brood(crowd is LivingCrowd.Cpu or LivingCrowd.CpuWithLevels ? WingSkinning.Cpu : WingSkinning.Gpu);
        bool hasLevels = crowd >= LivingCrowd.CpuWithLevels;
        for (int k = 0; k < insects; k++)
            monarch.Hatch(k, new Vector3(0f, 0f, hasLevels ? Distance(k) : k_NearBy));
        if (hasLevels)
            WingSystem.DetailCameras.Add(new GameObject("camera").AddComponent<Camera>());
        WingSystem.Budget = crowd == LivingCrowd.GpuWithBudget ? Budget : 0f;
        int warmUp = crowd == LivingCrowd.GpuWithBudget ? k_Settling : k_WarmUp;
        for (int frame = 0; frame < warmUp || WingSystem.InsectCount < insects; frame++)
            PlayerLoop.Tick(k_FrameTime);
        if (whole)
            Show(smaller: false);
        MarkerTimes.Clear();
        MarkerTimes.On = true;
        var wall = Stopwatch.StartNew();
        for (int frame = 0; frame < k_Frames; frame++)
            PlayerLoop.Tick(k_FrameTime);
        double milliseconds = wall.Elapsed.TotalMilliseconds / k_Frames;
        MarkerTimes.On = false;
        double main = 1e3 / k_Frames * MarkerTimes.Seconds().Where(marker => marker.Key != SystemFigures.Wait).Sum(marker => marker.Value);
        WingSystem.DetailCameras.Clear();
        WingSystem.Budget = 0f;
        PlayerLoop.ExitPlayMode();
        return new LivingFrame(crowd, insects, milliseconds, main);
    }

    /// <summary>Has all insects drawn with smaller meshes, or with whole ones, whatever their size.</summary>
    public static void Show(bool smaller)
    {
        foreach (InsectWings insect in Object.FindObjectsByType<InsectWings>(FindObjectsSortMode.None))
        {
            foreach (LiveMesh mesh in insect.Live.meshes)
            {
                mesh.ShowSmaller(smaller);
                foreach (LiveWing wing in mesh.wings)
                    WingSystem.Loop.World.SetSmaller(wing.handle, smaller);
            }
        }
    }

    // Three of ten are near, the others spread evenly.
    private static float Distance(int insect)
    {
        float share = insect * 0.618034f % 1f;
        return insect % 10 < 3 ? k_NearBy : k_Nearest + share * (k_Farthest - k_Nearest);
    }
}
