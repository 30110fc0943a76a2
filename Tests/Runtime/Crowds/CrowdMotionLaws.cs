using Alate.Crowds;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;

namespace Alate.Tests.Crowds
{
    /// <summary>Matrices and rows that the shader read of an insect in the last frame, for motion vectors.</summary>
    public sealed class CrowdMotionLaws : CrowdJobFixture
    {
        [Test]
        public void TheLastFrame_IsThatInWhichACameraSawIt_OrThisOne()
        {
            CrowdInstances instances = Keep(new CrowdInstances(2, true));
            NativeArray<LoopRows> loops = Keep(new NativeArray<LoopRows>(s_Loops, Allocator.Persistent));
            Assert.That(instances.Moves, Is.True);
            Begin(1f);
            Assert.That(Seen(1f), Is.EqualTo((1f, 1f)), "the first picture");
            Begin(2f);
            Assert.That(Seen(2f), Is.EqualTo((2f, 1f)));
            Assert.That(Seen(2f), Is.EqualTo((2f, 1f)), "a second camera");
            Begin(3f);
            Assert.That(Seen(3f), Is.EqualTo((3f, 2f)));
            Begin(4f);
            Begin(5f);
            Assert.That(Seen(5f), Is.EqualTo((5f, 5f)), "nobody saw it in the last frame");
            Begin(6f);
            Assert.That(Seen(6f), Is.EqualTo((6f, 5f)));
            Assert.That(instances.lastMatrices[0], Is.EqualTo(default(float4x4)), "the other one");

            void Begin(float x) => instances.Begin(1, Pose(x), loops);

            (float, float) Seen(float x)
            {
                instances.See(1, Pose(x), loops);
                float3 rows = LoopRows.Of(loops, 0).At(Pose(instances.lastMatrices[1].c3.x).phase);
                float3 next = LoopRows.Of(loops, 1).At(Pose(instances.lastMatrices[1].c3.x).phase);
                Assert.That(instances.lastRows[1], Is.EqualTo(new float4(rows, 0.25f)));
                Assert.That(instances.lastNextRows[1], Is.EqualTo(new float4(next, 1f)), "known");
                return (instances.matrices[1].c3.x, instances.lastMatrices[1].c3.x);
            }
        }

        [Test]
        public void WithoutMotion_NothingIsKept()
        {
            CrowdInstances instances = Keep(new CrowdInstances(2));
            NativeArray<LoopRows> loops = Keep(new NativeArray<LoopRows>(s_Loops, Allocator.Persistent));
            instances.See(1, Pose(1f), loops);
            instances.Begin(1, Pose(2f), loops);
            Assert.That(instances.Moves, Is.False);
            Assert.That((instances.lastMatrices.Length, instances.lastRows.Length, instances.lastNextRows.Length), Is.EqualTo((0, 0, 0)));
        }

        [Test]
        public void ACall_HasEachMatrixBeforeItsLast()
        {
            CrowdCullJob culled = CullJob(new[] { Pose(1f), Pose(2f), Pose(3f) });
            culled.instances = Keep(new CrowdInstances(3, true));
            culled.Execute();
            for (int insect = 0; insect < 3; insect++)
                culled.instances.Begin(insect, Pose(11f + insect), culled.loops);
            CrowdGatherJob job = GatherJob(culled, 1, 2);
            job.moves = true;
            Assert.That(() => job.Validate(), Throws.ArgumentException.With.Message.StartsWith("CrowdGatherJob.count is 2"));
            job.matrices = Keep(new NativeArray<float4x4>(4, Allocator.Persistent));
            Assert.That(() => job.Validate(), Throws.ArgumentException.With.Message.StartsWith("CrowdGatherJob.lastRows has room for 0"));
            job.lastRows = Keep(new NativeArray<float4>(2, Allocator.Persistent));
            Assert.That(
                () => job.Validate(), Throws.ArgumentException.With.Message.StartsWith("CrowdGatherJob.lastNextRows has room for 0"));
            job.lastNextRows = Keep(new NativeArray<float4>(2, Allocator.Persistent));
            job.Validate();
            job.Execute();

            for (int k = 0; k < 2; k++)
            {
                Assert.That((job.matrices[2 * k].c3.x, job.matrices[2 * k + 1].c3.x), Is.EqualTo((12f + k, 2f + k)));
                Assert.That(job.rows[k], Is.EqualTo(culled.instances.rows[1 + k]));
                Assert.That(job.lastRows[k], Is.EqualTo(culled.instances.lastRows[1 + k]));
                Assert.That(job.lastNextRows[k], Is.EqualTo(culled.instances.lastNextRows[1 + k]));
            }
        }

        // Place, phase and share go with one number.
        private static CrowdPose Pose(float x)
        {
            var pose = CrowdPose.At(new float3(x, 0f, 0f), quaternion.identity, math.frac(0.137f * x));
            pose.nextLoop = 1;
            pose.blend = 0.25f;
            return pose;
        }
    }
}
