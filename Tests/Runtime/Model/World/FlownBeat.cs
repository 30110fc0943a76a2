using System.Collections.Generic;
using Alate.Catalogue;
using Unity.Collections;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>The last of eight beats of a wing, measured as researchers measure it.</summary>
    internal static class FlownBeat
    {
        private const int k_Beats = 8;

        /// <summary>Flies a monarch's wing and measures it.</summary>
        public static WingDeformation Measure(in WingParameters parameters, float speed = 1.3f)
        {
            WingRig rig = Monarch.Rig();
            SurfaceMesh mesh = InsectCatalogue.Find("monarch").Wings[0].CreateSurface(WingSide.Right);
            return Measure(mesh, rig, parameters, Monarch.Flying(speed), rig.Frame);
        }

        /// <summary>Flies and measures any wing.</summary>
        /// <param name="mesh">What the rig was baked for.</param>
        /// <param name="rig">Is released.</param>
        /// <param name="parameters">How the wing beats.</param>
        /// <param name="surroundings">What it feels.</param>
        /// <param name="frame">Where sections are cut and angles are measured.</param>
        public static WingDeformation Measure(
            SurfaceMesh mesh, WingRig rig, in WingParameters parameters, in WingSurroundings surroundings, in WingFrame frame)
        {
            int substeps = parameters.substepsPerBeat;
            var rest = new float3[mesh.VertexCount];
            for (int k = 0; k < rest.Length; k++)
                rest[k] = frame.ToWing(mesh.positions[k]);
            var beat = new List<BeatFrame>();
            using (var world = new WingWorld())
            {
                WingHandle wing = world.Add(rig, parameters, surroundings);
                rig.Release();
                float dt = 1f / (substeps * world.Read(wing).Frequency);
                for (int k = 1; k <= k_Beats * substeps; k++)
                {
                    world.Step(dt);
                    if (k > (k_Beats - 1) * substeps)
                        beat.Add(Frame(world, wing, frame));
                }
            }

            return new BeatMeasurement(rest, mesh.triangles).Measure(beat);
        }

        private static BeatFrame Frame(WingWorld world, WingHandle wing, WingFrame frame)
        {
            world.Skin();
            NativeArray<SkinnedVertex> vertices = world.Vertices(wing);
            var positions = new float3[vertices.Length];
            for (int k = 0; k < positions.Length; k++)
                positions[k] = frame.ToWing(vertices[k].position);
            WingReading reading = world.Read(wing);
            return new BeatFrame(reading.Phase, reading.DrivenRotation(0, 0), positions);
        }
    }
}
