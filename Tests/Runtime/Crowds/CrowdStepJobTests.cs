using System.Collections.Generic;
using System.Linq;
using Alate.Crowds;
using NUnit.Framework;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
using Unity.Collections;
#endif

namespace Alate.Tests.Crowds
{
    /// <summary>Phases of a crowd and its nearest insects, against closed forms and a sort.</summary>
    public sealed class CrowdStepJobTests : CrowdJobFixture
    {
        [Test]
        public void Phases_GoOnByTimeRateAndFrequency_AndStayBelowOne()
        {
            CrowdPose plain = CrowdPose.At(default, quaternion.identity, 0.3f), quick = plain, back = plain, blended = plain;
            quick.rate = 2.5f;
            back.rate = -1f;
            blended.nextLoop = 1;
            blended.blend = 0.25f;
            CrowdStepJob job = StepJob(new[] { plain, quick, back, blended });
            job.seconds = 0.07f;
            job.Execute();

            float[] wanted = { 0.3f + 0.7f - 1f, 0.3f + 1.75f - 2f, 0.3f - 0.7f + 1f, 0.3f + 0.07f * 8.5f };
            for (int k = 0; k < wanted.Length; k++)
            {
                Assert.That(job.poses[k].phase, Is.InRange(0f, 1f));
                Assert.That(Turn(job.poses[k].phase - wanted[k]), Is.LessThan(1e-5f), $"insect {k}");
            }
        }

        [Test]
        public void TheNearestInSight_AreRanked_AsASortRanksThem([Values(1, 3, 8, 30)] int ranked)
        {
            var random = new Random(9u);
            CrowdPose[] poses = Enumerable.Range(0, 24).Select(_ => Somewhere(ref random)).ToArray();
            poses[4].scale = 0f;
            CrowdStepJob job = StepJob(poses, ranked);
            job.view.eye = new float3(1f, -1f, 2f);
            job.Execute();

            float3 eye = job.view.eye;
            IEnumerable<int> sorted = Enumerable.Range(0, 24).Where(k => k != 4).OrderBy(k => math.distance(eye, poses[k].position));
            Assert.That(job.nearest.ToArray(), Is.EqualTo(sorted.Concat(Enumerable.Repeat(-1, 30)).Take(ranked)));
            job.Execute();
            Assert.That(job.nearest.ToArray(), Is.EqualTo(sorted.Concat(Enumerable.Repeat(-1, 30)).Take(ranked)),
                "nothing is left of the frame before");
        }

        [TestCase(0f, false)]
        [TestCase(float.NaN, false)]
        [TestCase(1f, true)]
        public void WhatHasNoSizeOrNoCamera_IsNotRanked(float scale, bool ranks)
        {
            var pose = CrowdPose.At(default, quaternion.identity);
            pose.scale = scale;
            CrowdStepJob job = StepJob(new[] { pose });
            job.ranks = ranks || scale != 1f;
            job.Execute();
            Assert.That(job.nearest[0], Is.EqualTo(ranks ? 0 : -1));

            job.ranks = false;
            job.Execute();
            Assert.That(job.nearest[0], Is.EqualTo(-1));
        }

#if ENABLE_UNITY_COLLECTIONS_CHECKS
        [Test]
        public void FieldsOutOfRange_AreNamed_BeforeTheJobIsScheduled()
        {
            CrowdPose[] poses = { CrowdPose.At(default, quaternion.identity), CrowdPose.At(default, quaternion.identity) };
            Assert.That(() => StepJob(poses).Validate(), Throws.Nothing);
            CrowdStepJob job = StepJob(poses);
            job.seconds = float.NaN;
            Assert.That(() => job.Validate(), Throws.ArgumentException.With.Message.StartsWith("CrowdStepJob.seconds is NaN"));
            job = StepJob(poses);
            job.shape.radius = -1f;
            Assert.That(() => job.Validate(), Throws.ArgumentException.With.Message.StartsWith("CrowdStepJob.radius is -1"));
            job = StepJob(poses);
            job.loops = Keep(new NativeArray<LoopRows>(0, Allocator.Persistent));
            Assert.That(() => job.Validate(), Throws.ArgumentException.With.Message.StartsWith("CrowdStepJob.loops has room for 0"));
            job = StepJob(poses);
            job.nearestDistances = Keep(new NativeArray<float>(job.nearest.Length - 1, Allocator.Persistent));
            Assert.That(() => job.Validate(), Throws.ArgumentException.With.Message.StartsWith("CrowdStepJob.nearestDistances has"));
            job = StepJob(poses);
            job.instances = Keep(new CrowdInstances(1));
            Assert.That(() => job.Validate(),
                Throws.ArgumentException.With.Message.EqualTo("CrowdStepJob.instances has room for 1; the job needs 2."));
            job = StepJob(poses);
            job.spheres = Keep(new NativeArray<float4>(1, Allocator.Persistent));
            Assert.That(() => job.Validate(), Throws.ArgumentException.With.Message.StartsWith("CrowdStepJob.spheres has room for 1"));
        }
#endif

        private static float Turn(float phase) => math.abs(phase - math.round(phase));
    }
}
