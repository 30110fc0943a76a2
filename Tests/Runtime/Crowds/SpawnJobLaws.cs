using Alate.Crowds;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;

namespace Alate.Tests.Crowds
{
    /// <summary>Laws of the circles on which a spawner places insects.</summary>
    public sealed class SpawnJobLaws
    {
        private const int k_Count = 400;

        [Test]
        public void Insects_StayInTheBox_WhateverTheTime_AndFillIt()
        {
            float3 least = float.PositiveInfinity, most = float.NegativeInfinity;
            foreach (float time in new[] { 0f, 0.7f, 133f })
            {
                foreach (CrowdPose pose in Place(Job(time)))
                {
                    float3 local = math.mul(math.transpose(math.float3x3(Turn())), pose.position - new float3(3f, 2f, 1f));
                    Assert.That(math.all(math.abs(local) <= new float3(10f, 2f, 5f) + 1e-4f), $"{local}");
                    least = math.min(least, local);
                    most = math.max(most, local);
                }
            }

            Assert.That(math.all(least < -0.9f * new float3(10f, 2f, 5f)) && math.all(most > 0.9f * new float3(10f, 2f, 5f)));
        }

        [Test]
        public void Insects_FlyWhereTheyLook_AtTheLoopsSpeedTimesTheirSizeAndTheirShare()
        {
            const float moment = 1e-3f;
            CrowdPose[] before = Place(Job(5f - moment)), now = Place(Job(5f)), after = Place(Job(5f + moment));
            float slowest = float.PositiveInfinity, fastest = 0f;
            int left = 0;
            for (int k = 0; k < k_Count; k++)
            {
                float3 velocity = (after[k].position - before[k].position) / (2f * moment);
                float3 ahead = math.rotate(math.mul(now[k].rotation, math.inverse(Attitude())), new float3(0f, 0f, 1f));
                float share = math.length(velocity) / (3f * now[k].scale);
                slowest = math.min(slowest, share);
                fastest = math.max(fastest, share);
                Assert.That(math.distance(math.normalize(velocity), ahead), Is.LessThan(0.05f));
                Assert.That(math.rotate(math.mul(now[k].rotation, math.inverse(Attitude())), new float3(0f, 1f, 0f)).y,
                    Is.EqualTo(1f).Within(1e-4f), "upright but for the attitude");
                float3 bend = after[k].position - 2f * now[k].position + before[k].position;
                left += math.cross(velocity, bend).y < 0f ? 1 : 0;
            }

            Assert.That(slowest, Is.EqualTo(0.5f).Within(0.03f));
            Assert.That(fastest, Is.EqualTo(2f).Within(0.03f));
            Assert.That(left, Is.InRange(k_Count / 3, 2 * k_Count / 3), "half of them circle to the left");
        }

        [Test]
        public void Sizes_SpreadAboutOne_AndKeep()
        {
            CrowdPose[] now = Place(Job(0f)), later = Place(Job(9f));
            float sum = 0f, least = 1f, most = 1f;
            for (int k = 0; k < k_Count; k++)
            {
                Assert.That(later[k].scale, Is.EqualTo(now[k].scale));
                Assert.That((later[k].loop, later[k].rate, later[k].tint), Is.EqualTo((2, 1f, 0xFFFFFFu)));
                sum += now[k].scale;
                least = math.min(least, now[k].scale);
                most = math.max(most, now[k].scale);
            }

            Assert.That(least, Is.EqualTo(0.7f).Within(0.01f));
            Assert.That(most, Is.EqualTo(1.3f).Within(0.01f));
            Assert.That(sum / k_Count, Is.EqualTo(1f).Within(0.03f));
        }

        [Test]
        public void AnotherSeed_PlacesAllElsewhere_AndOneSeedRepeats()
        {
            SpawnJob other = Job(0f);
            other.seed++;
            CrowdPose[] a = Place(Job(0f)), b = Place(Job(0f)), c = Place(other);
            Assert.That(a, Is.EqualTo(b));
            for (int k = 0; k < k_Count; k++)
                Assert.That(math.distance(a[k].position, c[k].position), Is.GreaterThan(1e-3f));
        }

        [Test]
        public void WhatTheCrowdHasSet_IsLeft_AndNewInsectsStartAtPhasesOfTheirOwn()
        {
            SpawnJob job = Job(0f);
            job.poses = new NativeArray<CrowdPose>(k_Count, Allocator.Persistent);
            NativeArray<CrowdPose> poses = job.poses;
            var flown = CrowdPose.At(default, quaternion.identity, 0.625f);
            flown.rate = 1.5f;
            flown.tint = 0x123456;
            poses[3] = flown;
            for (int k = 0; k < k_Count; k++)
                job.Execute(k);

            Assert.That((poses[3].phase, poses[3].rate, poses[3].tint), Is.EqualTo((0.625f, 1.5f, 0x123456u)));
            float least = 1f, most = 0f;
            for (int k = 0; k < k_Count; k++)
            {
                least = math.min(least, poses[k].phase);
                most = math.max(most, poses[k].phase);
            }

            poses.Dispose();
            Assert.That(least, Is.InRange(0f, 0.05f));
            Assert.That(most, Is.InRange(0.95f, 1f));
        }

