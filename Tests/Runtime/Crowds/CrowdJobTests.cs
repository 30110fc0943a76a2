using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Crowds;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests.Crowds
{
    /// <summary>Picture that a crowd draws of each insect, against closed forms.</summary>
    public sealed class CrowdJobTests
    {
        private static readonly LoopRows[] s_Loops =
        {
            new LoopRows { frequency = 10f, first = 3, count = 8 }, new LoopRows { frequency = 4f, first = 11, count = 5 },
            new LoopRows { frequency = 0f, first = 16, count = 1 },
        };

        private readonly List<IDisposable> m_Made = new List<IDisposable>();

        [TearDown]
        public void FreeMemory()
        {
            foreach (IDisposable made in m_Made)
                made.Dispose();
            m_Made.Clear();
        }

        [TestCase(0x0000FFu, 1f, 0f, 0f)]
        [TestCase(0x00FF00u, 0f, 1f, 0f)]
        [TestCase(0xFF0000u, 0f, 0f, 1f)]
        [TestCase(0xFF336699u, 0.6f, 0.4f, 0.2f)]
        public void ATint_IsRedGreenBlue_FromTheLowestByte_AndOpaque(uint tint, float red, float green, float blue)
        {
            var pose = CrowdPose.At(default, quaternion.identity);
            pose.tint = tint;
            CrowdJob job = Run(Job(new[] { pose }));

            Assert.That(math.distance(job.tints[0], new float4(red, green, blue, 1f)), Is.LessThan(1e-6f));
        }

        [Test]
        public void Phases_GoOnByTimeRateAndFrequency_AndStayBelowOne()
        {
            CrowdPose plain = CrowdPose.At(default, quaternion.identity, 0.3f), quick = plain, back = plain, blended = plain;
            quick.rate = 2.5f;
            back.rate = -1f;
            blended.nextLoop = 1;
            blended.blend = 0.25f;
            CrowdJob job = Job(new[] { plain, quick, back, blended });
            job.seconds = 0.07f;
            Run(job);

            float[] wanted = { 0.3f + 0.7f - 1f, 0.3f + 1.75f - 2f, 0.3f - 0.7f + 1f, 0.3f + 0.07f * 8.5f };
            for (int k = 0; k < wanted.Length; k++)
            {
                Assert.That(job.poses[k].phase, Is.InRange(0f, 1f));
                Assert.That(Turn(job.poses[k].phase - wanted[k]), Is.LessThan(1e-5f), $"insect {k}");
            }
        }

        [Test]
        public void Rows_AreThoseOfBothLoops_AtOnePhase()
        {
            var pose = CrowdPose.At(default, quaternion.identity, 0.9f);
            pose.nextLoop = 1;
            pose.blend = 0.35f;
            CrowdJob job = Run(Job(new[] { pose }));

            Assert.That(math.distance(job.rows[0], new float4(3f + 7f, 3f, 0.2f, 0.35f)), Is.LessThan(1e-5f), "7.2 of 8 frames");
            Assert.That(math.distance(job.nextRows[0].xyz, new float3(11f + 4f, 11f, 0.5f)), Is.LessThan(1e-5f), "4.5 of 5 frames");
        }

        [TestCase(0f, 0, 1, 0f)]
        [TestCase(0.25f, 2, 3, 0f)]
        [TestCase(0.9375f, 7, 0, 0.5f)]
        [TestCase(1f, 7, 0, 1f)]
        public void ALoopsRows_EncloseThePhase(float phase, int before, int after, float share)
        {
            Assert.That(s_Loops[0].At(phase), Is.EqualTo(new float3(3 + before, 3 + after, share)));
            Assert.That(s_Loops[2].At(phase).xy, Is.EqualTo(new float2(16f, 16f)), "one row alone");
        }

        [Test]
        public void TheBox_IsTheSmallestAroundTheSpheresOfAllThatAreDrawn()
        {
            var random = new Random(11u);
            for (int trial = 0; trial < 20; trial++)
            {
                CrowdPose[] poses = Enumerable.Range(0, 12).Select(_ => Somewhere(ref random)).ToArray();
                CrowdJob job = Job(poses, 4, 2, 7);
                job.planes[0] = new float4(1f, 0f, 0f, -0.5f);
                Run(job);

                float3 lower = float.MaxValue, upper = float.MinValue;
                int drawn = 0;
                for (int size = 0; size < CrowdJob.MaxSizes; size++)
                    drawn += job.counts[size];
                for (int k = 0; k < drawn; k++)
                {
                    float4x4 matrix = job.matrices[k];
                    float reach = job.radius * math.length(matrix.c1.xyz);
                    float3 middle = math.transform(matrix, job.centre);
                    lower = math.min(lower, middle - reach);
                    upper = math.max(upper, middle + reach);
                }

                Assert.That(drawn, Is.InRange(1, 10));
                Assert.That(math.distance(job.corners[0], lower), Is.LessThan(1e-4f));
                Assert.That(math.distance(job.corners[1], upper), Is.LessThan(1e-4f));
            }
        }

        [Test]
        public void TheBoxOfNothing_IsAPoint()
        {
            var pose = CrowdPose.At(new float3(3f, 0f, 0f), quaternion.identity);
            pose.scale = 0f;
            CrowdJob job = Run(Job(new[] { pose }));

            Assert.That((job.corners[0], job.corners[1]), Is.EqualTo((float3.zero, float3.zero)));
        }

        [Test]
        public void Matrices_ScaleTurnAndMove()
        {
            var random = new Random(5u);
            CrowdPose[] poses = Enumerable.Range(0, 20).Select(_ => Somewhere(ref random)).ToArray();
            CrowdJob job = Run(Job(poses));

            for (int k = 0; k < poses.Length; k++)
            {
                float3 point = random.NextFloat3(-1f, 1f),
                    wanted = poses[k].position + math.rotate(poses[k].rotation, point * poses[k].scale);
                Assert.That(math.distance(math.transform(job.matrices[k], point), wanted), Is.LessThan(1e-4f));
            }
        }

        [Test]
        public void AnInsect_IsLeftOut_OnceItsScaledBoundsAreBeyondAnyPlane([Values(0, 1, 2, 3, 4, 5)] int plane)
        {
            var random = new Random(17u + (uint)plane);
            for (int k = 0; k < 20; k++)
            {
                float3 normal = random.NextFloat3Direction();
                CrowdPose pose = Somewhere(ref random);
                CrowdJob job = Job(new[] { pose });
                float reach = job.radius * pose.scale;
                float3 middle = pose.position + math.rotate(pose.rotation, job.centre * pose.scale);
                NativeArray<float4> planes = job.planes;
                planes[plane] = new float4(normal, -math.dot(normal, middle) - 0.99f * reach);
                Assert.That(Run(job).counts[0], Is.EqualTo(1), "still seen");
                planes[plane] = new float4(normal, -math.dot(normal, middle) - 1.01f * reach);
                Assert.That(Run(job).counts[0], Is.Zero, "beyond");
            }
        }

        [Test]
        public void InsectsWithoutSize_AreNotDrawn([Values(0f, float.NaN)] float scale, [Values] bool culls)
        {
            var pose = CrowdPose.At(default, quaternion.identity);
            pose.scale = scale;
            CrowdJob job = Job(new[] { pose, CrowdPose.At(default, quaternion.identity) });
            job.culls = culls;

            Assert.That(Run(job).counts.ToArray(), Is.EqualTo(new[] { 1, 0, 0, 0 }));
            Assert.That(job.nearest[0], Is.EqualTo(1));
        }

        [Test]
        public void TheMesh_IsTheSmallestThatIsFineEnough_ForTheHeightOnTheScreen([Values] bool perspective)
        {
            foreach (float height in new[] { 0.6f, 0.31f, 0.29f, 0.11f, 0.09f, 0.001f })
            {
                // The middle of the insect straight ahead of the eye, turned and twice as large.
                CrowdJob job = Job(new[] { CrowdPose.At(default, quaternion.RotateY(1f)) });
                CrowdPose pose = job.poses[0];
                pose.scale = 2f;
                float reach = 2f * job.radius;
                job.eye = new float3(1f, 2f, 3f);
                job.halfHeight = perspective ? 0.5f : 0f;
                job.flatHeight = perspective ? 0f : reach / height;
                float away = perspective ? reach / (0.5f * height) : 4f;
                pose.position = job.eye + new float3(0f, 0f, away) - math.rotate(pose.rotation, job.centre * pose.scale);
                NativeArray<CrowdPose> poses = job.poses;
                poses[0] = pose;
                int size = height > 0.3f ? 0 : height > 0.1f ? 1 : 2;

                Assert.That(
                    Run(job).counts.ToArray(), Is.EqualTo(Enumerable.Range(0, 4).Select(k => k == size ? 1 : 0)), $"height {height}");
            }
        }

        [Test]
        public void WithoutACamera_AllAreDrawnWithTheFinestMesh()
        {
            CrowdJob job = Job(
                new[] { CrowdPose.At(new float3(0f, 0f, 1e6f), quaternion.identity), CrowdPose.At(default, quaternion.identity) });
            NativeArray<float4> planes = job.planes;
            planes[0] = new float4(0f, 0f, 1f, -1e9f);
            job.culls = false;

            Assert.That(Run(job).counts[0], Is.EqualTo(2));
        }

        [Test]
        public void TheNearestInSight_AreRanked_AsASortRanksThem([Values(1, 3, 8, 30)] int ranked)
        {
            var random = new Random(9u);
            CrowdPose[] poses = Enumerable.Range(0, 24).Select(_ => Somewhere(ref random)).ToArray();
            poses[4].scale = 0f;
            CrowdJob job = Job(poses, ranked);
            job.eye = new float3(1f, -1f, 2f);
            Run(job);

            float3 eye = job.eye;
            IEnumerable<int> sorted = Enumerable.Range(0, 24).Where(k => k != 4).OrderBy(k => math.distance(eye, poses[k].position));
            Assert.That(job.nearest.ToArray(), Is.EqualTo(sorted.Concat(Enumerable.Repeat(-1, 30)).Take(ranked)));
            Run(job);
            Assert.That(job.nearest.ToArray(), Is.EqualTo(sorted.Concat(Enumerable.Repeat(-1, 30)).Take(ranked)),
                "nothing is left of the frame before");
        }

        [Test]
        public void EachMeshsInsects_StandTogether_WithoutThoseThatAreHidden()
        {
            // Far, near, middle, near, middle, far along Z; the second near one and the first far one are hidden, and one out of sight with
            // them.
            float[] aways = { 90f, 5f, 28f, 6f, 29f, 80f, -50f };
            CrowdPose[] poses = aways.Select(away => CrowdPose.At(new float3(0f, 0f, away), quaternion.identity)).ToArray();
            CrowdJob job = Job(poses, 2, 3, 0, 6);
            job.radius = 3f;
            job.centre = 0f;
            job.halfHeight = 1f;
            NativeArray<float4> planes = job.planes;
            planes[0] = new float4(0f, 0f, 1f, 0f);
            Run(job);

            Assert.That(job.counts.ToArray(), Is.EqualTo(new[] { 1, 2, 1, 0 }), "heights 0.6, 0.107 and 0.103, 0.0375");
            Assert.That(Enumerable.Range(0, 4).Select(k => job.matrices[k].c3.z), Is.EqualTo(new[] { 5f, 28f, 29f, 80f }));
            Assert.That(job.nearest.ToArray(), Is.EqualTo(new[] { 1, 3 }), "hidden insects count among the nearest");
        }

#if ENABLE_UNITY_COLLECTIONS_CHECKS
        [Test]
        public void FieldsOutOfRange_AreNamed_BeforeTheJobIsScheduled()
        {
            CrowdPose[] poses = { CrowdPose.At(default, quaternion.identity), CrowdPose.At(default, quaternion.identity) };
            Assert.That(() => Job(poses).Validate(), Throws.Nothing);
            Assert.That(() => Job(poses, 4, 1, 2).Validate(),
                Throws.ArgumentException.With.Message.EqualTo("CrowdJob.hidden is 2; it must be from 0 to 1."));
            CrowdJob job = Job(poses);
            job.seconds = float.NaN;
            Assert.That(() => job.Validate(), Throws.ArgumentException.With.Message.StartsWith("CrowdJob.seconds is NaN"));
            job = Job(poses);
            job.sizeCount = CrowdJob.MaxSizes + 1;
            Assert.That(() => job.Validate(), Throws.ArgumentException.With.Message.StartsWith("CrowdJob.sizeCount is 5"));
            job = Job(poses);
            job.tints = Keep(new NativeArray<float4>(1, Allocator.Persistent));
            Assert.That(
                () => job.Validate(), Throws.ArgumentException.With.Message.EqualTo("CrowdJob.tints has room for 1; the job needs 2."));
        }

        private delegate void Edit(ref CrowdJob job);

        [Test]
        public void EachArrayThatIsTooShort_IsNamed()
        {
            CrowdPose[] poses = { CrowdPose.At(default, quaternion.identity), CrowdPose.At(default, quaternion.identity) };
            foreach ((string name, Edit edit) in new (string, Edit)[]
            {
                ("loops", (ref CrowdJob job) => job.loops = Keep(new NativeArray<LoopRows>(0, Allocator.Persistent))),
                ("sizes", (ref CrowdJob job) => job.sizes = Keep(new NativeArray<byte>(1, Allocator.Persistent))),
                ("counts", (ref CrowdJob job) => job.counts = Keep(new NativeArray<int>(3, Allocator.Persistent))),
                ("matrices", (ref CrowdJob job) => job.matrices = Keep(new NativeArray<float4x4>(1, Allocator.Persistent))),
                ("rows", (ref CrowdJob job) => job.rows = Keep(new NativeArray<float4>(1, Allocator.Persistent))),
                ("nextRows", (ref CrowdJob job) => job.nextRows = Keep(new NativeArray<float4>(1, Allocator.Persistent))),
                ("corners", (ref CrowdJob job) => job.corners = Keep(new NativeArray<float3>(1, Allocator.Persistent))),
                ("nearestDistances", (ref CrowdJob job) =>
                    job.nearestDistances = Keep(new NativeArray<float>(job.nearest.Length - 1, Allocator.Persistent))),
                ("radius", (ref CrowdJob job) => job.radius = -1f),
                ("sizeCount", (ref CrowdJob job) => job.sizeCount = 0),
                ("hiddenCount", (ref CrowdJob job) => job.hiddenCount = job.hidden.Length + 1),
                ("hiddenCount", (ref CrowdJob job) => job.hiddenCount = -1),
            })
            {
                CrowdJob job = Job(poses);
                edit(ref job);
                Assert.That(() => job.Validate(), Throws.ArgumentException.With.Message.StartsWith($"CrowdJob.{name} "), name);
            }
        }
#endif

        private CrowdJob Job(CrowdPose[] poses, int ranked = 4, params int[] hidden) => new CrowdJob
        {
            radius = 0.7f,
            centre = new float3(0.3f, -0.2f, 0.5f),
            culls = true,
            halfHeight = 0.01f,
            screenHeights = new float4(0.3f, 0.1f, 0f, 0f),
            sizeCount = 3,
            planes = Keep(new NativeArray<float4>(6, Allocator.Persistent)),
            loops = Keep(new NativeArray<LoopRows>(s_Loops, Allocator.Persistent)),
            hidden = Keep(new NativeArray<int>(hidden.Length == 0 ? new int[1] : hidden, Allocator.Persistent)),
            hiddenCount = hidden.Length,
            poses = Keep(new NativeArray<CrowdPose>(poses, Allocator.Persistent)),
            sizes = Keep(new NativeArray<byte>(poses.Length, Allocator.Persistent)),
            counts = Keep(new NativeArray<int>(CrowdJob.MaxSizes, Allocator.Persistent)),
            matrices = Keep(new NativeArray<float4x4>(poses.Length, Allocator.Persistent)),
            rows = Keep(new NativeArray<float4>(poses.Length, Allocator.Persistent)),
            nextRows = Keep(new NativeArray<float4>(poses.Length, Allocator.Persistent)),
            tints = Keep(new NativeArray<float4>(poses.Length, Allocator.Persistent)),
            corners = Keep(new NativeArray<float3>(2, Allocator.Persistent)),
            nearest = Keep(new NativeArray<int>(ranked, Allocator.Persistent)),
            nearestDistances = Keep(new NativeArray<float>(ranked, Allocator.Persistent)),
        };

        // The planes of a new job lie at zero and leave nothing out.
        private static CrowdJob Run(CrowdJob job)
        {
            job.Execute();
            return job;
        }

        private NativeArray<T> Keep<T>(NativeArray<T> array) where T : struct
        {
            m_Made.Add(array);
            return array;
        }

        private static CrowdPose Somewhere(ref Random random)
        {
            var pose = CrowdPose.At(random.NextFloat3(-5f, 5f), random.NextQuaternionRotation());
            pose.scale = random.NextFloat(0.5f, 3f);
            return pose;
        }

        private static float Turn(float phase) => math.abs(phase - math.round(phase));
    }
}
