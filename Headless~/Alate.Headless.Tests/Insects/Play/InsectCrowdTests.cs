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
    /// <summary>What crowds draw, for whom, and what it costs.</summary>
    public sealed class InsectCrowdTests
    {
        private CrowdScene m_Scene;

        [SetUp]
        public void UseFixedFrames()
        {
            Time.captureDeltaTime = 1f / 60f;
            WingSystem.Patience = 0f;
        }

        [UnityTearDown]
        public IEnumerator TakeAway()
        {
            m_Scene?.Clear();
            m_Scene = null;
            PlainDevice.IsInUse = false;
            Time.captureDeltaTime = 0f;
            yield return CrowdScene.Frames(3);
        }

        [UnityTest]
        public IEnumerator EachInsect_IsDrawnWhereItIs_InThePhaseThatItHas()
        {
            m_Scene = new CrowdScene("monarch", 3, "cruise", "rest");
            m_Scene.Place(0, Held(CrowdPose.At(new float3(0f, 0f, 0f), quaternion.identity, 0.25f)));
            m_Scene.Place(1, Held(CrowdPose.At(new float3(2f, 1f, 0f), quaternion.RotateY(1f), 0.9f)));
            yield return null;
            DrawnInstances.Calls = new List<DrawnBatch>();
            yield return null;

            NativeArray<CrowdPose> poses = m_Scene.Crowd.Poses;
            DrawnBatch[] finest = DrawnInstances.Calls.Where(call => call.Matrices.Length == 2).ToArray();
            Assert.That(m_Scene.Crowd.DrawnCount, Is.EqualTo(2), "nobody has placed the third");
            Assert.That(finest, Has.Length.EqualTo(m_Scene.Baked.Materials.Count));
            int size = Array.FindIndex(m_Scene.Baked.Sizes.ToArray(), known => known.mesh == finest[0].Mesh);
            ReducedSurface reduced = ReducedSurface.Of(m_Scene.Bake, BakedInsect.DefaultTriangles)[size];
            var positions = new float3[m_Scene.Bake.Surface.VertexCount];
            for (int insect = 0; insect < 2; insect++)
            {
                CrowdPose pose = poses[insect];
                m_Scene.Bake.Clips[0].Evaluate(pose.phase, positions, new float3[positions.Length]);
                for (int k = 0; k < reduced.Vertices.Length; k += 7)
                {
                    float3 wanted = pose.position + math.rotate(pose.rotation, positions[reduced.Vertices[k]]);
                    Assert.That(math.distance(CrowdScene.Played(finest[0], insect, k), wanted), Is.LessThan(1e-3f * m_Scene.Bake.WingLength));
                }
            }
        }

        [UnityTest]
        public IEnumerator Phases_GoOnByTheLoopsFrequency()
        {
            m_Scene = new CrowdScene("monarch", 2, "cruise");
            m_Scene.Place(0, CrowdPose.At(default, quaternion.identity, 0.1f));
            var quick = CrowdPose.At(default, quaternion.identity, 0.1f);
            quick.rate = 2f;
            m_Scene.Place(1, quick);
            yield return CrowdScene.Frames(7);

            float beats = 6f / 60f * m_Scene.Baked.Loops[0].frequency;
            Assert.That(Turn(m_Scene.Crowd.Poses[0].phase - 0.1f - beats), Is.LessThan(0.2f));
            Assert.That(Turn(m_Scene.Crowd.Poses[1].phase - m_Scene.Crowd.Poses[0].phase - beats), Is.LessThan(0.2f));
        }

        [UnityTest]
        public IEnumerator InsectsOutOfSight_AreNotDrawn_AndFarOnesTakeSmallerMeshes()
        {
            m_Scene = new CrowdScene("monarch", 400, "cruise");
            for (int k = 0; k < 400; k++)
                m_Scene.Place(k, CrowdPose.At(new float3(k % 20 - 10f, 0f, k / 20 * 10f - 50f), quaternion.identity, k / 400f));
            yield return null;
            DrawnInstances.Calls = new List<DrawnBatch>();
            yield return null;

            Plane[] planes = GeometryUtility.CalculateFrustumPlanes(m_Scene.Camera);
            float radius = m_Scene.Baked.Bounds.extents.magnitude;
            int seen = Enumerable.Range(0, 400).Count(k =>
                Array.TrueForAll(planes, plane => plane.GetDistanceToPoint((Vector3)m_Scene.Crowd.Poses[k].position + m_Scene.Baked.Bounds.center) >= -radius));
            Assert.That(m_Scene.Crowd.DrawnCount, Is.EqualTo(seen).And.InRange(50, 350));
            Assert.That(DrawnInstances.Calls.Select(call => call.Mesh).Distinct().Count(), Is.EqualTo(3));
            float[] farthest = m_Scene.Baked.Sizes.Select(size =>
                DrawnInstances.Calls.First(call => call.Mesh == size.mesh).Matrices.Max(matrix => Vector3.Distance(matrix.GetColumn(3), m_Scene.Camera.transform.position))).ToArray();
            Assert.That(farthest, Is.Ordered.Ascending);
            Assert.That(m_Scene.Crowd.DrawCalls, Is.EqualTo(DrawnInstances.Calls.Count));
        }

        [UnityTest]
        public IEnumerator TheNearest_AreLive_AndNothingJumpsAsTheySwap([Values("hover", "cruise")] string loop) => SwapIn("monarch", loop);

        [UnityTest]
        [Explicit]
        [Category("Long")]
        public IEnumerator TheNearestFireflies_AreLive_AndNothingJumpsAsTheySwap([Values("hover", "cruise")] string loop) => SwapIn("firefly", loop);

        private IEnumerator SwapIn(string species, string loop)
        {
            m_Scene = new CrowdScene(species, 4, loop);
            return Swap();
        }

        [UnityTest]
        public IEnumerator WhereATurnWasFlownByTrims_NothingJumpsEither() => SwapFlown("turn-left");

        [UnityTest, Explicit, Category("Long")]
        public IEnumerator WhereOtherLoopsWereFlownByTrims_NothingJumpsEither([Values("cruise", "hover", "climb", "turn-right")] string loop) => SwapFlown(loop);

        private IEnumerator SwapFlown(string loop)
        {
            m_Scene = new CrowdScene("monarch", InsectVariant.Flight, 4, loop);
            Assert.That(m_Scene.Baked.Loops[0].isFlown, Is.True);
            return Swap();
        }

        [UnityTest]
        public IEnumerator FramesWithThousands_MakeNoGarbage_AndTakeLittleMemory()
        {
            m_Scene = new CrowdScene("firefly", 10000, "cruise");
            for (int k = 0; k < 10000; k++)
                m_Scene.Place(k, CrowdPose.At(new float3(k % 100 - 50f, 0f, k / 100), quaternion.identity, k / 10000f));
            yield return CrowdScene.Frames(5);
            long before = GC.GetAllocatedBytesForCurrentThread();
            for (int frame = 0; frame < 3; frame++)
                m_Scene.Crowd.RunFrame(1f / 60f);
            long garbage = GC.GetAllocatedBytesForCurrentThread() - before;

            Assert.That(garbage, Is.Zero);
            Assert.That(CrowdBuffers.BytesPerInsect, Is.LessThan(200));
            Assert.That(m_Scene.Crowd.DrawCalls, Is.LessThan(60));
        }

        [UnityTest]
        public IEnumerator OnADeviceWithoutInstancing_OneWarningSaysSo()
        {
            PlainDevice.IsInUse = true;
            LogAssert.Expect(LogType.Warning, new Regex("'crowd': This device draws no instances"));
            m_Scene = new CrowdScene("monarch", 4, "rest");
            yield return CrowdScene.Frames(3);

            Assert.That(m_Scene.Crowd.Poses.IsCreated, Is.False);
            LogAssert.NoUnexpectedReceived();
        }

        [Test]
        public void AShaderThatShowsNoBakedWings_IsNamed()
        {
            InsectWings insect = InsectFactory.Create("monarch");
            try
            {
                InsectBake bake = InsectBaker.Bake(insect, new[] { BakeMotion.Find("rest") }, BakeSettings.Default);

                Assert.That(() => BakedInsect.Create(bake), Throws.TypeOf<BakeException>().With.Message.Contains("the shader 'Standard', which cannot show baked wings: use Alate/Wing"));
            }
            finally
            {
                Object.DestroyImmediate(insect.gameObject);
            }
        }

        private IEnumerator Swap()
        {
            CrowdLoop loop = m_Scene.Baked.Loops[0];
            for (int k = 0; k < 4; k++)
                m_Scene.Place(k, CrowdPose.At(new float3(0f, 0f, 4f * k), loop.attitude, 0.2f * k));
            m_Scene.Crowd.LivePrefab = m_Scene.Prefab;
            m_Scene.Crowd.LiveCount = 1;
            float largest = 0f;
            int swapped = -1;
            LateDeeds late = m_Scene.Crowd.gameObject.AddComponent<LateDeeds>();
            for (int frame = 0; frame < 150; frame++)
            {
                int now = frame;
                late.inLateUpdate = () =>
                {
                    InsectWings live = m_Scene.Crowd.LiveTwinOf(0);
                    if (live == null)
                        return;
                    swapped = swapped < 0 ? now : swapped;
                    largest = math.max(largest, Apart(live, m_Scene.Crowd.Poses[0].phase));
                };
                yield return null;
            }

            TestContext.Progress.WriteLine($"live against baked, {m_Scene.Prefab.name}, {loop.name}: {100f * largest:0.00} % of the wing length, first after {swapped} frames");
            Assert.That(swapped, Is.InRange(30, 120), "after the wings have settled");
            Assert.That(largest, Is.LessThan(5e-3f));
            Assert.That(m_Scene.Crowd.LiveNow, Is.EqualTo(1));
            Assert.That(m_Scene.Crowd.DrawnCount, Is.EqualTo(3));
        }

        // Largest distance of the live wings from the texture's, wing lengths.
        private float Apart(InsectWings live, float phase)
        {
            var positions = new float3[m_Scene.Bake.Surface.VertexCount];
            m_Scene.Bake.Clips[0].Evaluate(phase, positions, new float3[positions.Length]);
            float apart = 0f;
            for (int w = 0; w < live.Wings.Count; w++)
            {
                BakedWing wing = m_Scene.Bake.Wings[w];
                LiveWing flown = live.Live.wings[w];
                NativeArray<PackedVertex> vertices = WingSystem.Crowd.World.PackedVertices(flown.handle);
                Matrix4x4 toInsect = live.transform.worldToLocalMatrix * flown.transform.localToWorldMatrix;
                for (int k = 0; k < wing.Vertices.Length; k++)
                    apart = math.max(apart, math.distance(positions[wing.Vertices[k]], toInsect.MultiplyPoint3x4(vertices[k].position)) / wing.Length);
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
