using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
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
    private const string k_Wait = "Alate.Wait";

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
        var monarch = new Brood(InsectCatalogue.Find("monarch").Wings[0]);
        for (int k = 0; k < insects; k++)
            monarch.Hatch(k);
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
        double busy = seconds.Where(p => p.Key != k_Wait).Sum(p => p.Value);
        report.Figure("main_thread_us", $"{insects}", $"main thread, {insects} insects", "us/frame", 1e6 * busy / k_Frames);
        foreach ((string name, double time) in seconds.Where(p => p.Key != k_Wait && p.Value > 0.02 * busy).OrderByDescending(p => p.Value))
            report.Figure($"main_thread_{insects}_us", name, $"  {name}", "us/frame", 1e6 * time / k_Frames);
    }

    /// <summary>Monarchs with one mesh and skeleton a side.</summary>
    private sealed class Brood(WingDefinition kind)
    {
        private static readonly WingSide[] s_Sides = [WingSide.Right, WingSide.Left];
        private readonly Mesh[] m_Meshes = [.. s_Sides.Select(side => kind.CreateSurface(side).ToMesh($"monarch {side}"))];
        private readonly WingSkeleton[] m_Skeletons = [.. s_Sides.Select(side => kind.CreateSkeleton(side))];

        public void Hatch(int k)
        {
            var root = new GameObject($"monarch {k}");
            root.SetActive(false);
            root.transform.position = new Vector3(2f * (k % 20), 0f, 2f * (k / 20));
            InsectWings insect = root.AddComponent<InsectWings>();
            foreach (WingSide side in s_Sides)
            {
                var wing = new GameObject($"wing {side}", typeof(MeshFilter), typeof(MeshRenderer));
                wing.transform.SetParent(root.transform, false);
                wing.GetComponent<MeshFilter>().sharedMesh = m_Meshes[(int)side];
                insect.Wings.Add(new Wing { Renderer = wing.GetComponent<MeshRenderer>(), Side = side, Skeleton = m_Skeletons[(int)side] });
            }

            insect.Quality.culling = WingCulling.AlwaysSimulate;
            root.SetActive(true);
        }
    }
}
