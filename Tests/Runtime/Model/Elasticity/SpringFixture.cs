using System;
using System.Collections.Generic;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>A spring network alone, as the solver sees it: n chains of m joints whose first joints are pinned.</summary>
    internal sealed unsafe class SpringFixture : IDisposable
    {
        private readonly List<IntPtr> m_Blocks = new List<IntPtr>();
        public readonly WingPack pack;
        public readonly StepScratch scratch;

        public SpringFixture(int chains, int joints, IReadOnlyList<Spring> springs, float stiffness)
        {
            pack.rig.chainCount = chains;
            pack.rig.jointsPerChain = joints;
            pack.rig.jointCount = chains * joints;
            pack.rig.springCount = springs.Count;
            pack.rig.springs = (Spring*)Block(springs.Count * sizeof(Spring));
            for (int s = 0; s < springs.Count; s++)
                pack.rig.springs[s] = springs[s];
            pack.parameters = (LaneParameters*)Block(sizeof(LaneParameters));
            pack.parameters->springStiffness = stiffness;
            var size = new RigSize
            {
                joints = chains * joints,
                bones = chains * (joints - 1),
                bandBlocks = pack.rig.BandBlocks,
                patches = 1,
            };
            StepScratch.Layout(size, Block(StepScratch.Layout(size, null, out _)), out scratch);
        }

        /// <summary>Places one joint: where it starts, where its mass was going, where it is posed.</summary>
        public void Place(int joint, float3 start, float3 predicted, float3 posed, float mass, float dt, float anchorRate)
        {
            float inverse2 = 1f / (dt * dt), pull = anchorRate * anchorRate;
            scratch.positions[joint] = new SoaFloat3(start);
            scratch.anchors[joint] = new SoaFloat3((predicted * inverse2 + posed * pull) / (inverse2 + pull));
            scratch.inertia[joint] = mass * (inverse2 + pull);
        }

        /// <summary>Joints of a grid: x along the chain, z across; random if a generator is given.</summary>
        public static List<Spring> Grid(int chains, int joints, float3[] rest)
        {
            var springs = new List<Spring>();
            void Add(int a, int b) => springs.Add(new Spring { a = a, b = b, length = math.distance(rest[a], rest[b]) });
            for (int i = 0; i < chains; i++)
            {
                for (int j = 0; j < joints; j++)
                {
                    int a = i * joints + j;
                    if (j + 1 < joints)
                        Add(a, a + 1);
                    if (i + 1 < chains && j > 0)
                        Add(a, a + joints);
                    if (i + 1 < chains && j + 1 < joints)
                    {
                        Add(a, a + joints + 1);
                        Add(a + 1, a + joints);
                    }
                }
            }

            return springs;
        }

        public void Dispose()
        {
            foreach (IntPtr block in m_Blocks)
                UnsafeUtility.Free((void*)block, Allocator.Persistent);
        }

        private byte* Block(long bytes)
        {
            byte* block = (byte*)UnsafeUtility.Malloc(bytes, 64, Allocator.Persistent);
            UnsafeUtility.MemClear(block, bytes);
            m_Blocks.Add((IntPtr)block);
            return block;
        }
    }
}
