using System.Diagnostics;
using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace Alate.Crowds
{
    /// <summary>
    /// Advances the phases of a crowd, leaves out what no camera sees, chooses meshes, and writes what the shader reads, one mesh's insects
    /// behind the other's.
    /// </summary>
    [BurstCompile]
    internal struct CrowdJob : IJob
    {
        /// <summary>Most meshes of an insect.</summary>
        public const int MaxSizes = 4;

        private const byte k_Unseen = 255;

        // Input
        public float seconds;
        public float radius;
        public float3 centre;
        public float3 eye;

        /// <summary>World units across half the screen's height at a distance of one; 0 for a camera without perspective.</summary>
        public float halfHeight;

        /// <summary>World units of half the screen's height without perspective.</summary>
        public float flatHeight;

        /// <summary>True where there is a camera to cull for.</summary>
        public bool culls;

        /// <summary>Heights on the screen down to which the meshes are drawn.</summary>
        public float4 screenHeights;

        public int sizeCount;
        [ReadOnly] public NativeArray<float4> planes;
        [ReadOnly] public NativeArray<LoopRows> loops;

        /// <summary>Insects that are drawn otherwise.</summary>
        [ReadOnly] public NativeArray<int> hidden;
        public int hiddenCount;

        // Input and output
        public NativeArray<CrowdPose> poses;

        // Output
        public NativeArray<byte> sizes;
        public NativeArray<int> counts;
        public NativeArray<float4x4> matrices;
        public NativeArray<float4> rows;
        public NativeArray<float4> nextRows;
        public NativeArray<float4> tints;

        /// <summary>Lower and upper corner of a box around all that is drawn, world units; both 0 where nothing is.</summary>
        public NativeArray<float3> corners;

        /// <summary>Insects in sight that are nearest to the camera, the nearest first; as many as there is room for, or −1.</summary>
        public NativeArray<int> nearest;
        public NativeArray<float> nearestDistances;

        /// <summary>Checks the fields before the job is scheduled.</summary>
        /// <exception cref="System.ArgumentException">One is out of its range; names it, its value and the range.</exception>
        [Conditional(JobFields.Checks)]
        public void Validate()
        {
            JobFields.Finite(seconds, "CrowdJob.seconds");
            JobFields.NotNegative(radius, "CrowdJob.radius");
            JobFields.InRange(sizeCount, 1, MaxSizes, "CrowdJob.sizeCount");
            JobFields.InRange(hiddenCount, 0, hidden.Length, "CrowdJob.hiddenCount");
            for (int k = 0; k < hiddenCount; k++)
                JobFields.InRange(hidden[k], 0, poses.Length - 1, "CrowdJob.hidden");
            JobFields.AtLeast(loops.Length, 1, "CrowdJob.loops");
            JobFields.AtLeast(sizes.Length, poses.Length, "CrowdJob.sizes");
            JobFields.AtLeast(counts.Length, MaxSizes, "CrowdJob.counts");
            JobFields.AtLeast(matrices.Length, poses.Length, "CrowdJob.matrices");
            JobFields.AtLeast(rows.Length, poses.Length, "CrowdJob.rows");
            JobFields.AtLeast(nextRows.Length, poses.Length, "CrowdJob.nextRows");
            JobFields.AtLeast(tints.Length, poses.Length, "CrowdJob.tints");
            JobFields.AtLeast(corners.Length, 2, "CrowdJob.corners");
            JobFields.AtLeast(nearestDistances.Length, nearest.Length, "CrowdJob.nearestDistances");
        }

        public void Execute()
        {
            int4 found = 0;
            for (int place = 0; place < nearest.Length; place++)
            {
                nearest[place] = -1;
                nearestDistances[place] = float.PositiveInfinity;
            }

            for (int insect = 0; insect < poses.Length; insect++)
            {
                CrowdPose pose = poses[insect];
                float frequency = math.lerp(LoopOf(pose.loop).frequency, LoopOf(pose.nextLoop).frequency, pose.blend);
                float phase = pose.phase + seconds * pose.rate * frequency;
                pose.phase = math.isfinite(phase) ? phase - math.floor(phase) : 0f;
                poses[insect] = pose;
                byte size = SizeOf(pose);
                sizes[insect] = size;
                if (size == k_Unseen)
                    continue;
                found[size]++;
                Rank(insect, math.distancesq(eye, pose.position));
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

            float3 lower = float.PositiveInfinity, upper = float.NegativeInfinity;
            for (int insect = 0; insect < poses.Length; insect++)
            {
                byte size = sizes[insect];
                if (size == k_Unseen)
                    continue;
                CrowdPose pose = poses[insect];
                Write(pose, next[size]++);
                float reach = radius * math.abs(pose.scale);
                lower = math.min(lower, MiddleOf(pose) - reach);
                upper = math.max(upper, MiddleOf(pose) + reach);
            }

            bool isEmpty = math.all(found == 0);
            corners[0] = isEmpty ? default : lower;
            corners[1] = isEmpty ? default : upper;
        }

        private float3 MiddleOf(in CrowdPose pose) => pose.position + math.rotate(pose.rotation, centre * pose.scale);

        // The last one for a number that no loop has, below 0 too.
        private LoopRows LoopOf(int loop) => loops[(int)math.min((uint)loop, (uint)loops.Length - 1u)];

        private void Rank(int insect, float distance)
        {
            int place = nearest.Length;
            while (place > 0 && distance < nearestDistances[place - 1])
            {
                place--;
                if (place + 1 < nearest.Length)
                {
                    nearest[place + 1] = nearest[place];
                    nearestDistances[place + 1] = nearestDistances[place];
                }
            }

            if (place == nearest.Length)
                return;
            nearest[place] = insect;
            nearestDistances[place] = distance;
        }

        private byte SizeOf(in CrowdPose pose)
        {
            float reach = radius * math.abs(pose.scale);
            float3 middle = MiddleOf(pose);
            if (!(reach > 0f && math.all(math.isfinite(middle))))
                return k_Unseen;
            if (!culls)
                return 0;
            for (int plane = 0; plane < planes.Length; plane++)
            {
                if (math.dot(planes[plane].xyz, middle) + planes[plane].w < -reach)
                    return k_Unseen;
            }

            float height = reach / (flatHeight + halfHeight * math.distance(eye, middle));
            byte size = 0;
            while (size < sizeCount - 1 && height < screenHeights[size])
                size++;
            return size;
        }

        private void Write(in CrowdPose pose, int at)
        {
            float3x3 turn = new float3x3(pose.rotation) * pose.scale;
            matrices[at] = new float4x4(
                new float4(turn.c0, 0f), new float4(turn.c1, 0f), new float4(turn.c2, 0f), new float4(pose.position, 1f));
            rows[at] = new float4(LoopOf(pose.loop).At(pose.phase), math.isnan(pose.blend) ? 0f : math.saturate(pose.blend));
            nextRows[at] = new float4(LoopOf(pose.nextLoop).At(pose.phase), 0f);
            tints[at] = new float4(pose.tint & 0xFF, (pose.tint >> 8) & 0xFF, (pose.tint >> 16) & 0xFF, 255f) * (1f / 255f);
        }
    }
}