        [Test]
        public void Sizes_LieEvenlyAroundOne_AsFarAsTheyVary()
        {
            SpawnJob job = Job(0f);
            job.sizes = 0.4f;
            float least = 2f, most = 0f, sum = 0f;
            foreach (CrowdPose pose in Place(job))
            {
                least = math.min(least, pose.scale);
                most = math.max(most, pose.scale);
                sum += pose.scale / k_Count;
            }

            Assert.That(least, Is.InRange(0.6f, 0.65f));
            Assert.That(most, Is.InRange(1.35f, 1.4f));
            Assert.That(sum, Is.EqualTo(1f).Within(0.05f));
        }

        [Test]
        public void ABoxWithoutWidth_HoldsThemAllTheSame()
        {
            SpawnJob job = Job(4f);
            job.half = new float3(0f, 2f, 0f);
            foreach (CrowdPose pose in Place(job))
                Assert.That(math.distance(pose.position.xz, new float2(3f, 1f)), Is.LessThan(1e-5f));
        }

#if ENABLE_UNITY_COLLECTIONS_CHECKS
        [Test]
        public void FieldsOutOfRange_AreNamed_BeforeTheJobIsScheduled()
        {
            using var poses = new NativeArray<CrowdPose>(3, Allocator.Persistent);
            SpawnJob job = Job(1f);
            job.poses = poses;
            Assert.That(() => job.Validate(3), Throws.Nothing);
            Assert.That(
                () => job.Validate(4), Throws.ArgumentException.With.Message.EqualTo("SpawnJob.poses has room for 3; the job needs 4."));
            job.half.y = -1f;
            Assert.That(() => job.Validate(3), Throws.ArgumentException.With.Message.StartsWith("SpawnJob.half is -1"));
            job.half.y = 1f;
            job.turned.x = float.PositiveInfinity;
            Assert.That(() => job.Validate(3), Throws.ArgumentException.With.Message.StartsWith("SpawnJob.turned is"));
        }

        [Test]
        public void TheEndsOfEachRange_AreWithinIt()
        {
            using var poses = new NativeArray<CrowdPose>(3, Allocator.Persistent);
            SpawnJob job = Job(0f);
            job.poses = poses;
            job.half = default;
            job.turned = job.turnedMore = default;
            job.sizes = 0f;
            job.loop = 0;
            Assert.That(() => job.Validate(3), Throws.Nothing);
            Assert.That(() => job.Validate(0), Throws.Nothing);
        }

        private delegate void Edit(ref SpawnJob job);

        [Test]
        public void EachNumberOutOfRange_IsNamed()
        {
            using var poses = new NativeArray<CrowdPose>(3, Allocator.Persistent);
            foreach ((string name, Edit edit) in new (string, Edit)[]
            {
                ("half", (ref SpawnJob job) => job.half.x = float.PositiveInfinity), ("half", (ref SpawnJob job) => job.half.z = -2f),
                ("turned", (ref SpawnJob job) => job.turned.x = float.NaN),
                ("turned", (ref SpawnJob job) => job.turned.y = float.PositiveInfinity),
                ("turnedMore", (ref SpawnJob job) => job.turnedMore.y = float.NaN),
                ("sizes", (ref SpawnJob job) => job.sizes = float.NaN), ("loop", (ref SpawnJob job) => job.loop = -1),
            })
            {
                SpawnJob job = Job(1f);
                job.poses = poses;
                edit(ref job);
                Assert.That(() => job.Validate(3), Throws.ArgumentException.With.Message.StartsWith($"SpawnJob.{name} "), name);
            }
        }
#endif

        private static CrowdPose[] Place(SpawnJob job)
        {
            job.poses = new NativeArray<CrowdPose>(k_Count, Allocator.Persistent);
            for (int k = 0; k < k_Count; k++)
                job.Execute(k);
            CrowdPose[] poses = job.poses.ToArray();
            job.poses.Dispose();
            return poses;
        }

        private static SpawnJob Job(float time) => new SpawnJob
        {
            toWorld = float4x4.TRS(new float3(3f, 2f, 1f), Turn(), 1f),
            half = new float3(10f, 2f, 5f),
            turned = time * 3f / 5f * new float2(0.5f, 2f),
            turnedMore = 0.3f * time * 3f / 5f * new float2(0.5f, 2f),
            sizes = 0.3f,
            loop = 2,
            attitude = Attitude(),
            seed = 7u,
        };

        private static quaternion Turn() => quaternion.RotateY(0.5f);

        private static quaternion Attitude() => quaternion.RotateX(-0.3f);
    }
}
