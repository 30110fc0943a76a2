using System.Diagnostics;
using Alate.Geometry;
using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace Alate.Crowds
{
    /// <summary>
    /// Places insects on circles of their own within a box; index = insect. Where each is depends on seed, insect and time alone.
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

        /// <summary>Speed of the loop, units of the insect's space per second, and slowest and fastest insect over it.</summary>
        public float speed;
        public float2 speeds;

        /// <summary>Largest difference of a size from 1.</summary>
        public float sizes;

        public int loop;
        public quaternion attitude;
        public uint seed;

        /// <summary>Seconds.</summary>
        public float time;

        // Output, of which phases are the crowd's.
        public NativeArray<CrowdPose> poses;

        /// <summary>Checks the fields before the job is scheduled over a number of insects.</summary>
        /// <exception cref="System.ArgumentException">One is out of its range; names it, its value and the range.</exception>
        [Conditional(JobFields.Checks)]
        public void Validate(int count)
        {
            JobFields.NotNegative(math.cmin(half), "SpawnJob.half");
            JobFields.NotNegative(math.cmax(half), "SpawnJob.half");
            JobFields.NotNegative(speed, "SpawnJob.speed");
            JobFields.Finite(speeds.x, "SpawnJob.speeds");
            JobFields.Finite(speeds.y, "SpawnJob.speeds");
            JobFields.Finite(sizes, "SpawnJob.sizes");
            JobFields.Finite(time, "SpawnJob.time");
            JobFields.InRange(loop, 0, int.MaxValue, "SpawnJob.loop");
            JobFields.AtLeast(poses.Length, count, "SpawnJob.poses");
        }

        public void Execute(int index)
        {
            var random = Random.CreateFromIndex((uint)index * 0x9E3779B9u ^ seed * 0x85EBCA6Bu);
            float3 spread = random.NextFloat3(), other = random.NextFloat3();
            float size = 1f + sizes * (2f * other.x - 1f), fast = math.lerp(speeds.x, speeds.y, other.y), side = other.z < 0.5f ? -1f : 1f;
            float widest = math.cmin(half.xz), circle = widest * math.lerp(k_LeastCircle, 1f, math.sqrt(spread.x) * spread.y);
            float2 middle = (half.xz - circle) * (2f * random.NextFloat2() - 1f);
            float angle = 2f * math.PI * spread.z + (circle > 0f ? side * size * speed * fast / circle * time : 0f);
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
