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
using Object = UnityEngine.Object;

namespace Alate.Tests.Play.Headless
{
    /// <summary>Crowds before several cameras: each draws what it sees from where it is when it begins to.</summary>
    public sealed class CrowdCamerasTests : CrowdFixture
    {
        private readonly List<GameObject> m_Made = new List<GameObject>();

        [TearDown]
        public void RemoveCameras()
        {
            DrawnCameras.ByAPipeline = false;
            RenderSettings.sun = null;
            m_Made.ForEach(Object.DestroyImmediate);
            m_Made.Clear();
        }

        [UnityTest]
        public IEnumerator EachCamera_DrawsItsOwnInsects_ForItselfAlone([Values] bool byAPipeline)
        {
            DrawnCameras.ByAPipeline = byAPipeline;
            MakeARing();
            Camera back = AddCamera(Quaternion.Euler(0f, 180f, 0f));
            yield return Draw();

            int[] ahead = DrawnFor(Scene.Camera), behind = DrawnFor(back);
            Assert.That(ahead, Is.EquivalentTo(new[] { 32, 33, 34, 35, 0, 1, 2, 3, 4 }), "60 degrees high and 16:9 is 45.7 to a side");
            Assert.That(behind, Is.EquivalentTo(ahead.Select(k => (k + 18) % 36)), "the ring, turned by half");
            Assert.That(Scene.Crowd.DrawnCount, Is.EqualTo(ahead.Length + behind.Length));
            Assert.That(Scene.Crowd.DrawCalls, Is.EqualTo(DrawnInstances.Calls.Count));
        }

        [UnityTest]
        public IEnumerator ACamera_DrawsFromWhereItHasMovedTo_InTheSameFrame()
        {
            MakeARing();
            yield return Draw();
            int[] before = DrawnFor(Scene.Camera);
            Scene.Camera.gameObject.AddComponent<LateDeeds>().inLateUpdate =
                () => Scene.Camera.transform.rotation = Quaternion.Euler(0f, 90f, 0f);
            yield return Draw();
            Assert.That(DrawnFor(Scene.Camera), Is.EquivalentTo(before.Select(k => (k + 9) % 36)));
        }

        [UnityTest]
        public IEnumerator Cameras_WithoutTheLayer_OfPreviewsAndOfOtherScenes_DrawNothing()
        {
            MakeARing();
            Camera blind = AddCamera(Quaternion.identity), preview = AddCamera(Quaternion.identity), stage = AddCamera(Quaternion.identity);
            Scene.Crowd.gameObject.layer = 4;
            blind.cullingMask = ~(1 << 4);
            preview.cameraType = CameraType.Preview;
            stage.overrideSceneCullingMask = 1;
            yield return Draw();

            Assert.That(DrawnInstances.Calls.Select(call => call.Camera).Distinct(), Is.EqualTo(new[] { Scene.Camera }));
            Assert.That(DrawnInstances.Calls.Select(call => call.Parameters.layer).Distinct(), Is.EqualTo(new[] { 4 }));
            stage.overrideSceneCullingMask = Scene.Crowd.gameObject.sceneCullingMask;
            yield return Draw();
            Assert.That(DrawnFor(stage), Is.EqualTo(DrawnFor(Scene.Camera)));
        }

        [UnityTest]
        public IEnumerator AProbesCamera_DrawsOnceAFrame_WhicheverSidesItTurnsTo()
        {
            MakeARing();
            Camera probe = AddCamera(Quaternion.identity);
            probe.cameraType = CameraType.Reflection;
            probe.enabled = false;
            Scene.Camera.enabled = false;
            for (int frame = 0; frame < 2; frame++)
            {
                yield return Draw();
                for (int side = 0; side < 4; side++)
                {
                    probe.transform.rotation = Quaternion.Euler(0f, 90f * side, 0f);
                    DrawnCameras.Draw(probe);
                }

                Assert.That(DrawnFor(probe), Is.EquivalentTo(Enumerable.Range(0, 36)));
            }
        }

