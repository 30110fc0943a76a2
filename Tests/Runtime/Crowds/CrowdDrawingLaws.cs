using System.Linq;
using Alate.Crowds;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests.Crowds
{
    /// <summary>Order, frames and sight of a crowd, against a sort, the frames that were asked for, and boxes.</summary>
    public sealed class CrowdDrawingLaws : CrowdJobFixture
    {
        [TestCase(0)]
        [TestCase(1)]
        [TestCase(2)]
        [TestCase(300)]
        [TestCase(2000)]
        public void TheFarthestIsFirst_AndEqualDepthsKeepTheirOrder(int count)
        {
            CrowdOrder order = Keep(new CrowdOrder(2000));
            Assert.That(order.Length, Is.EqualTo(2000));
            foreach ((float scale, int most) in new[] { (1f, 45000), (1e-3f, 500), (100f, 1) })
            {
                // Whole numbers within 65,535 are told from each other; of a few insects every other one is left out.
                var random = new Random(5u);
                float[] depths = Enumerable.Range(0, 2000).Select(_ => scale * random.NextInt(-most / 3, most)).ToArray();
                int[] added = Enumerable.Range(0, count).Select(k => count <= 1000 ? 2 * k : k).ToArray();
                order.Begin();
                foreach (int insect in added)
                    order.Add(insect, depths[insect]);
                order.SortFarthestFirst();

                int[] sorted = added.OrderByDescending(insect => depths[insect]).ToArray();
                Assert.That(order.Count, Is.EqualTo(count));
                Assert.That(Enumerable.Range(0, count).Select(place => order[place]), Is.EqualTo(sorted));
            }
        }

        // Frames in which a camera has seen the insect decide who makes it ready, and that it is made once a frame.
        [Test]
        public void AnInsect_IsMadeOnceAFrame_BeforehandWhereItWasSeen()
        {
            CrowdInstances instances = Keep(new CrowdInstances(2));
            NativeArray<LoopRows> loops = Keep(new NativeArray<LoopRows>(s_Loops, Allocator.Persistent));
            Assert.That(instances.Length, Is.EqualTo(2));
            Assert.That(Begun(1f), Is.Zero, "nobody has seen it");
            Assert.That(Seen(2f), Is.EqualTo(2f), "the first camera makes it");
            Assert.That(Seen(3f), Is.EqualTo(2f), "the second one finds it");
            Assert.That(Begun(4f), Is.EqualTo(4f), "it was seen in the last frame");
            Assert.That(Seen(5f), Is.EqualTo(4f));
            Assert.That(Begun(6f), Is.EqualTo(6f));
            Assert.That(Begun(7f), Is.EqualTo(6f), "nobody saw it in the last frame");
            Assert.That(Begun(8f), Is.EqualTo(6f));
            Assert.That(Seen(9f), Is.EqualTo(9f));
            Assert.That(instances.matrices[0], Is.EqualTo(default(float4x4)), "the other one");

            float Begun(float x)
            {
                instances.Begin(1, CrowdPose.At(new float3(x, 0f, 0f), quaternion.identity), loops);
                return instances.matrices[1].c3.x;
            }

            float Seen(float x)
            {
                instances.See(1, CrowdPose.At(new float3(x, 0f, 0f), quaternion.identity), loops);
                return instances.matrices[1].c3.x;
            }
        }

        [TestCase(-0.5f, 0f)]
        [TestCase(0f, 0f)]
        [TestCase(0.4f, 0.4f)]
        [TestCase(1.5f, 1f)]
        [TestCase(float.NaN, 0f)]
        public void TheShareOfTheNextLoop_IsOne(float blend, float share)
        {
            CrowdInstances instances = Keep(new CrowdInstances(1));
            var pose = CrowdPose.At(default, quaternion.identity);
            pose.blend = blend;
            instances.See(0, pose, Keep(new NativeArray<LoopRows>(s_Loops, Allocator.Persistent)));
            Assert.That((instances.rows[0].w, instances.nextRows[0].w), Is.EqualTo((share, 0f)));
        }

        [TestCase(0, 3)]
        [TestCase(1, 11)]
        [TestCase(2, 16)]
        [TestCase(3, 16)]
        [TestCase(-1, 16)]
        [TestCase(int.MinValue, 16)]
        public void ALoopThatThereIsNot_IsTheLast(int loop, int first) => Assert.That(
            LoopRows.Of(Keep(new NativeArray<LoopRows>(s_Loops, Allocator.Persistent)), loop).first, Is.EqualTo(first));

        // A box of half sides 1, 2 and 3: a ball reaches it where its middle, less its way, is beyond a side by its radius.
        [Test]
        public void ABall_MeetsABox_OnItsWay([Values(0, 1, 2)] int axis, [Values(-1f, 1f)] float side, [Values(0f, 4f)] float way)
        {
            var planes = new Plane[6];
            for (int k = 0; k < 6; k++)
            {
                Vector3 inwards = Vector3.zero;
                inwards[k / 2] = k % 2 == 0 ? 1f : -1f;
                planes[5 - k] = new Plane(inwards, 1f + k / 2);
            }

            var box = CrowdFrustum.Of(planes);
            float half = 1f + axis;
            foreach (float radius in new[] { 0.1f, 0.5f })
            {
                Assert.That(Meets(half + radius + way - 0.01f, radius), Is.True);
                Assert.That(Meets(half + radius + way + 0.01f, radius), Is.False);
                Assert.That(Meets(-half - radius + 0.01f, radius), Is.True, "away from it");
                Assert.That(Meets(-half - radius - 0.01f, radius), Is.False, "away from it");
            }

            bool Meets(float along, float radius)
            {
                var ball = new float4(0.3f, -0.2f, 0.1f, radius);
                float3 moved = default;
                ball[axis] = side * along;
                moved[axis] = -side * way;
                return box.MayMeet(ball, moved);
            }
        }

        // Between the loops' frequencies, by the share of the next; time may stand still or be no number.
        [TestCase(0.01f, 2f, 0.5f, 0.14f)]
        [TestCase(0f, 2f, 0.5f, 0f)]
        [TestCase(-0.01f, 1f, 0f, -0.1f)]
        [TestCase(0.01f, 1f, 1f, 0.04f)]
        public void APhase_GoesOnByTheMixtureOfItsLoops(float seconds, float rate, float blend, float further)
        {
            var pose = CrowdPose.At(default, quaternion.identity, 0.5f);
            (pose.rate, pose.blend, pose.nextLoop) = (rate, blend, 1);
            CrowdPose lost = pose;
            lost.phase = float.NaN;
            CrowdStepJob job = StepJob(new[] { pose, lost });
            job.seconds = seconds;
            job.Execute();
            Assert.That(job.poses[0].phase, Is.EqualTo(0.5f + further).Within(1e-6f));
            Assert.That(job.poses[1].phase, Is.Zero);
        }
    }
}
