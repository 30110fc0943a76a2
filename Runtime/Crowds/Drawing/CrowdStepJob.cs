using System.Diagnostics;
using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace Alate.Crowds
{
    /// <summary>
    /// Advances the phases of a crowd, places its spheres, makes ready what cameras saw in the last frame, and finds the insects that are
    /// nearest to an eye; once a frame, for all cameras.
    /// </summary>
    [BurstCompile]
    internal struct CrowdStepJob : IJob
    {
        // Input
        public float seconds;
        public CrowdShape shape;

        /// <summary>Camera whose nearest are looked for where <see cref="ranks"/>.</summary>
        public CrowdView view;

        /// <summary>True where there is such a camera.</summary>
        public bool ranks;

        [ReadOnly] public NativeArray<LoopRows> loops;

        // Input and output
        public NativeArray<CrowdPose> poses;
        public CrowdInstances instances;

        // Output

        /// <summary>[insect] Middle and radius of the sphere around it, world; radius 0 for one that is not drawn.</summary>
        public NativeArray<float4> spheres;

        /// <summary>Insects in sight that are nearest to the camera, the nearest first; as many as there is room for, or −1.</summary>
        public NativeArray<int> nearest;
        public NativeArray<float> nearestDistances;

        /// <summary>Checks the fields before the job is scheduled.</summary>
        /// <exception cref="System.ArgumentException">One is out of its range; names it, its value and the range.</exception>
        [Conditional(JobFields.Checks)]
        public void Validate()
        {
            JobFields.Finite(seconds, "CrowdStepJob.seconds");
            JobFields.NotNegative(shape.radius, "CrowdStepJob.radius");
            JobFields.AtLeast(loops.Length, 1, "CrowdStepJob.loops");
            JobFields.AtLeast(instances.Length, poses.Length, "CrowdStepJob.instances");
            JobFields.AtLeast(spheres.Length, poses.Length, "CrowdStepJob.spheres");
            JobFields.AtLeast(nearestDistances.Length, nearest.Length, "CrowdStepJob.nearestDistances");
        }

        public void Execute()
        {
            for (int place = 0; place < nearest.Length; place++)
            {
                nearest[place] = -1;
                nearestDistances[place] = float.PositiveInfinity;
            }

            for (int insect = 0; insect < poses.Length; insect++)
            {
                CrowdPose pose = poses[insect];
                float frequency = math.lerp(
                    LoopRows.Of(loops, pose.loop).frequency, LoopRows.Of(loops, pose.nextLoop).frequency, pose.blend);
                float phase = pose.phase + seconds * pose.rate * frequency;
                pose.phase = math.isfinite(phase) ? phase - math.floor(phase) : 0f;
                poses[insect] = pose;
                instances.Begin(insect, pose, loops);
                float4 sphere = shape.Around(pose);
                spheres[insect] = sphere;
                if (ranks && view.Sees(sphere))
                    Rank(insect, math.distancesq(view.eye, pose.position));
            }
        }

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
    }
}
