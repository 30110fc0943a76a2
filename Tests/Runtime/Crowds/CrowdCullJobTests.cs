using System.Linq;
using Alate.Crowds;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests.Crowds
{
    /// <summary>Picture that a crowd draws of each insect for one camera, against closed forms.</summary>
    public sealed class CrowdCullJobTests : CrowdJobFixture
    {
        [TestCase(0x0000FFu, 1f, 0f, 0f)]
        [TestCase(0x00FF00u, 0f, 1f, 0f)]
        [TestCase(0xFF0000u, 0f, 0f, 1f)]
        [TestCase(0xFF336699u, 0.6f, 0.4f, 0.2f)]
        public void ATint_IsRedGreenBlue_FromTheLowestByte_AndOpaque(uint tint, float red, float green, float blue)
        {
            var pose = CrowdPose.At(default, quaternion.identity);
            pose.tint = tint;
            CrowdCullJob job = Run(CullJob(new[] { pose }));

            Assert.That(math.distance(job.instances.tints[0], new float4(red, green, blue, 1f)), Is.LessThan(1e-6f));
        }

        [Test]
        public void Rows_AreThoseOfBothLoops_AtOnePhase()
        {
            var pose = CrowdPose.At(default, quaternion.identity, 0.9f);
            pose.nextLoop = 1;
            pose.blend = 0.35f;
            CrowdCullJob job = Run(CullJob(new[] { pose }));

            Assert.That(math.distance(job.instances.rows[0], new float4(3f + 7f, 3f, 0.2f, 0.35f)), Is.LessThan(1e-5f), "7.2 of 8 frames");
            Assert.That(
                math.distance(job.instances.nextRows[0].xyz, new float3(11f + 4f, 11f, 0.5f)), Is.LessThan(1e-5f), "4.5 of 5 frames");
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
        public void ACall_HasItsInsectsInTheirOrder_AndTheSmallestBoxAroundTheirSpheres([Values] bool sorts)
        {
            var random = new Random(11u);
            for (int trial = 0; trial < 20; trial++)
            {
                CrowdPose[] poses = Enumerable.Range(0, 23).Select(_ => Somewhere(ref random)).ToArray();
                for (int k = 0; k < poses.Length; k++)
                    poses[k].tint = (uint)k;
                CrowdCullJob job = CullJob(poses, 2, 7);
                job.sorts = sorts;
                Run(job);
                CrowdGatherJob gather = GatherJob(job, 3, 6);
                gather.Execute();

                float3 lower = float.MaxValue, upper = float.MinValue;
                for (int k = 0; k < 6; k++)
                {
                    int insect = job.seen[3 + k];
                    float4x4 matrix = gather.matrices[k];
                    Assert.That(math.distance(matrix.c3.xyz, poses[insect].position), Is.Zero);
                    Assert.That(gather.tints[k].x * 255f, Is.EqualTo(insect).Within(1e-3f));
                    Assert.That(gather.rows[k], Is.EqualTo(job.instances.rows[insect]));
                    Assert.That(gather.nextRows[k], Is.EqualTo(job.instances.nextRows[insect]));
                    float reach = Shape.radius * math.length(matrix.c1.xyz);
                    float3 middle = math.transform(matrix, Shape.centre);
                    lower = math.min(lower, middle - reach);
                    upper = math.max(upper, middle + reach);
                }

                Assert.That(math.distance(gather.corners[0], lower), Is.LessThan(1e-4f));
                Assert.That(math.distance(gather.corners[1], upper), Is.LessThan(1e-4f));
            }
        }

        [Test]
        public void EachCameraAndFrame_HasTheInsectsAsTheyAre_WhoeverSawThemBefore()
        {
            CrowdPose[] poses = Enumerable.Range(0, 4).Select(k => CrowdPose.At(new float3(k, 0f, 0f), quaternion.identity)).ToArray();
            CrowdStepJob step = StepJob(poses);
            step.Execute();
            CrowdCullJob job = CullJob(poses);
            job.poses = step.poses;
            job.spheres = step.spheres;
            job.instances = step.instances;
            for (int frame = 0; frame < 4; frame++)
            {
                // One camera sees the left half in even frames, another the middle in all.
                for (int camera = frame % 2; camera < 2; camera++)
                {
                    job.view = Behind(new Plane(Vector3.left, camera + 2.6f), new Plane(Vector3.right, 0.5f - camera));
                    Run(job);
                    for (int k = 0; k < job.counts[0]; k++)
                    {
                        int insect = job.seen[k];
                        Assert.That(
                            job.instances.matrices[insect].c3.y, Is.EqualTo(step.poses[insect].position.y), $"frame {frame}");
                    }

                    Assert.That(job.counts[0], Is.GreaterThan(1));
                }

                NativeArray<CrowdPose> moved = step.poses;
                for (int k = 0; k < 4; k++)
                {
                    CrowdPose pose = moved[k];
                    pose.position.y += 1f;
                    moved[k] = pose;
                }

                step.Execute();
            }
        }

        [Test]
        public void Matrices_ScaleTurnAndMove()
        {
            var random = new Random(5u);
            CrowdPose[] poses = Enumerable.Range(0, 20).Select(_ => Somewhere(ref random)).ToArray();
            CrowdCullJob job = Run(CullJob(poses));

            for (int k = 0; k < poses.Length; k++)
            {
                float3 point = random.NextFloat3(-1f, 1f),
                    wanted = poses[k].position + math.rotate(poses[k].rotation, point * poses[k].scale);
                Assert.That(math.distance(math.transform(job.instances.matrices[k], point), wanted), Is.LessThan(1e-4f));
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
                CrowdCullJob job = CullJob(new[] { pose });
                float reach = Shape.radius * pose.scale;
                float3 middle = pose.position + math.rotate(pose.rotation, Shape.centre * pose.scale);
                var planes = new Plane[6];
                planes[plane] = new Plane(normal, -math.dot(normal, middle) - 0.99f * reach);
                job.view = Behind(planes);
                Assert.That(Run(job).counts[0], Is.EqualTo(1), "still seen");
                planes[plane] = new Plane(normal, -math.dot(normal, middle) - 1.01f * reach);
                job.view = Behind(planes);
                Assert.That(Run(job).counts[0], Is.Zero, "beyond");
            }
        }

        [Test]
        public void InsectsWithoutSize_AreNotDrawn([Values(0f, float.NaN)] float scale)
        {
            var pose = CrowdPose.At(default, quaternion.identity);
            pose.scale = scale;
            CrowdCullJob job = CullJob(new[] { pose, CrowdPose.At(default, quaternion.identity) });

            Assert.That(Run(job).counts.ToArray(), Is.EqualTo(new[] { 1, 0, 0, 0 }));
        }

        [Test]
        public void TheMesh_IsTheSmallestThatIsFineEnough_ForTheHeightOnTheScreen([Values] bool perspective)
        {
            foreach (float height in new[] { 0.6f, 0.31f, 0.29f, 0.11f, 0.09f, 0.001f })
            {
                // The middle of the insect straight ahead of the eye, turned and twice as large.
                var pose = CrowdPose.At(default, quaternion.RotateY(1f));
                pose.scale = 2f;
                float reach = 2f * Shape.radius, away = perspective ? reach / (0.5f * height) : 4f;
                var eye = new float3(1f, 2f, 3f);
                pose.position = eye + new float3(0f, 0f, away) - math.rotate(pose.rotation, Shape.centre * pose.scale);
                CrowdCullJob job = CullJob(new[] { pose });
                job.view.eye = eye;
                job.view.halfHeight = perspective ? 0.5f : 0f;
                job.view.flatHeight = perspective ? 0f : reach / height;
                int size = height > 0.3f ? 0 : height > 0.1f ? 1 : 2;

                Assert.That(
                    Run(job).counts.ToArray(), Is.EqualTo(Enumerable.Range(0, 4).Select(k => k == size ? 1 : 0)), $"height {height}");
            }
        }

        [Test]
        public void EachMeshsInsects_StandTogether_WithoutThoseThatAreHidden()
        {
            // Far, near, middle, near, middle, far along Z; the second near one and the first far one are hidden, and one out of sight with
            // them.
            float[] aways = { 90f, 5f, 28f, 6f, 29f, 80f, -50f };
            CrowdPose[] poses = aways.Select(away => CrowdPose.At(new float3(0f, 0f, away), quaternion.identity)).ToArray();
            CrowdCullJob job = CullJob(new CrowdShape { radius = 3f }, poses, 3, 0, 6);
            job.view = Behind(new Plane(Vector3.forward, 0f));
            job.view.halfHeight = 1f;
            Run(job);

            Assert.That(job.counts.ToArray(), Is.EqualTo(new[] { 1, 2, 1, 0 }), "heights 0.6, 0.107 and 0.103, 0.0375");
            Assert.That(job.seen.ToArray().Take(4).Select(k => aways[k]), Is.EqualTo(new[] { 5f, 28f, 29f, 80f }));
        }

        [Test]
        public void TranslucentInsects_AreWrittenFromTheFarthestToTheNearest_OfEachMesh()
        {
            var random = new Random(21u);
            for (int trial = 0; trial < 10; trial++)
            {
                CrowdPose[] poses = Enumerable.Range(0, 200).Select(_ => Somewhere(ref random)).ToArray();
                CrowdCullJob job = CullJob(poses, 5);
                job.sorts = true;
                job.view = Behind(new Plane(Vector3.up, 1f));
                job.view.ahead = random.NextFloat3Direction();
                job.view.eye = random.NextFloat3(-2f, 2f);
                job.view.halfHeight = 2f;
                Run(job);

                float[] depths = job.spheres.ToArray()
                    .Select(sphere => math.dot(job.view.ahead, sphere.xyz - job.view.eye)).ToArray();
                float step = (depths.Max() - depths.Min()) / 65535f;
                int[] sorted = job.seen.ToArray(), counts = job.counts.ToArray();
                int first = 0;
                for (int size = 0; size < CrowdCullJob.MaxSizes; first += counts[size++])
                {
                    for (int k = first + 1; k < first + counts[size]; k++)
                        Assert.That(depths[sorted[k]], Is.LessThanOrEqualTo(depths[sorted[k - 1]] + 1.01f * step));
                }

                job.sorts = false;
                Run(job);
                Assert.That(job.counts.ToArray(), Is.EqualTo(counts));
                Assert.That(sorted.Take(first), Is.EquivalentTo(job.seen.ToArray().Take(first)), "the same insects");
                Assert.That(counts.Count(count => count > 0), Is.GreaterThan(1));
            }
        }

#if ENABLE_UNITY_COLLECTIONS_CHECKS
        private delegate void Edit(ref CrowdCullJob job);

        [Test]
        public void EachFieldOutOfRange_IsNamed_BeforeTheJobIsScheduled()
        {
            CrowdPose[] poses = { CrowdPose.At(default, quaternion.identity), CrowdPose.At(default, quaternion.identity) };
            Assert.That(() => CullJob(poses).Validate(), Throws.Nothing);
            Assert.That(() => CullJob(poses, 2).Validate(),
                Throws.ArgumentException.With.Message.EqualTo("CrowdCullJob.hidden is 2; it must be from 0 to 1."));
            foreach ((string said, Edit edit) in new (string, Edit)[]
            {
                ("loops has room for 0", (ref CrowdCullJob job) => job.loops = Empty<LoopRows>(0)),
                ("sizes has room for 1; the job needs 2.", (ref CrowdCullJob job) => job.sizes = Empty<byte>(1)),
                ("counts has", (ref CrowdCullJob job) => job.counts = Empty<int>(3)),
                ("seen has", (ref CrowdCullJob job) => job.seen = Empty<int>(1)),
                ("spheres has", (ref CrowdCullJob job) => job.spheres = Empty<float4>(1)),
                ("instances has", (ref CrowdCullJob job) => job.instances = Keep(new CrowdInstances(1))),
                ("order has", (ref CrowdCullJob job) =>
                {
                    job.sorts = true;
                    job.order = Keep(new CrowdOrder(1));
                }),
                ("sizeCount is 0", (ref CrowdCullJob job) => job.sizeCount = 0),
                ("sizeCount is 5", (ref CrowdCullJob job) => job.sizeCount = CrowdCullJob.MaxSizes + 1),
                ("hiddenCount is 2", (ref CrowdCullJob job) => job.hiddenCount = job.hidden.Length + 1),
                ("hiddenCount is -1", (ref CrowdCullJob job) => job.hiddenCount = -1),
            })
            {
                CrowdCullJob job = CullJob(poses);
                edit(ref job);
                Assert.That(() => job.Validate(), Throws.ArgumentException.With.Message.StartsWith($"CrowdCullJob.{said}"), said);
            }
        }

        [Test]
        public void TheEndsOfEachRange_AreWithinIt()
        {
            CrowdPose[] poses = { CrowdPose.At(default, quaternion.identity), CrowdPose.At(default, quaternion.identity) };
            foreach (Edit edit in new Edit[]
            {
                (ref CrowdCullJob job) => job.sizeCount = 1,
                (ref CrowdCullJob job) => job.sizeCount = CrowdCullJob.MaxSizes,
                (ref CrowdCullJob job) => (job.hidden, job.hiddenCount) = (Empty<int>(0), 0),
                (ref CrowdCullJob job) => (job.hidden, job.hiddenCount) = (Empty<int>(2), 2),
                (ref CrowdCullJob job) => job.loops = Empty<LoopRows>(1),
                (ref CrowdCullJob job) => job.sizes = Empty<byte>(2),
                (ref CrowdCullJob job) => job.counts = Empty<int>(CrowdCullJob.MaxSizes),
                (ref CrowdCullJob job) => job.seen = Empty<int>(2),
                (ref CrowdCullJob job) => job.order = Keep(new CrowdOrder(1)),
            })
            {
                CrowdCullJob job = CullJob(poses, 1);
                edit(ref job);
                Assert.That(() => job.Validate(), Throws.Nothing);
            }
        }

        [Test]
        public void EachFieldOfACallOutOfRange_IsNamed()
        {
            var pose = CrowdPose.At(default, quaternion.identity);
            CrowdCullJob culled = Run(CullJob(new[] { pose, pose }));
            Assert.That(() => GatherJob(culled, 0, 2).Validate(), Throws.Nothing);
            CrowdGatherJob job = GatherJob(culled, 1, 2);
            Assert.That(() => job.Validate(),
                Throws.ArgumentException.With.Message.EqualTo("CrowdGatherJob.start is 1; it must be from 0 to 0."));
            job = GatherJob(culled, 0, 2);
            job.count = 3;
            Assert.That(() => job.Validate(), Throws.ArgumentException.With.Message.StartsWith("CrowdGatherJob.count is 3"));
            job = GatherJob(culled, 0, 2);
            job.nextRows = Empty<float4>(1);
            Assert.That(() => job.Validate(), Throws.ArgumentException.With.Message.StartsWith("CrowdGatherJob.nextRows has room for 1"));
            job = GatherJob(culled, 0, 2);
            job.rows = Empty<float4>(1);
            Assert.That(() => job.Validate(), Throws.ArgumentException.With.Message.StartsWith("CrowdGatherJob.rows has room for 1"));
            job = GatherJob(culled, 0, 2);
            job.tints = Empty<float4>(1);
            Assert.That(() => job.Validate(), Throws.ArgumentException.With.Message.StartsWith("CrowdGatherJob.tints has room for 1"));
            job = GatherJob(culled, 0, 2);
            job.corners = Empty<float3>(1);
            Assert.That(() => job.Validate(), Throws.ArgumentException.With.Message.StartsWith("CrowdGatherJob.corners has room for 1"));
        }

        private NativeArray<T> Empty<T>(int length) where T : struct => Keep(new NativeArray<T>(length, Allocator.Persistent));
#endif

        private static CrowdCullJob Run(CrowdCullJob job)
        {
            job.Execute();
            return job;
        }
    }
}
