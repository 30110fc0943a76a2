using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using Alate.Catalogue;
using Alate.Crowds;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;
using Unity.StandIns;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Alate.Tests.Play.Headless
{
    /// <summary>Drawing of crowds: for which cameras, and its allocations.</summary>
    public sealed class InsectCrowdTests : CrowdFixture
    {
        [TearDown]
        public void UseThePlatformsDevice() => PlainDevice.IsInUse = false;

        [UnityTest]
        public IEnumerator EachInsect_IsDrawnWhereItIs_InThePhaseThatItHas()
        {
            Scene = new CrowdScene("monarch", 3, "cruise", "rest");
            Scene.Place(0, Held(CrowdPose.At(new float3(0f, 0f, 0f), quaternion.identity, 0.25f)));
            Scene.Place(1, Held(CrowdPose.At(new float3(2f, 1f, 0f), quaternion.RotateY(1f), 0.9f)));
            yield return null;
            DrawnInstances.Calls = new List<DrawnBatch>();
            yield return null;

            NativeArray<CrowdPose> poses = Scene.Crowd.Poses;
            DrawnBatch[] finest = DrawnInstances.Calls.Where(call => call.Matrices.Length == 2).ToArray();
            Assert.That(Scene.Crowd.DrawnCount, Is.EqualTo(2), "nobody has placed the third");
            Assert.That(finest, Has.Length.EqualTo(Scene.Baked.Materials.Count));
            int size = Array.FindIndex(Scene.Baked.Sizes.ToArray(), known => known.mesh == finest[0].Mesh);
            ReducedSurface reduced = ReducedSurface.Of(Scene.Bake, CrowdScene.Triangles)[size];
            var positions = new float3[Scene.Bake.Surface.VertexCount];
            for (int insect = 0; insect < 2; insect++)
            {
                CrowdPose pose = poses[insect];
                Scene.Bake.Clips[0].Evaluate(pose.phase, positions, new float3[positions.Length]);
                for (int k = 0; k < reduced.Vertices.Length; k += 7)
                {
                    float3 wanted = pose.position + math.rotate(pose.rotation, positions[reduced.Vertices[k]]);
                    Assert.That(math.distance(CrowdScene.Played(finest[0], insect, k), wanted), Is.LessThan(1e-3f * Scene.Bake.WingLength));
                }
            }
        }

        [UnityTest]
        public IEnumerator ALoopThatIsNone_IsTheLastOne()
        {
            int[] loops = [1, 2, 7, -1, int.MinValue, int.MaxValue];
            Scene = new CrowdScene("monarch", loops.Length, "cruise", "rest");
            for (int insect = 0; insect < loops.Length; insect++)
            {
                var pose = CrowdPose.At(default, quaternion.identity, 0.3f);
                pose.loop = pose.nextLoop = loops[insect];
                Scene.Place(insect, Held(pose));
            }

            yield return Frames(3);
            DrawnInstances.Calls = new List<DrawnBatch>();
            yield return null;

            DrawnBatch drawn = DrawnInstances.Calls.First(call => call.Matrices.Length == loops.Length);
            foreach (string rows in new[] { "_BakeRows", "_BakeNextRows" })
                Assert.That(drawn.Properties[rows].Take(loops.Length), Is.All.EqualTo(drawn.Properties[rows][0]), rows);
            Scene.Crowd.LivePrefab = Scene.Prefab;
            Scene.Crowd.LiveCount = loops.Length;
            int before = Resources.FindObjectsOfTypeAll<InsectWings>().Length;
            yield return Frames(3);
            Assert.That(
                Resources.FindObjectsOfTypeAll<InsectWings>(), Has.Length.EqualTo(before + loops.Length), "as many as are asked for");
            Scene.Crowd.LiveCount = 1;
            yield return Frames(2);
            Assert.That(Resources.FindObjectsOfTypeAll<InsectWings>(), Has.Length.EqualTo(before + 1));
        }

        [UnityTest]
        public IEnumerator APoseThatIsNone_IsNotDrawn_AndADrawnOneComesBack([Values(float.NaN, float.PositiveInfinity, 1e38f)] float value)
        {
            Scene = new CrowdScene("monarch", 5, "cruise");
            Scene.Crowd.LivePrefab = Scene.Prefab;
            Scene.Crowd.LiveCount = 5;
            for (int insect = 0; insect < 5; insect++)
                Scene.Place(insect, CrowdPose.At(default, quaternion.identity, 0.3f));
            yield return Frames(3);
            for (int insect = 0; insect < 5; insect++)
            {
                CrowdPose pose = Scene.Crowd.Poses[insect];
                switch (insect)
                {
                    case 0: pose.position.y = value; break;
                    case 1: pose.scale = value; break;
                    case 2: pose.rate = value; break;
                    case 3: pose.phase = value; break;
                    default: pose.blend = value; break;
                }

                Scene.Place(insect, pose);
            }

            yield return Frames(3);
            for (int insect = 0; insect < 5; insect++)
            {
                Assert.That(Scene.Crowd.Poses[insect].phase, Is.InRange(0f, 1f));
                CrowdPose again = Scene.Crowd.Poses[insect];
                Scene.Place(insect, CrowdPose.At(default, again.rotation, again.phase));
            }

            yield return Frames(2);
            Assert.That(Scene.Crowd.DrawnCount + Scene.Crowd.LiveNow, Is.EqualTo(5));
        }

        [UnityTest]
        public IEnumerator Phases_GoOnByTheLoopsFrequency()
        {
            Scene = new CrowdScene("monarch", 2, "cruise");
            Scene.Place(0, CrowdPose.At(default, quaternion.identity, 0.1f));
            var quick = CrowdPose.At(default, quaternion.identity, 0.1f);
            quick.rate = 2f;
            Scene.Place(1, quick);
            yield return Frames(7);

            float beats = 6f / 60f * Scene.Baked.Loops[0].frequency;
            Assert.That(Turn(Scene.Crowd.Poses[0].phase - 0.1f - beats), Is.LessThan(0.2f));
            Assert.That(Turn(Scene.Crowd.Poses[1].phase - Scene.Crowd.Poses[0].phase - beats), Is.LessThan(0.2f));
        }

        [UnityTest]
        public IEnumerator InsectsOutOfSight_AreNotDrawn_AndFarOnesTakeSmallerMeshes()
        {
            Scene = new CrowdScene("monarch", 400, "cruise");
            for (int k = 0; k < 400; k++)
                Scene.Place(k, CrowdPose.At(new float3(k % 20 - 10f, 0f, k / 20 * 10f - 50f), quaternion.identity, k / 400f));
            yield return null;
            DrawnInstances.Calls = new List<DrawnBatch>();
            yield return null;

            Plane[] planes = GeometryUtility.CalculateFrustumPlanes(Scene.Camera);
            float radius = Scene.Baked.Bounds.extents.magnitude;
            int seen = Enumerable.Range(0, 400).Count(k =>
                Array.TrueForAll(planes,
                    plane => plane.GetDistanceToPoint((Vector3)Scene.Crowd.Poses[k].position + Scene.Baked.Bounds.center) >= -radius));
            Assert.That(Scene.Crowd.DrawnCount, Is.EqualTo(seen).And.InRange(50, 350));
            Assert.That(DrawnInstances.Calls.Select(call => call.Mesh).Distinct().Count(), Is.EqualTo(3));
            float[] farthest = Scene.Baked.Sizes.Select(size =>
                DrawnInstances.Calls.First(call => call.Mesh == size.mesh).Matrices
                    .Max(matrix => Vector3.Distance(matrix.GetColumn(3), Scene.Camera.transform.position))).ToArray();
            Assert.That(farthest, Is.Ordered.Ascending);
            Assert.That(Scene.Crowd.DrawCalls, Is.EqualTo(DrawnInstances.Calls.Count));
        }

        [UnityTest]
        public IEnumerator TheNearest_AreLive_AndNothingJumpsAsTheySwap([Values("hover", "cruise")] string loop) => SwapIn("monarch", loop);

        [UnityTest]
        [Explicit]
        [Category("Long")]
        public IEnumerator TheNearestFireflies_AreLive_AndNothingJumpsAsTheySwap([Values("hover", "cruise")] string loop) =>
            SwapIn("firefly", loop);

        private IEnumerator SwapIn(string species, string loop)
        {
            Scene = new CrowdScene(species, 4, loop);
            return Swap();
        }

        [UnityTest]
        public IEnumerator WhereATurnWasFlownByTrims_NothingJumpsEither() => SwapFlown("turn-left");

        [UnityTest, Explicit, Category("Long")]
        public IEnumerator WhereOtherLoopsWereFlownByTrims_NothingJumpsEither(
            [Values("cruise", "hover", "climb", "turn-right")] string loop) => SwapFlown(loop);

        // Then the picture is between two steps of the wings.
        [UnityTest]
        public IEnumerator WhereFramesAreShorterThanSteps_NothingJumpsEither()
        {
            Time.captureDeltaTime = 1f / 80f;
            Scene = new CrowdScene("monarch", 4, "cruise");
            return Swap();
        }

        private IEnumerator SwapFlown(string loop)
        {
            Scene = new CrowdScene("monarch", InsectVariant.Flight, 4, loop);
            Assert.That(Scene.Baked.Loops[0].isFlown, Is.True);
            return Swap();
        }

        [UnityTest]
        public IEnumerator FramesWithThousands_MakeNoGarbage_AndTakeLittleMemory()
        {
            Scene = new CrowdScene("firefly", 10000, "cruise");
            for (int k = 0; k < 10000; k++)
                Scene.Place(k, CrowdPose.At(new float3(k % 100 - 50f, 0f, k / 100), quaternion.identity, k / 10000f));
            yield return Frames(5);
            long before = GC.GetAllocatedBytesForCurrentThread();
            for (int frame = 0; frame < 3; frame++)
            {
                Scene.Crowd.RunFrame(1f / 60f);
                Scene.Crowd.RunCamera(Scene.Camera);
            }

            long garbage = GC.GetAllocatedBytesForCurrentThread() - before;
            yield return Frames(2);

            Assert.That(garbage, Is.Zero);
            Assert.That(CrowdBuffers.BytesPerInsect, Is.LessThan(200));
            Assert.That(Scene.Crowd.DrawCalls, Is.LessThan(60));
        }

        [UnityTest]
        public IEnumerator OnADeviceWithoutInstancing_OneWarningSaysSo()
        {
            PlainDevice.IsInUse = true;
            LogAssert.Expect(LogType.Warning, new Regex("'crowd': This device draws no instances"));
            Scene = new CrowdScene("monarch", 4, "rest");
            yield return Frames(3);

            Assert.That(Scene.Crowd.Poses.IsCreated, Is.False);
            LogAssert.NoUnexpectedReceived();
        }

        [Test]
        public void AShaderThatShowsNoBakedWings_IsNamed()
        {
            InsectWings insect = InsectFactory.Create("monarch");
            Material material = Keep(new Material(Shader.Find("Standard")));
            try
            {
                foreach (Renderer renderer in insect.GetComponentsInChildren<Renderer>())
                    renderer.sharedMaterial = material;
                InsectBake bake = InsectBaker.Bake(insect, new[] { BakeMotion.Find("rest") }, BakeSettings.Default);

                Assert.That(() => BakedInsect.Create(bake), Throws.TypeOf<BakeException>().With.Message
                    .Contains("the shader 'Standard', which cannot show baked wings: use Alate/Wing"));
            }
            finally
            {
                Object.DestroyImmediate(insect.gameObject);
            }
        }

        private IEnumerator Swap()
        {
            CrowdLoop loop = Scene.Baked.Loops[0];
            for (int k = 0; k < 4; k++)
                Scene.Place(k, CrowdPose.At(new float3(0f, 0f, 4f * k), loop.attitude, 0.2f * k));
            Scene.Crowd.LivePrefab = Scene.Prefab;
            Scene.Crowd.LiveCount = 1;
            float largest = 0f;
            int swapped = -1;
            LateDeeds late = Scene.Crowd.gameObject.AddComponent<LateDeeds>();
            for (int frame = 0; frame < 150; frame++)
            {
                int now = frame;
                late.inLateUpdate = () =>
                {
                    InsectWings live = Scene.Crowd.LiveTwinOf(0);
                    if (live == null)
                        return;
                    swapped = swapped < 0 ? now : swapped;
                    largest = math.max(largest, Apart(live, Scene.Crowd.Poses[0].phase));
                };
                yield return null;
            }

            TestContext.Progress.WriteLine($"live against baked, {Scene.Prefab.name}, "
                + $"{loop.name}: {100f * largest:0.00} % of the wing length, first after {swapped} frames");
            Assert.That(swapped, Is.InRange(30, 120), "after the wings have settled");
            Assert.That(largest, Is.LessThan(5e-3f));
            Assert.That(Scene.Crowd.LiveNow, Is.EqualTo(1));
            Assert.That(Scene.Crowd.DrawnCount, Is.EqualTo(3));
        }

        // Largest distance of the live wings from the texture's, wing lengths.
        private float Apart(InsectWings live, float phase)
        {
            var positions = new float3[Scene.Bake.Surface.VertexCount];
            Scene.Bake.Clips[0].Evaluate(phase, positions, new float3[positions.Length]);
            float apart = 0f;
            for (int w = 0; w < live.Wings.Count; w++)
            {
                BakedWing wing = Scene.Bake.Wings[w];
                LiveWing flown = live.Live.wings[w];
                NativeArray<PackedVertex> vertices = WingSystem.Loop.World.PackedVertices(flown.handle);
                Matrix4x4 toInsect = live.transform.worldToLocalMatrix * flown.transform.localToWorldMatrix;
                int[] order = Order(live, w), ascending = order.OrderBy(v => v).ToArray();
                for (int k = 0; k < order.Length; k++)
                {
                    float3 baked = positions[wing.Vertices[Array.BinarySearch(ascending, order[k])]];
                    apart = math.max(apart, math.distance(baked, toInsect.MultiplyPoint3x4(vertices[k].position)) / wing.Length);
                }
            }

            return apart;
        }

        private static CrowdPose Held(CrowdPose pose)
        {
            pose.rate = 0f;
            return pose;
        }

        private static float Turn(float phase) => math.abs(phase - math.round(phase));
    }
}
