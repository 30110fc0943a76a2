using System.Collections.Generic;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>Wings that share a pack do not know of each other: to the last bit.</summary>
    public sealed class NeighbourTests
    {
        private const int k_Frames = 30;
        private const float k_Frame = 0.1f;

        [Test]
        public void AWing_MovesAlike_InEveryLane_BesideWhateverNeighbours([Values(1, 2, 3, 6)] int before)
        {
            Assert.That(Flown(before, out int substeps), Is.EqualTo(Flown(0, out int alone)));
            Assert.That(substeps, Is.EqualTo(alone));
        }

        [Test]
        public void AFasterNeighbour_TakesMoreSubsteps()
        {
            WingRig rig = Monarch.Rig(16);
            using (var world = new WingWorld())
            {
                WingHandle slow = world.Add(rig, Monarch.Parameters, Air(0)), fast = world.Add(rig, Monarch.Parameters, Air(6));
                rig.Release();
                for (int frame = 0; frame < k_Frames; frame++)
                    world.Step(k_Frame); // frequencies are latched at the start of a beat
                Assert.That(world.Read(fast).Substeps, Is.GreaterThan(world.Read(slow).Substeps));
            }
        }

        // Joints, between steps too, forces and mesh of a wing that so many others were made before.
        private static List<float3> Flown(int before, out int substeps)
        {
            var seen = new List<float3>();
            WingRig rig = Monarch.Rig(16);
            using (var world = new WingWorld())
            {
                for (int k = 0; k < before; k++)
                    world.Add(rig, Monarch.Parameters, Air(k + 1));
                WingHandle wing = world.Add(rig, Monarch.Parameters, Air(0));
                world.Add(rig, Monarch.Parameters, Air(5));
                rig.Release();
                for (int frame = 0; frame < k_Frames; frame++)
                {
                    world.Step(k_Frame);
                    WingReading reading = world.Read(wing);
                    seen.Add(reading.AirForce);
                    for (int joint = 0; joint < reading.JointsPerChain; joint++)
                    {
                        seen.Add(reading.JointPosition(reading.ChainCount - 1, joint));
                        seen.Add(reading.JointPosition(1, joint, 0.37f));
                    }
                }

                substeps = world.Read(wing).Substeps;
                world.Skin(0.6f);
                foreach (SkinnedVertex vertex in world.Vertices(wing))
                    seen.Add(vertex.position);
            }

            return seen;
        }

        private static WingSurroundings Air(int number) => new WingSurroundings
        {
            wind = new float3(0.5f * number, 0f, -5f - 60f * number),
            gravity = new float3(0f, -200f, 0f),
            speed = 0.3f + 0.3f * number,
        };
    }
}
