using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.Linq;
using Alate.Cli;
using Alate.Flight;
using Unity.Collections;
using Unity.Mathematics;

namespace Alate.Tests.Insects
{
    /// <summary>
    /// A species that beats, folds its wings as a perched insect does, opens them to bask, and rests: all wings at every step of the game.
    /// </summary>
    internal sealed class FoldedSpecies
    {
        private const float k_Step = 0.02f;
        private const int k_Beating = 25, k_Sitting = 350;

        private static readonly ConcurrentDictionary<string, FoldedSpecies> s_Folded = new ConcurrentDictionary<string, FoldedSpecies>();

        private FoldedSpecies(string name)
        {
            var plan = new FlightPlan { Species = name };
            var insect = Insect.Of(plan);
            using var world = new WingWorld();
            var wings = new List<RecordedWing>();
            var handles = new List<WingHandle>();
            var frames = new List<WingFrame>();
            foreach (InsectWing wing in insect.Wings)
            {
                var rig = WingRig.Bake(wing.Skeleton, wing.Surface, new WingRigSettings { patchCount = plan.Patches });
                foreach (WingSide side in new[] { WingSide.Right, WingSide.Left })
                {
                    handles.Add(world.Add(rig, plan.ParametersOf(wing.Preset), plan.SurroundingsOf(wing.Preset, side)));
                    frames.Add(rig.Frame);
                    wings.Add(new RecordedWing
                    {
                        Wing = wing,
                        Placement = wing.PlacementOf(rig.Frame, side),
                        Rest = Array.ConvertAll(wing.Surface.positions, position => rig.Frame.ToWing(position)),
                        Triangles = wing.Surface.triangles,
                    });
                }

                rig.Release();
            }

            Wings = wings;
            Record = new FlightRecord { Plan = plan, Insect = insect, Wings = wings };
            PresetValues[] values = wings.Select(wing => new PresetValues(wing.Wing.Preset)).ToArray();
            var rest = new WingRest();
            PerchSettings settings = PerchSettings.Default;
            for (int step = 0; step < k_Beating + k_Sitting; step++)
            {
                rest.Step(k_Step, step >= k_Beating, settings);
                for (int k = 0; k < wings.Count && rest.Fold > 0f; k++)
                    world.SetDrive(handles[k], values[k].Folded(rest.Fold));
                world.Step(k_Step);
                world.Skin();
                for (int k = 0; k < wings.Count; k++)
                    wings[k].Frames.Add(Frame(world.Vertices(handles[k]), frames[k], step * k_Step));
                Folds.Add(rest.Fold);
            }

            Resets = handles.Sum(handle => world.Read(handle).Resets);
        }

        /// <summary>[step] Wanted folding of the wings, 0 to 1.</summary>
        public List<float> Folds { get; } = [];

        public IReadOnlyList<RecordedWing> Wings { get; }

        public FlightRecord Record { get; }

        /// <summary>Number of times that a wing fell back to its driven pose.</summary>
        public int Resets { get; }

        public SurfaceMesh Body => Record.Insect.Body;

        /// <summary>Steps from the first one that folds; every one while the wings close, then each fifth.</summary>
        public IEnumerable<int> Sitting =>
            Enumerable.Range(k_Beating, 40).Concat(Enumerable.Range(0, (k_Sitting - 40) / 5).Select(k => k_Beating + 40 + 5 * k));

        /// <summary>The step at which the wings have just been closed and have come to rest.</summary>
        public int Closed => Enumerable.Range(k_Beating, k_Sitting).First(step => Folds[step] >= 0.9999f) + 15;

        public static FoldedSpecies Of(string name) => s_Folded.GetOrAdd(name, _ => new FoldedSpecies(name));

        /// <summary>A wing's vertices on the body, metres.</summary>
        public static float3[] Places(RecordedWing wing, int step) => Array.ConvertAll(wing.Frames[step].Positions, wing.Placement.ToBody);

        private static RecordedFrame Frame(NativeArray<SkinnedVertex> vertices, in WingFrame frame, double time)
        {
            var recorded =
                new RecordedFrame { Time = time, Positions = new float3[vertices.Length], Normals = new float3[vertices.Length] };
            for (int k = 0; k < vertices.Length; k++)
            {
                recorded.Positions[k] = frame.ToWing(vertices[k].position);
                recorded.Normals[k] = frame.DirectionToWing(vertices[k].normal);
            }

            return recorded;
        }
    }
}
