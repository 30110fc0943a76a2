using System.Diagnostics;
using Alate.Geometry;
using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace Alate.Crowds
{
    /// <summary>
    /// Places insects on circles of their own within a box; index = insect. Where each is depends on seed, insect and angles flown alone.
    /// </summary>
    [BurstCompile]
    internal struct SpawnJob : IJobFor
    {
        /// <summary>Least circle over half of the box.</summary>
        private const float k_LeastCircle = 0.1f;

        // Input
        public float4x4 toWorld;

        /// <summary>Half of the box, world units.</summary>
        public float3 half;

        /// <summary>
        /// Angles that the slowest and the fastest insect of size 1 have flown on the widest circle, radians; and what an insect has flown
        /// more that is larger by the largest difference. Added up over time, so that numbers that change move no insect at once.
        /// </summary>
        public float2 turned, turnedMore;

        /// <summary>Largest difference of a size from 1.</summary>
        public float sizes;

        public int loop;
        public quaternion attitude;
        public uint seed;

        // Output, of which phases are the crowd's.
        public NativeArray<CrowdPose> poses;

        /// <summary>Checks the fields before the job is scheduled over a number of insects.</summary>
        /// <exception cref="System.ArgumentException">One is out of its range; names it, its value and the range.</exception>
        [Conditional(JobFields.Checks)]
        public void Validate(int count)
        {
            JobFields.NotNegative(math.cmin(half), "SpawnJob.half");
            JobFields.NotNegative(math.cmax(half), "SpawnJob.half");
            JobFields.Finite(math.csum(turned), "SpawnJob.turned");
            JobFields.Finite(math.csum(turnedMore), "SpawnJob.turnedMore");
            JobFields.Finite(sizes, "SpawnJob.sizes");
            JobFields.InRange(loop, 0, int.MaxValue, "SpawnJob.loop");
            JobFields.AtLeast(poses.Length, count, "SpawnJob.poses");
        }

        public void Execute(int index)
        {
            var random = Random.CreateFromIndex((uint)index * 0x9E3779B9u ^ seed * 0x85EBCA6Bu);
            float3 spread = random.NextFloat3(), other = random.NextFloat3();
            float larger = 2f * other.x - 1f, size = 1f + sizes * larger, side = other.z < 0.5f ? -1f : 1f;
            float share = math.lerp(k_LeastCircle, 1f, math.sqrt(spread.x) * spread.y), circle = math.cmin(half.xz) * share;
            float2 middle = (half.xz - circle) * (2f * random.NextFloat2() - 1f), flown = turned + larger * turnedMore;
            float angle = 2f * math.PI * spread.z + side * math.lerp(flown.x, flown.y, other.y) / share;
            Elementary.SinCos(angle, out float sine, out float cosine);
            var place = new float3(middle.x + circle * cosine, half.y * (2f * random.NextFloat() - 1f), middle.y + circle * sine);
            var ahead = quaternion.LookRotation(new float3(-side * sine, 0f, side * cosine), new float3(0f, 1f, 0f));

            CrowdPose pose = poses[index];
            if (pose.scale == 0f)
                pose = CrowdPose.At(default, quaternion.identity, spread.y);
            pose.position = math.transform(toWorld, place);
            pose.rotation = math.mul(math.mul(new quaternion(toWorld), ahead), attitude);
            pose.scale = size;
            pose.loop = loop;
            poses[index] = pose;
        }
    }
}