        [UnityTest]
        public IEnumerator InsectsAboveThePicture_AreDrawn_WhereTheSunThrowsTheirShadowsIntoIt()
        {
            MakeARing();
            for (int k = 0; k < 36; k++)
                Scene.Place(k, CrowdPose.At(new float3(k % 2 == 0 ? 0f : 200f, 60f, 5f + k), quaternion.identity));
            Light sun = new GameObject("sun").AddComponent<Light>();
            m_Made.Add(sun.gameObject);
            sun.type = LightType.Directional;
            sun.shadows = LightShadows.Soft;
            sun.transform.rotation = Quaternion.LookRotation(Vector3.down);
            RenderSettings.sun = sun;
            yield return Draw();
            Assert.That(DrawnFor(Scene.Camera), Is.Empty);

            typeof(InsectCrowd).GetField("m_Shadows", System.Reflection.BindingFlags.NonPublic | System.Reflection.BindingFlags.Instance)
                .SetValue(Scene.Crowd, ShadowCastingMode.On);
            yield return Draw();
            Assert.That(DrawnFor(Scene.Camera), Is.EquivalentTo(Enumerable.Range(0, 36).Where(k => k % 2 == 0)));
            Assert.That(DrawnInstances.Calls.Select(call => call.Parameters.shadowCastingMode), Is.All.EqualTo(ShadowCastingMode.On));
        }

        [UnityTest]
        public IEnumerator RenderingLayers_AreThoseOfTheComponent_AndADisabledCrowdIsNotDrawn()
        {
            MakeARing();
            Scene.Crowd.RenderingLayers = 6;
            yield return Draw();
            Assert.That(DrawnInstances.Calls.Select(call => call.Parameters.renderingLayerMask), Is.Not.Empty.And.All.EqualTo(6u));
            Scene.Crowd.enabled = false;
            yield return Draw();
            Assert.That(DrawnInstances.Calls, Is.Empty);
            Assert.That(Scene.Crowd.DrawnCount, Is.Zero);
        }

        [UnityTest]
        public IEnumerator ABoxOfACall_HoldsItsInsects_AndIsFinite()
        {
            MakeARing();
            yield return Draw();
            foreach (DrawnBatch call in DrawnInstances.Calls)
            {
                Bounds box = call.Parameters.worldBounds;
                Assert.That(box.extents.magnitude, Is.InRange(0.1f, 40f));
                foreach (Matrix4x4 insect in call.Matrices)
                    Assert.That(box.Contains(insect.MultiplyPoint3x4(Scene.Baked.Bounds.center)), Is.True);
            }
        }

        [UnityTest]
        public IEnumerator TranslucentCrowds_AreDrawnFromTheFarthest()
        {
            MakeARing();
            Scene.Baked.Materials[0].renderQueue = (int)RenderQueue.Transparent;
            yield return Draw();
            foreach (DrawnBatch call in DrawnInstances.Calls)
                Assert.That(call.Matrices.Select(insect => insect.GetColumn(3).z), Is.Ordered.Descending);
            Assert.That(DrawnInstances.Calls.Max(call => call.Matrices.Length), Is.GreaterThan(3));
        }

        [TestCase(65536, false, 500)]
        [TestCase(65536, true, 250)]
        [TestCase(16384, false, 128)]
        [TestCase(1024, false, 125)]
        [TestCase(0, false, 500)]
        [TestCase(0, true, 250)]
        public void ACall_HasAsManyInsectsAsTheDeviceBinds(int bytes, bool isHalf, int insects) =>
            Assert.That(CrowdBatches.BatchFor(bytes, isHalf), Is.EqualTo(insects));

        // 36 insects around the camera, 10 degrees apart, from straight ahead to the right.
        private void MakeARing()
        {
            Scene = new CrowdScene("monarch", 36, "cruise");
            Scene.Camera.transform.position = Vector3.zero;
            for (int k = 0; k < 36; k++)
            {
                float turn = math.radians(10f * k);
                Scene.Place(k, CrowdPose.At(20f * new float3(math.sin(turn), 0f, math.cos(turn)), quaternion.RotateY(turn)));
            }
        }

        private Camera AddCamera(Quaternion turned)
        {
            var eye = new GameObject("another");
            m_Made.Add(eye);
            eye.transform.rotation = turned;
            return eye.AddComponent<Camera>();
        }

        private IEnumerator Draw()
        {
            yield return null;
            DrawnInstances.Calls = new List<DrawnBatch>();
            yield return null;
        }

        // Numbers of the insects that were drawn for a camera, by their places.
        private int[] DrawnFor(Camera eye) => DrawnInstances.Calls
            .Where(call => call.Camera == eye && call.Submesh == 0)
            .SelectMany(call => call.Matrices)
            .Select(matrix => Enumerable.Range(0, 36).Single(
                k => Vector3.Distance(Scene.Crowd.Poses[k].position, matrix.GetColumn(3)) < 1e-3f))
            .ToArray();
    }
}
