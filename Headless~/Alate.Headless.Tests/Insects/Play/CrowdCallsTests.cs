using System.Collections;
using System.Collections.Generic;
using System.Linq;
using Alate.Crowds;
using NUnit.Framework;
using Unity.Mathematics;
using Unity.StandIns;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace Alate.Tests.Play.Headless
{
    /// <summary>Calls of a crowd that is larger than one, is switched off and on, or becomes translucent.</summary>
    public sealed class CrowdCallsTests : CrowdFixture
    {
        [TearDown]
        public void UseTheBuiltInPipeline() => DrawnCameras.ByAPipeline = false;

        [UnityTest]
        public IEnumerator EachInsect_IsInOneCall_AndCallsAreAsLargeAsTheyMayBe()
        {
            const int count = 1100;
            Scene = new CrowdScene("monarch", count, "rest");
            for (int k = 0; k < count; k++)
                Scene.Place(k, CrowdPose.At(new float3(0.002f * (k - count / 2), 0f, 200f), quaternion.identity));
            yield return null;
            for (int frame = 0; frame < 2; frame++)
            {
                DrawnInstances.Calls = new List<DrawnBatch>();
                yield return null;
                int parts = DrawnInstances.Calls.Select(call => call.Submesh).Distinct().Count();
                var first = DrawnInstances.Calls.Where(call => call.Submesh == 0).ToList();
                Assert.That(first.Select(call => call.Matrices.Length), Is.EqualTo(new[] { 500, 500, 100 }));
                Assert.That(first.SelectMany(call => call.Matrices).Select(matrix => matrix.m03).Distinct().Count(), Is.EqualTo(count));
                Assert.That(Scene.Crowd.DrawCalls, Is.EqualTo(3 * parts));
                Assert.That(Scene.Crowd.DrawnCount, Is.EqualTo(count));
                Assert.That(Scene.Crowd.Triangles, Is.EqualTo((long)count * Scene.Baked.Sizes[Scene.Baked.Sizes.Count - 1].triangles));
                Assert.That(DrawnInstances.Calls.Select(call => call.Parameters.receiveShadows), Is.All.True);
                foreach (DrawnBatch call in DrawnInstances.Calls)
                    Assert.That(call.Material, Is.SameAs(Scene.Baked.Materials[call.Submesh]));
            }
        }

        [UnityTest]
        public IEnumerator ACrowdThatWasOff_IsDrawnOnce_WhoeverTellsOfCameras([Values] bool byAPipeline)
        {
            DrawnCameras.ByAPipeline = byAPipeline;
            Scene = new CrowdScene("monarch", 2, "rest");
            for (int round = 0; round < 3; round++)
            {
                for (int k = 0; k < 2; k++)
                    Scene.Place(k, CrowdPose.At(new float3(k, 0f, 0f), quaternion.identity));
                yield return null;
                DrawnInstances.Calls = new List<DrawnBatch>();
                yield return null;
                Assert.That(DrawnInstances.Calls.Where(call => call.Submesh == 0).Sum(call => call.Matrices.Length), Is.EqualTo(2));
                Assert.That(Scene.Crowd.DrawnCount, Is.EqualTo(2));
                Scene.Crowd.enabled = false;
                Assert.That((Scene.Crowd.DrawnCount, Scene.Crowd.DrawCalls, Scene.Crowd.Triangles, Scene.Crowd.LiveNow),
                    Is.EqualTo((0, 0, 0L, 0)));
                Scene.Crowd.enabled = true;
            }
        }

        // Unity draws queues up to 2500 from the front, those above from the back.
        [TestCase(2000, false)]
        [TestCase(2500, false)]
        [TestCase(2501, true)]
        [TestCase(3000, true)]
        public void ACrowd_IsSorted_WhereAMaterialIsDrawnFromTheBack(int queue, bool isTranslucent)
        {
            Scene = new CrowdScene("monarch", 1, "rest");
            Scene.Baked.Materials[Scene.Baked.Materials.Count - 1].renderQueue = queue;
            var buffers = new CrowdBuffers(7, 3, Scene.Baked);
            Assert.That(buffers.IsTranslucent, Is.EqualTo(isTranslucent));
            Assert.That(buffers.order.Length, Is.EqualTo(isTranslucent ? 7 : 1));
            Scene.Baked.Materials[Scene.Baked.Materials.Count - 1].renderQueue = (int)RenderQueue.Geometry;
            Assert.That(buffers.Fits(7, Scene.Baked), Is.True);
            Assert.That(buffers.IsTranslucent, Is.False);
            foreach (int other in new[] { 0, 6, 8 })
                Assert.That(buffers.Fits(other, Scene.Baked), Is.False);
            Assert.That(buffers.Fits(7, null), Is.False);
            Assert.That((buffers.nearest.Length, buffers.nearestDistances.Length), Is.EqualTo((3, 3)));
            buffers.SetMotion(true);
            Assert.That((buffers.instances.Moves, buffers.instances.Length), Is.EqualTo((true, 7)));
            buffers.SetMotion(false);
            Assert.That((buffers.instances.Moves, buffers.instances.Length), Is.EqualTo((false, 7)));
            buffers.Dispose();
        }

        [Test]
        public void LiveInsects_AreNoughtToSixtyFour_AndSpeedsOfASpawnerAreInOrder()
        {
            InsectCrowd crowd = Keep(new GameObject("crowd")).AddComponent<InsectCrowd>();
            foreach ((int set, int kept) in new[] { (-1, 0), (0, 0), (5, 5), (64, 64), (65, 64), (int.MaxValue, 64) })
            {
                crowd.LiveCount = set;
                Assert.That(crowd.LiveCount, Is.EqualTo(kept));
            }

            CrowdSpawner spawner = crowd.gameObject.AddComponent<CrowdSpawner>();
            spawner.Speeds = new Vector2(2f, 0.5f);
            Assert.That(spawner.Speeds, Is.EqualTo(new Vector2(0.5f, 2f)));
            spawner.Loop = null;
            Assert.That(spawner.Loop, Is.Empty);
            FlockCrowd flock = crowd.gameObject.AddComponent<FlockCrowd>();
            float usual = flock.Distance;
            (flock.Distance, flock.Group) = (float.NaN, 3);
            Assert.That((flock.Distance, flock.Group), Is.EqualTo((usual, 3)));
            flock.Distance = 12f;
            Assert.That(flock.Distance, Is.EqualTo(12f));
        }
    }
}
