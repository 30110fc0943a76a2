using System.Collections;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play.Headless
{
    /// <summary>
    /// Insects outside of all cameras cost nothing, and come back as if they had gone on. Tested here, because without a screen Unity sees
    /// nothing at all.
    /// </summary>
    public sealed class CullingTests : FlockFixture
    {
        private Camera m_Camera;

        [SetUp]
        public void MakeACamera()
        {
            m_Camera = Keep(new GameObject("camera")).AddComponent<Camera>();
            m_Camera.transform.position = new Vector3(0f, 0f, -6f);
            WingSystem.DetailCameras.Add(m_Camera);
        }

        [UnityTest]
        public IEnumerator OutOfSight_NothingIsStepped_AndTheBeatIsMadeUpFor(
            [Values(WingUpdateMode.FixedUpdate, WingUpdateMode.Update, WingUpdateMode.UnscaledTime)] WingUpdateMode mode)
        {
            InsectWings insect = Hatch(made => Prepare(made, mode, WingCulling.CullCompletely));
            InsectWings twin = Hatch(made => Prepare(made, mode, WingCulling.AlwaysSimulate));
            yield return Frames(30);
            Assert.That(Farthest(Joints(insect, 0), Joints(twin, 0)), Is.LessThan(1e-4f));

            LookAway();
            yield return Frames(3);
            float beats = Beats(insect);
            yield return Frames(97);
            Assert.That(Beats(insect), Is.EqualTo(beats));
            Assert.That(insect.Detail, Is.EqualTo(WingDetail.Frozen));

            LookBack();
            yield return Frames(3);
            Assert.That(Beats(insect), Is.EqualTo(Beats(twin)).Within(0.01f));
            yield return Frames(20);
            Assert.That(Beats(insect), Is.EqualTo(Beats(twin)).Within(0.01f));
            Assert.That(Farthest(Joints(insect, 0), Joints(twin, 0)), Is.LessThan(0.01f));
        }

        [UnityTest]
        public IEnumerator OutOfSight_WithSkinningSaved_ForcesGoOn()
        {
            InsectWings insect = Hatch(made => Prepare(made, WingUpdateMode.FixedUpdate, WingCulling.CullSkinning)), twin = Hatch();
            yield return Frames(10);
            LookAway();
            yield return Frames(3);
            Vector3[] drawn = Shown(insect, 0).vertices;
            float beats = Beats(insect);
            yield return Frames(30);

            Assert.That(Beats(insect), Is.GreaterThan(beats + 3f));
            Assert.That(insect.Lift, Is.EqualTo(twin.Lift).Within(1e-6f));
            Assert.That(Shown(insect, 0).vertices, Is.EqualTo(drawn));
            LookBack();
            yield return Frames(2);
            Assert.That(Shown(insect, 0).vertices, Is.Not.EqualTo(drawn));
        }

        [UnityTest]
        public IEnumerator OutOfSight_WithNothingSaved_AllGoesOn()
        {
            InsectWings insect = Hatch();
            yield return Frames(10);
            LookAway();
            yield return Frames(3);
            Vector3[] drawn = Shown(insect, 0).vertices;
            yield return Frames(3);

            Assert.That(Shown(insect, 0).vertices, Is.Not.EqualTo(drawn));
        }

        [UnityTest]
        public IEnumerator SteppedByHand_OutOfSight_ItIsStepped()
        {
            InsectWings insect = Hatch(made => Prepare(made, WingUpdateMode.Manual, WingCulling.CullCompletely));
            LookAway();
            yield return Frames(5);
            float beats = Beats(insect);
            insect.Step(0.1f);

            Assert.That(Beats(insect), Is.EqualTo(beats + 0.88f).Within(1e-3f));
        }

        [UnityTest]
        public IEnumerator ANewInsectInView_IsDeformedInItsFirstPicture()
        {
            InsectWings insect = Hatch(made => Prepare(made, WingUpdateMode.FixedUpdate, WingCulling.CullCompletely));
            yield return null;
            yield return null;

            Assert.That(
                Shown(insect, 0).vertices, Is.Not.EqualTo(WingMesh.vertices), "the first picture shows the wing as it was authored");
        }

        [UnityTest]
        public IEnumerator AnotherUpdateModeOutOfSight_DoesNotUpsetTheBeat()
        {
            InsectWings insect = Hatch(made => Prepare(made, WingUpdateMode.UnscaledTime, WingCulling.CullCompletely));
            InsectWings twin = Hatch(made => Prepare(made, WingUpdateMode.UnscaledTime, WingCulling.AlwaysSimulate));
            yield return Frames(120);
            LookAway();
            yield return Frames(30);
            insect.UpdateMode = twin.UpdateMode = WingUpdateMode.FixedUpdate;
            yield return Frames(30);
            LookBack();
            yield return Frames(3);

            Assert.That(Beats(insect), Is.EqualTo(Beats(twin)).Within(0.3f));
        }

        [UnityTest]
        public IEnumerator OutOfSight_ForAnHour_ItStillResumes()
        {
            InsectWings insect = Hatch(made => Prepare(made, WingUpdateMode.FixedUpdate, WingCulling.CullCompletely));
            yield return Frames(10);
            LookAway();
            yield return Frames(3);
            float beats = Beats(insect);
            Time.timeScale = 100f;
            Time.fixedDeltaTime = 5f;
            Time.captureDeltaTime = 0.3f;
            yield return Frames(120);
            Time.fixedDeltaTime = 0.02f;
            Time.timeScale = 1f;
            Time.captureDeltaTime = 1f / 60f;
            LookBack();
            yield return Frames(10);

            Assert.That(Beats(insect) - beats, Is.EqualTo(8.8f * 3600f).Within(8.8f * 60f));
            Assert.That(WingSystem.ResetCount, Is.Zero);
            Assert.That(insect.Detail, Is.EqualTo(WingDetail.Full));
        }

        [UnityTest]
        public IEnumerator OutOfSight_AnotherCullingOrMode_WakesIt([Values] bool byMode)
        {
            InsectWings insect = Hatch(made => Prepare(made, WingUpdateMode.FixedUpdate, WingCulling.CullCompletely)), twin = Hatch();
            yield return Frames(10);
            LookAway();
            yield return Frames(30);
            if (byMode)
                insect.UpdateMode = WingUpdateMode.Manual;
            else
                insect.Quality.culling = WingCulling.CullSkinning;
            yield return Frames(2);

            Assert.That(insect.Detail, Is.EqualTo(WingDetail.Full));
            Assert.That(Beats(insect), Is.EqualTo(Beats(twin)).Within(byMode ? 0.5f : 0.01f));
        }

        [UnityTest]
        public IEnumerator AtTheEdgeOfTheScreen_NothingPops()
        {
            InsectWings insect = Hatch(made => Prepare(made, WingUpdateMode.FixedUpdate, WingCulling.CullCompletely));
            yield return Frames(10);
            for (int frame = 0; frame < 180; frame++)
            {
                // Out of the picture and back in.
                m_Camera.transform.position = new Vector3(8f * math.sin(2f * math.PI * frame / 180f), 0f, -6f);
                yield return null;
                if (insect.Detail == WingDetail.Frozen)
                    Assert.That(SeenVertices(insect), Is.Zero, $"frame {frame}");
            }

            Assert.That(insect.Detail, Is.EqualTo(WingDetail.Full));
        }

        [UnityTest]
        public IEnumerator OutOfSight_AScaleOfZero_DoesNoHarm()
        {
            InsectWings insect = Hatch(made => Prepare(made, WingUpdateMode.FixedUpdate, WingCulling.CullCompletely));
            yield return Frames(10);
            insect.transform.localScale = Vector3.zero;
            yield return Frames(10);
            LookAway();
            yield return Frames(10);
            insect.transform.localScale = Vector3.one;
            LookBack();
            yield return Frames(5);

            Assert.That(insect.State, Is.EqualTo(InsectState.Ready));
            Assert.That(insect.Detail, Is.EqualTo(WingDetail.Full));
        }

        [UnityTest]
        public IEnumerator ASlowPanOverAStillPicture_ShowsTheWingsAsTheyAre()
        {
            InsectWings insect = Hatch(made => Prepare(made, WingUpdateMode.FixedUpdate, WingCulling.CullCompletely));
            InsectWings twin = Hatch(made => Prepare(made, WingUpdateMode.FixedUpdate, WingCulling.AlwaysSimulate));
            yield return Frames(10);
            LookAway();
            yield return Frames(33);
            Time.timeScale = 0f;
            yield return Frames(5);
            LookBack();
            yield return Frames(5);

            Assert.That(Beats(insect), Is.EqualTo(Beats(twin)).Within(0.01f));
            int place = System.Array.IndexOf(Order(insect, 0), 84);
            float3 tip = insect.Read(0).JointPosition(0, 4), drawn = Shown(insect, 0).vertices[place];
            Assert.That(math.distance(drawn, tip), Is.LessThan(0.05f), "while the game is paused the wings show a pose of long ago");
        }

        private int SeenVertices(InsectWings insect)
        {
            int count = 0;
            for (int wing = 0; wing < 2; wing++)
            {
                Transform drawn = insect.Wings[wing].Renderer.transform;
                foreach (Vector3 vertex in Shown(insect, wing).vertices)
                {
                    Vector3 seen = m_Camera.WorldToViewportPoint(drawn.TransformPoint(vertex));
                    count += seen.z > 0f && seen.x > 0f && seen.x < 1f && seen.y > 0f && seen.y < 1f ? 1 : 0;
                }
            }

            return count;
        }

        private void LookAway() => m_Camera.transform.rotation = Quaternion.Euler(0f, 180f, 0f);

        private void LookBack() => m_Camera.transform.rotation = Quaternion.identity;

        private static void Prepare(InsectWings insect, WingUpdateMode mode, WingCulling culling)
        {
            insect.UpdateMode = mode;
            insect.Quality.culling = culling;
        }
    }
}
