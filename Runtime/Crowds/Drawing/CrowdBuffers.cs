using System;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Crowds
{
    /// <summary>Memory of a crowd: poses, and what the shader reads of those in sight. 169 bytes an insect.</summary>
    internal sealed class CrowdBuffers : IDisposable
    {
        /// <summary>Bytes of an insect.</summary>
        public const int BytesPerInsect = 56 + 1 + 64 + 3 * 16;

        public NativeArray<CrowdPose> poses;
        public NativeArray<byte> sizes;
        public NativeArray<float4x4> matrices;
        public NativeArray<float4> rows, nextRows, tints;
        public NativeArray<int> counts = new NativeArray<int>(CrowdJob.MaxSizes, Allocator.Persistent);
        public NativeArray<float4> planes = new NativeArray<float4>(6, Allocator.Persistent);
        public NativeArray<float3> corners = new NativeArray<float3>(2, Allocator.Persistent);
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
            matrices = new NativeArray<float4x4>(count, Allocator.Persistent);
            rows = new NativeArray<float4>(count, Allocator.Persistent);
            nextRows = new NativeArray<float4>(count, Allocator.Persistent);
            tints = new NativeArray<float4>(count, Allocator.Persistent);
            m_Insect = insect;
            loops = new NativeArray<LoopRows>(insect.Loops.Count, Allocator.Persistent);
            ReadLoops();
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
            return true;
        }

        /// <summary>Box around all that is drawn, world units.</summary>
        public Bounds Bounds
        {
            get
            {
                var box = new Bounds();
                box.SetMinMax(corners[0], corners[1]);
                return box;
            }
        }

        /// <summary>Frees everything.</summary>
        public void Dispose()
        {
            poses.Dispose();
            sizes.Dispose();
            matrices.Dispose();
            rows.Dispose();
            nextRows.Dispose();
            tints.Dispose();
            counts.Dispose();
            planes.Dispose();
            corners.Dispose();
            loops.Dispose();
            hidden.Dispose();
            nearest.Dispose();
            nearestDistances.Dispose();
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
