using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using Alate.Catalogue;
using Unity.Burst;
using Unity.Jobs.LowLevel.Unsafe;
using Unity.Mathematics;
using UnityEditor;

namespace Alate.Proof
{
    /// <summary>Times frames of monarchs in level flight: steps and meshes, as the headless build times them.</summary>
    internal static class FrameTimes
    {
        private const int k_WarmUp = 20, k_Frames = 60;
        private const float k_FrameTime = 1f / 60f, k_CruiseShare = 0.65f, k_Spread = 0.002f;
        private const string k_SafetyOff = "Jobs/Burst/Safety Checks/Off", k_SafetyOn = "Jobs/Burst/Safety Checks/On";
        private const double k_Microseconds = 1e6;

        /// <summary>
        /// Microseconds of an insect in a frame by the headless build, .NET 10 on two cores of an AMD EPYC of 2.6 GHz; another machine may
        /// take twice that with safety checks off, and four times with them on.
        /// </summary>
        private const double k_Headless = 50.0, k_AllowedOff = 2.0, k_AllowedOn = 4.0;

        private static readonly int[] s_Insects = { 1, 100, 400, 1000 };

        /// <summary>Claims in their order.</summary>
        public static IEnumerable<string> Claims()
        {
            foreach (bool safety in new[] { false, true })
            {
                foreach (int insects in s_Insects)
                    yield return Claim(insects, safety);
            }
        }

        /// <summary>Times all.</summary>
        public static IEnumerable<ProofLine> Measure()
        {
            yield return ProofLine.Of("Burst compiles the jobs", BurstCompiler.IsEnabled, BurstCompiler.IsEnabled ? "on" : "off", "on");
            bool debugger = JobsUtility.JobDebuggerEnabled;
            try
            {
                foreach (bool safety in new[] { false, true })
                {
                    JobsUtility.JobDebuggerEnabled = safety;
                    bool isSet = EditorApplication.ExecuteMenuItem(safety ? k_SafetyOn : k_SafetyOff);
                    foreach (int insects in s_Insects)
                    {
                        yield return isSet ? Line(insects, safety, Time(insects))
                            : ProofLine.NotTried(Claim(insects, safety), "Burst's menu has no item to set its safety checks");
                    }
                }
            }
            finally
            {
                JobsUtility.JobDebuggerEnabled = debugger;
                EditorApplication.ExecuteMenuItem(k_SafetyOn);
            }
        }

        private static string Claim(int insects, bool safety) =>
            $"frame of {insects} monarch{(insects == 1 ? "" : "s")}, safety checks {(safety ? "on" : "off")}";

        // One insect has the cost of a frame's jobs to itself: it is told, and not judged.
        private static ProofLine Line(int insects, bool safety, double seconds)
        {
            double each = k_Microseconds * seconds / insects, allowed = (safety ? k_AllowedOn : k_AllowedOff) * k_Headless;
            return ProofLine.Of(
                Claim(insects, safety), insects == 1 || each <= allowed, Text($"{each:0.0} µs an insect, {1000.0 * seconds:0.00} ms"),
                insects == 1 ? "" : Text($"{allowed:0} µs"), Text($"headless {k_Headless:0} µs"));
        }

        private static double Time(int insects)
        {
            WingDefinition wing = InsectCatalogue.Find("monarch").Wings[0];
            WingPreset preset = wing.CreatePreset();
            WingParameters parameters = preset.ToParameters();
            var rig = WingRig.Bake(wing.CreateSkeleton(WingSide.Right), wing.CreateSurface(WingSide.Right), WingRigSettings.Default);
            try
            {
                using (var world = new WingWorld())
                {
                    float cruise = k_CruiseShare * parameters.maxSpeed;
                    for (int k = 0; k < 2 * insects; k++)
                        world.Add(rig, parameters, Air(preset, cruise * (1f + k_Spread * (k % 50))));
                    for (int frame = 0; frame < k_WarmUp; frame++)
                        Frame(world);
                    var watch = Stopwatch.StartNew();
                    for (int frame = 0; frame < k_Frames; frame++)
                        Frame(world);
                    return watch.Elapsed.TotalSeconds / k_Frames;
                }
            }
            finally
            {
                rig.Release();
            }
        }

        private static WingSurroundings Air(WingPreset preset, float speed) => new WingSurroundings
        {
            wind = new float3(0f, 0f, -speed / preset.WingLength),
            gravity = new float3(0f, -EarthGravity.Size / preset.WingLength, 0f),
            speed = speed,
        };

        private static void Frame(WingWorld world)
        {
            world.Step(k_FrameTime);
            world.Skin();
        }

        private static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
    }
}
