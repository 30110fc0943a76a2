using System;
using System.Collections;
using System.Linq;
using System.Reflection;
using Alate.Crowds;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.SceneManagement;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Alate.Tests.Play.Headless
{
    /// <summary>Changes of a crowd, its asset and its scene while it is drawn.</summary>
    public sealed class CrowdChangesTests : CrowdFixture
    {
        [UnityTest]
        public IEnumerator ACountOfTheInspector_ActsWhilePlaying([Values(1, 5)] int count)
        {
            Scene = new CrowdScene("monarch", 3, "cruise");
            for (int k = 0; k < 3; k++)
                Scene.Place(k, CrowdPose.At(new float3(k, 0f, 0f), quaternion.identity));
            yield return Frames(2);
            Assert.That(Scene.Crowd.DrawnCount, Is.EqualTo(3));
            Write("m_Count", count);
            yield return Frames(2);
            Assert.That((Scene.Crowd.Poses.Length, Scene.Crowd.DrawnCount), Is.EqualTo((count, 0)));
            Scene.Place(count - 1, CrowdPose.At(default, quaternion.identity));
            yield return Frames(2);
            Assert.That(Scene.Crowd.DrawnCount, Is.EqualTo(1));
        }

        [UnityTest]
        public IEnumerator AnAssetThatIsDeletedWhilePlaying_IsToldOnce_AndNothingIsDrawn()
        {
            Scene = new CrowdScene("monarch", 1, "cruise");
            Scene.Place(0, CrowdPose.At(default, quaternion.identity));
            yield return Frames(2);
            LogAssert.Expect(LogType.Warning, "'crowd': No baked insect is assigned.");
            BakedInsect gone = Object.Instantiate(Scene.Baked);
            Scene.Crowd.Insect = gone;
            yield return Frames(2);
            Scene.Place(0, CrowdPose.At(default, quaternion.identity));
            yield return Frames(2);
            Assert.That(Scene.Crowd.DrawnCount, Is.EqualTo(1));
            Object.DestroyImmediate(gone);
            yield return Frames(5);
            Assert.That((Scene.Crowd.DrawnCount, Scene.Crowd.Poses.IsCreated), Is.EqualTo((0, false)));
            LogAssert.NoUnexpectedReceived();
            Scene.Crowd.Insect = Scene.Baked;
            Assert.That(Scene.Crowd.Poses.Length, Is.EqualTo(1));
        }

        [UnityTest]
        public IEnumerator LoopsThatAreBakedAgain_ArePlayed_AndPosesStay()
        {
            Scene = new CrowdScene("monarch", 1, "cruise");
            Scene.Place(0, CrowdPose.At(new float3(1f, 0f, 0f), quaternion.identity));
            yield return Frames(2);
            FieldInfo loops = typeof(BakedInsect).GetField("m_Loops", BindingFlags.NonPublic | BindingFlags.Instance);
            CrowdLoop slower = ((CrowdLoop[])loops.GetValue(Scene.Baked))[0];
            slower.frequency = 0.5f;
            loops.SetValue(Scene.Baked, new[] { slower, slower });
            yield return null;
            float before = Scene.Crowd.Poses[0].phase;
            float seconds = 0f;
            for (int frame = 0; frame < 10; frame++)
            {
                yield return null;
                seconds += Time.deltaTime;
            }

            float turned = Scene.Crowd.Poses[0].phase - before;
            Assert.That(turned - math.floor(turned), Is.EqualTo(0.5f * seconds).Within(1e-4f));
            Assert.That(Scene.Crowd.Poses[0].position.x, Is.EqualTo(1f));
        }

        [UnityTest]
        public IEnumerator LiveInsects_AreOfTheCrowdsScene_AndGoWithThePlay()
        {
            Scene = new CrowdScene("monarch", 1, "cruise");
            Scene.Crowd.LivePrefab = Scene.Prefab;
            Scene.Crowd.LiveCount = 1;
            Scene.Place(0, CrowdPose.At(default, quaternion.identity));
            for (int frame = 0; frame < 600 && Scene.Crowd.LiveNow == 0; frame++)
                yield return null;
            GameObject twin = Scene.Crowd.LiveTwinOf(0).gameObject;
            Assert.That((twin.scene, twin.hideFlags), Is.EqualTo((Scene.Crowd.gameObject.scene, HideFlags.None)));
        }

        [UnityTest]
        public IEnumerator LiveInsects_OfACrowdInAnotherScene_AreMadeThere()
        {
            Scene = new CrowdScene("monarch", 1, "rest");
            Scene other = SceneManager.CreateScene("other");
            SceneManager.MoveGameObjectToScene(Scene.Crowd.gameObject, other);
            Scene.Crowd.LivePrefab = Scene.Prefab;
            Scene.Crowd.LiveCount = 1;
            Scene.Place(0, CrowdPose.At(default, quaternion.identity));
            yield return Frames(2);
            Assert.That(Twins(other), Is.EqualTo(1));
            Assert.That(Twins(Scene.Camera.gameObject.scene), Is.Zero, "where the prefab is copied first");
            Scene.Crowd.enabled = false;
            yield return null;
            Assert.That(Twins(other), Is.Zero, "it goes with the crowd");

            static int Twins(Scene scene) =>
                scene.GetRootGameObjects().Count(made => made.activeSelf && made.TryGetComponent(out InsectWings _));
        }

        // One that is live stays so while fewer than sixteen for each live one are nearer; places are kept for some of the nearest alone.
        [UnityTest]
        public IEnumerator ALiveInsect_Stays_WhileItIsAmongTheNearest([Values(15, 16)] int nearer)
        {
            Scene = new CrowdScene("monarch", 17, "cruise");
            Scene.Crowd.LivePrefab = Scene.Prefab;
            Scene.Crowd.LiveCount = 1;
            Scene.Place(0, CrowdPose.At(default, quaternion.identity));
            for (int frame = 0; frame < 600 && Scene.Crowd.LiveNow == 0; frame++)
                yield return null;
            Assert.That(Scene.Crowd.LiveTwinOf(0), Is.Not.Null);
            for (int k = 1; k <= nearer; k++)
                Scene.Place(k, CrowdPose.At(new float3(0.1f * k, 0f, -2f), quaternion.identity));
            yield return Frames(3);
            Assert.That(Scene.Crowd.LiveTwinOf(0) != null, Is.EqualTo(nearer < 16));
        }

        [UnityTest]
        public IEnumerator ALiveInsectThatIsGone_IsLeft_HoweverManyMayBeLive()
        {
            Scene = new CrowdScene("monarch", 1, "rest");
            Scene.Crowd.LivePrefab = Scene.Prefab;
            Scene.Crowd.LiveCount = 9;
            Scene.Place(0, CrowdPose.At(default, quaternion.identity));
            yield return Frames(3);
            Scene.Place(0, CrowdPose.At(new float3(0f, 0f, -50f), quaternion.identity));
            yield return Frames(3);
            LogAssert.NoUnexpectedReceived();
            Assert.That((Scene.Crowd.LiveNow, Scene.Crowd.DrawnCount), Is.EqualTo((0, 0)), "behind the camera");
        }

        [UnityTest]
        public IEnumerator InAPlayer_TextureAndMeshes_LieOnTheGraphicsDeviceAlone([Values] bool isPlayer)
        {
            Scene = new CrowdScene("monarch", 1, "rest");
            Unity.StandIns.BuiltPlayer.IsRunning = isPlayer;
            try
            {
                yield return Frames(2);
                Assert.That(Scene.Baked.Texture.isReadable, Is.Not.EqualTo(isPlayer));
                foreach (CrowdSize size in Scene.Baked.Sizes)
                    Assert.That(size.mesh.isReadable, Is.Not.EqualTo(isPlayer));
                Scene.Place(0, CrowdPose.At(default, quaternion.identity));
                yield return Frames(2);
                Assert.That(Scene.Crowd.DrawnCount, Is.EqualTo(1));
            }
            finally
            {
                Unity.StandIns.BuiltPlayer.IsRunning = false;
            }
        }

        [Test]
        public void WhatAnAssetLost_IsPassedOver_WhenItsCopiesAreFreed()
        {
            Scene = new CrowdScene("monarch", 1, "rest");
            Object.DestroyImmediate(Scene.Baked.Sizes[0].mesh);
            Unity.StandIns.BuiltPlayer.IsRunning = true;
            try
            {
                Scene.Baked.FreeCopies();
                Assert.That((Scene.Baked.Texture.isReadable, Scene.Baked.Sizes[1].mesh.isReadable), Is.EqualTo((false, false)));
                Object.DestroyImmediate(Scene.Baked.Texture);
                Assert.That(() => Scene.Baked.FreeCopies(), Throws.Nothing, "what is freed already, or gone");
                Assert.That(Scene.Baked.TextureBytes, Is.Zero);
            }
            finally
            {
                Unity.StandIns.BuiltPlayer.IsRunning = false;
            }
        }

        [Test]
        public void Crowds_RunAfterWhatWritesTheirPoses_AndBeforeWings()
        {
            int Order(Type type) => type.GetCustomAttribute<DefaultExecutionOrder>().order;
            int crowd = Order(typeof(InsectCrowd));
            foreach (Type writer in new[] { typeof(CrowdSpawner), typeof(FlockCrowd) })
                Assert.That(Order(writer), Is.GreaterThan(0).And.LessThan(crowd));
            Assert.That(crowd, Is.LessThan(Order(typeof(WingSystem))));
        }

        private void Write(string field, object value) =>
            typeof(InsectCrowd).GetField(field, BindingFlags.NonPublic | BindingFlags.Instance).SetValue(Scene.Crowd, value);
    }
}
