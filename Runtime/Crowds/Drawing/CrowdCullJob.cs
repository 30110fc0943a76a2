using System.Diagnostics;
using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace Alate.Crowds
{
    /// <summary>
    /// Leaves out what one camera does not see, chooses meshes, and lists the insects: one mesh's behind the other's, the farthest first
    /// where they are translucent.
    /// </summary>
    [BurstCompile]
    internal struct CrowdCullJob : IJob
    {
        /// <summary>Most meshes of an insect.</summary>
        public const int MaxSizes = 4;

        private const byte k_Unseen = 255;

        // Input
        public CrowdView view;

        /// <summary>Heights on the screen down to which the meshes are drawn.</summary>
        public float4 screenHeights;

        public int sizeCount;

        /// <summary>True where the farthest are drawn first.</summary>
        public bool sorts;

        [ReadOnly] public NativeArray<LoopRows> loops;
        [ReadOnly] public NativeArray<CrowdPose> poses;

        /// <summary>[insect] Middle and radius of the sphere around it, world; radius 0 for one that is not drawn.</summary>
        [ReadOnly] public NativeArray<float4> spheres;

        /// <summary>Insects that are drawn otherwise.</summary>
        [ReadOnly] public NativeArray<int> hidden;
        public int hiddenCount;

        // Input and output
        public CrowdInstances instances;

        // Scratch
        public NativeArray<byte> sizes;
        public CrowdOrder order;

        // Output

        /// <summary>[size] Insects that are drawn with a mesh.</summary>
        public NativeArray<int> counts;

        /// <summary>Insects in the order in which they are drawn.</summary>
        public NativeArray<int> seen;

        /// <summary>Checks the fields before the job is scheduled.</summary>
        /// <exception cref="System.ArgumentException">One is out of its range; names it, its value and the range.</exception>
        [Conditional(JobFields.Checks)]
        public void Validate()
        {
            JobFields.InRange(sizeCount, 1, MaxSizes, "CrowdCullJob.sizeCount");
            JobFields.InRange(hiddenCount, 0, hidden.Length, "CrowdCullJob.hiddenCount");
            for (int k = 0; k < hiddenCount; k++)
                JobFields.InRange(hidden[k], 0, poses.Length - 1, "CrowdCullJob.hidden");
            JobFields.AtLeast(loops.Length, 1, "CrowdCullJob.loops");
            JobFields.AtLeast(instances.Length, poses.Length, "CrowdCullJob.instances");
            JobFields.AtLeast(spheres.Length, poses.Length, "CrowdCullJob.spheres");
            JobFields.AtLeast(sizes.Length, poses.Length, "CrowdCullJob.sizes");
            JobFields.AtLeast(order.Length, sorts ? poses.Length : 0, "CrowdCullJob.order");
            JobFields.AtLeast(counts.Length, MaxSizes, "CrowdCullJob.counts");
            JobFields.AtLeast(seen.Length, poses.Length, "CrowdCullJob.seen");
        }

        public void Execute()
        {
            int4 found = 0;
            for (int insect = 0; insect < poses.Length; insect++)
            {
                byte size = SizeOf(spheres[insect]);
                sizes[insect] = size;
                if (size != k_Unseen)
                    found[size]++;
            }

            for (int k = 0; k < hiddenCount; k++)
            {
                byte size = sizes[hidden[k]];
                if (size == k_Unseen)
                    continue;
                found[size]--;
                sizes[hidden[k]] = k_Unseen;
            }

            int4 next = 0;
            for (int size = 0; size < MaxSizes; size++)
            {
                counts[size] = found[size];
                next[size] = size == 0 ? 0 : next[size - 1] + found[size - 1];
            }

            if (sorts)
                ListFarthestFirst(next);
            else
                ListAsTheyCome(next);
        }

        private void ListAsTheyCome(int4 next)
        {
            for (int insect = 0; insect < poses.Length; insect++)
            {
                if (sizes[insect] != k_Unseen)
                    List(insect, ref next);
            }
        }

        private void ListFarthestFirst(int4 next)
        {
            order.Begin();
            for (int insect = 0; insect < poses.Length; insect++)
            {
                if (sizes[insect] != k_Unseen)
                    order.Add(insect, math.dot(view.ahead, spheres[insect].xyz - view.eye));
            }

            order.SortFarthestFirst();
            for (int k = 0; k < order.Count; k++)
                List(order[k], ref next);
        }

        private void List(int insect, ref int4 next)
        {
            byte size = sizes[insect];
            seen[next[size]] = insect;
            next[size]++;
            instances.See(insect, poses[insect], loops);
        }

        private byte SizeOf(float4 sphere)
        {
            if (!view.Sees(sphere))
                return k_Unseen;
            float height = view.HeightOf(sphere);
            byte size = 0;
            while (size < sizeCount - 1 && height < screenHeights[size])
                size++;
            return size;
        }
    }
}
