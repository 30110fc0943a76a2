using System;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Alate.Crowds
{
    /// <summary>
    /// Memory of a crowd: poses, what the shader reads of each insect, and what the camera sees that draws. 190 bytes an insect, 12 more
    /// where they are translucent, 96 more with motion vectors.
    /// </summary>
    internal sealed class CrowdBuffers : IDisposable
    {
        /// <summary>Bytes of an insect.</summary>
        public const int BytesPerInsect = 56 + 16 + 113 + 1 + 4;

        public NativeArray<CrowdPose> poses;
        public NativeArray<float4> spheres;
        public CrowdInstances instances;
        public NativeArray<byte> sizes;
        public NativeArray<int> seen;
        public NativeArray<int> counts = new NativeArray<int>(CrowdCullJob.MaxSizes, Allocator.Persistent);
        public CrowdOrder order;
        public NativeArray<LoopRows> loops;
        public NativeArray<int> hidden = new NativeArray<int>(CrowdTwins.MaxCount, Allocator.Persistent);
        public NativeArray<int> nearest;
        public NativeArray<float> nearestDistances;

        private readonly BakedInsect m_Insect;

        /// <param name="count">Insects.</param>
        /// <param name="ranked">How many of the nearest are looked for.</param>
        /// <param name="insect">What is drawn.</param>
        public CrowdBuffers(int count, int ranked, BakedInsect insect)
        {
            nearest = new NativeArray<int>(ranked, Allocator.Persistent);
            nearestDistances = new NativeArray<float>(ranked, Allocator.Persistent);
            for (int place = 0; place < ranked; place++)
                nearest[place] = -1;
            poses = new NativeArray<CrowdPose>(count, Allocator.Persistent);
            sizes = new NativeArray<byte>(count, Allocator.Persistent);
            seen = new NativeArray<int>(count, Allocator.Persistent);
            spheres = new NativeArray<float4>(count, Allocator.Persistent);
            instances = new CrowdInstances(count);
            order = new CrowdOrder(1);
            m_Insect = insect;
            loops = new NativeArray<LoopRows>(insect.Loops.Count, Allocator.Persistent);
            ReadLoops();
            ReadMaterials();
        }

        /// <summary>Returns true where the memory is that of a crowd as it is now; takes over loops that were baked again.</summary>
        /// <param name="count">Insects.</param>
        /// <param name="insect">What is drawn.</param>
        public bool Fits(int count, BakedInsect insect)
        {
            if (insect == null || !ReferenceEquals(insect, m_Insect) || poses.Length != count || insect.Loops.Count == 0)
                return false;
            if (loops.Length != insect.Loops.Count)
            {
                loops.Dispose();
                loops = new NativeArray<LoopRows>(insect.Loops.Count, Allocator.Persistent);
            }

            ReadLoops();
            ReadMaterials();
            return true;
        }

        /// <summary>Keeps what the shader read of each insect in the last frame, or no longer.</summary>
        public void SetMotion(bool moves)
        {
            if (instances.Moves == moves || poses.Length == 0)
                return;
            instances.Dispose();
            instances = new CrowdInstances(poses.Length, moves);
        }

        /// <summary>True where a material is translucent, and what is behind must be drawn before what is in front.</summary>
        public bool IsTranslucent { get; private set; }

        /// <summary>Frees everything.</summary>
        public void Dispose()
        {
            poses.Dispose();
            sizes.Dispose();
            seen.Dispose();
            spheres.Dispose();
            instances.Dispose();
            counts.Dispose();
            order.Dispose();
            loops.Dispose();
            hidden.Dispose();
            nearest.Dispose();
            nearestDistances.Dispose();
        }

        private void ReadMaterials()
        {
            IsTranslucent = false;
            for (int k = 0; k < m_Insect.Materials.Count; k++)
            {
                Material material = m_Insect.Materials[k];
                IsTranslucent |= material != null && material.renderQueue > (int)RenderQueue.GeometryLast;
            }

            if (!IsTranslucent || order.Length >= poses.Length)
                return;
            order.Dispose();
            order = new CrowdOrder(poses.Length);
        }

        private void ReadLoops()
        {
            for (int loop = 0; loop < loops.Length; loop++)
            {
                CrowdLoop known = m_Insect.Loops[loop];
                loops[loop] = new LoopRows { frequency = known.frequency, first = known.firstFrame, count = known.frames };
            }
        }
    }
}
