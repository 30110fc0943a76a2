using System.Collections;
using Alate.Crowds;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play.Headless
{
    /// <summary>Live insects in the places of baked ones: what they fly, and how long they beat unseen.</summary>
    public sealed class CrowdTwinLaws : CrowdFixture
    {
        [UnityTest]
        public IEnumerator ALiveInsect_FliesAsTheLoopOfItsPose_InItsPlaceAndSize()
        {
            Scene = new CrowdScene("monarch", 1, "hover", "turn-left");
            Live();
            CrowdLoop loop = Scene.Baked.Loops[1];
            quaternion turn = math.mul(quaternion.RotateY(0.7f), quaternion.RotateX(0.1f));
            var pose = CrowdPose.At(new float3(0.3f, -0.2f, 1f), turn, 0.3f);
            (pose.loop, pose.nextLoop, pose.rate, pose.scale) = (1, 1, 1.3f, 1.5f);
            Scene.Place(0, pose);
            yield return UntilLive(0);

            InsectWings twin = Scene.Crowd.LiveTwinOf(0);
            Assert.That(Vector3.Distance(twin.transform.position, pose.position), Is.LessThan(1e-5f));
            Assert.That(Quaternion.Angle(twin.transform.rotation, turn), Is.LessThan(0.1f));
            Assert.That(twin.transform.localScale, Is.EqualTo(1.5f * Vector3.one));
            Assert.That(math.distance(twin.Velocity, math.rotate(turn, 1.5f * (float3)loop.velocity)), Is.LessThan(1e-4f));
            Assert.That(math.length(twin.Velocity), Is.GreaterThan(0.1f));
            Assert.That(twin.Steering.frequencyScale, Is.EqualTo(1.3f * loop.steering.frequencyScale).Within(1e-5f));
            Assert.That(twin.Steering.amplitudeScale, Is.EqualTo(loop.steering.amplitudeScale));
            foreach (Wing wing in twin.Wings)
            {
                // To the left the right wing beats harder.
                Assert.That(wing.AmplitudeScale, Is.EqualTo(wing.Side == WingSide.Left ? 0.85f : 1.15f).Within(1e-5f));
            }

            // It is computed wherever cameras look, and no jump of its pose is wind.
            Assert.That(twin.Detail, Is.EqualTo(WingDetail.Full));
            Assert.That((twin.Quality.levelOfDetail, twin.Quality.culling), Is.EqualTo((false, WingCulling.AlwaysSimulate)));
            Assert.That((twin.Motion.source, twin.Motion.onTeleport), Is.EqualTo((VelocitySource.Script, TeleportResponse.Ignore)));
            Assert.That(twin.UpdateMode, Is.EqualTo(WingUpdateMode.Update));
        }

        [UnityTest]
        public IEnumerator ALiveInsect_ChangesItsLoop_InTheMiddleOfTheBlend([Values(0.49f, 0.51f)] float blend)
        {
            Scene = new CrowdScene("monarch", 1, "hover", "turn-left");
            Live();
            var pose = CrowdPose.At(default, quaternion.identity);
            (pose.nextLoop, pose.blend) = (1, blend);
            Scene.Place(0, pose);
            yield return Frames(3);
            InsectWings twin = Made();
            Assert.That(twin.Steering.amplitudeScale, Is.EqualTo(Scene.Baked.Loops[blend < 0.5f ? 0 : 1].steering.amplitudeScale));
            Assert.That(twin.Wings[0].AmplitudeScale == 1f, Is.EqualTo(blend < 0.5f));
        }

        // A monarch that sits: its wings lie together over its back.
        [UnityTest]
        public IEnumerator ALiveInsect_IsFoldedAsItsLoop()
        {
            Scene = new CrowdScene("monarch", 1, "folded", "rest");
            Live();
            Scene.Place(0, CrowdPose.At(default, quaternion.identity));
            yield return UntilLive(0);
            yield return Frames(30);
            float folded = Tips();
            var spread = CrowdPose.At(default, quaternion.identity);
            (spread.loop, spread.nextLoop) = (1, 1);
            Scene.Place(0, spread);
            yield return Frames(60);
            float rest = Tips();

            Assert.That(folded, Is.LessThan(0.35f * rest), $"between the tips: {folded}, spread {rest}");

            float Tips()
            {
                InsectWings twin = Made();
                int last = twin.Read(0).JointsPerChain - 1;
                return Vector3.Distance(twin.JointPosition(0, 0, last), twin.JointPosition(1, 0, last));
            }
        }

        // Eight beats, after which a wing that started unbent beats like any other.
        [UnityTest]
        public IEnumerator WhoTakesAnothersPlace_BeatsUnseenForEightBeats_AsTheFirstDid()
        {
            Scene = new CrowdScene("monarch", 2, "cruise");
            Live();
            for (int insect = 0; insect < 2; insect++)
            {
                Scene.Place(1 - insect, CrowdPose.At(new float3(0f, 0f, -50f), quaternion.identity));
                Scene.Place(insect, CrowdPose.At(new float3(0f, 0f, insect), quaternion.identity, 0.25f));
                yield return Frames(2);
                Assert.That((Scene.Crowd.LiveNow, Scene.Crowd.LiveTwinOf(1 - insect)), Is.EqualTo((0, (InsectWings)null)));
                float beats = 0f;
                for (int frame = 0; frame < 300 && Scene.Crowd.LiveNow == 0; frame++)
                {
                    beats += Time.deltaTime * Made().Frequency;
                    yield return null;
                }

                Assert.That(Scene.Crowd.LiveTwinOf(insect), Is.SameAs(Made()));
                Assert.That(beats, Is.EqualTo(8f).Within(1f), $"insect {insect}");
                yield return Frames(1);
                Assert.That(Scene.Crowd.DrawnCount, Is.Zero, "not both of them");
            }

            Scene.Crowd.LiveCount = 0;
            yield return Frames(2);
            Assert.That((Scene.Crowd.LiveNow, Scene.Crowd.DrawnCount), Is.EqualTo((0, 1)));
        }

        private void Live()
        {
            Scene.Crowd.LivePrefab = Scene.Prefab;
            Scene.Crowd.LiveCount = 1;
        }

        // The copy of the prefab, seen or not.
        private InsectWings Made()
        {
            foreach (InsectWings insect in Resources.FindObjectsOfTypeAll<InsectWings>())
            {
                if (insect != null && insect != Scene.Prefab && insect.gameObject.activeInHierarchy)
                    return insect;
            }

            return null;
        }

        private IEnumerator UntilLive(int insect)
        {
            for (int frame = 0; frame < 600 && Scene.Crowd.LiveTwinOf(insect) == null; frame++)
                yield return null;
            Assert.That(Scene.Crowd.LiveTwinOf(insect), Is.Not.Null);
        }
    }
}
