using System.Collections;
using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>Levels of detail that follow the view, without visible changes.</summary>
    public sealed class DetailTests : DetailFixture
    {
        [UnityTest]
        public IEnumerator EachShareOfTheScreen_HasItsLevel()
        {
            InsectWings insect = Hatch();
            var levels = new List<WingDetail>();
            foreach (float height in new[] { 0.5f, 0.15f, 0.05f, 0.01f, 0.001f, 0.01f, 0.05f, 0.15f, 0.5f })
            {
                Look(insect, height);
                yield return Frames(60);
                levels.Add(insect.Detail);
            }

            Assert.That(levels, Is.EqualTo(new[]
            {
                WingDetail.Full, WingDetail.FewerSubsteps, WingDetail.CoarsePatches, WingDetail.WavesOnly, WingDetail.Frozen,
                WingDetail.WavesOnly, WingDetail.CoarsePatches, WingDetail.FewerSubsteps, WingDetail.Full,
            }));
        }

        [UnityTest]
        public IEnumerator AnOrthographicCamera_CountsTheSame()
        {
            Camera.orthographic = true;
            InsectWings insect = Hatch();
            Look(insect, 0.5f);
            Camera.orthographicSize = QualitySettings.lodBias / 0.05f;
            yield return Frames(3);
            Assert.That(insect.Detail, Is.EqualTo(WingDetail.CoarsePatches));

            Camera.orthographicSize = QualitySettings.lodBias / 0.5f;
            yield return Frames(3);
            Assert.That(insect.Detail, Is.EqualTo(WingDetail.Full));
        }

        [UnityTest]
        public IEnumerator AnInsectThatComesCloser_WakesUp()
        {
            InsectWings insect = Hatch();
            Look(insect, 0.001f);
            yield return Frames(90);
            Assert.That(insect.Detail, Is.EqualTo(WingDetail.Frozen));
            float beats = Beats(insect);

            insect.transform.position = Vector3.Lerp(Camera.transform.position, insect.transform.position, 0.001f);
            insect.Teleport();
            yield return Frames(30);

            Assert.That(insect.Detail, Is.EqualTo(WingDetail.Full));
            Assert.That(Beats(insect), Is.GreaterThan(beats + 2f));
            Assert.That(insect.FlapRange, Is.GreaterThan(30f));
        }

        [UnityTest]
        public IEnumerator AScaledInsect_CountsByWhatIsSeen()
        {
            InsectWings insect = Hatch();
            Look(insect, 0.05f);
            yield return Frames(3);
            Assert.That(insect.Detail, Is.EqualTo(WingDetail.CoarsePatches));

            insect.transform.localScale = 10f * Vector3.one;
            yield return Frames(3);
            Assert.That(insect.Detail, Is.EqualTo(WingDetail.Full));
        }

        [UnityTest]
        public IEnumerator WithoutLevels_OrWithoutCamera_AllIsComputed([Values] bool camera)
        {
            InsectWings insect = Hatch(made => made.Quality.levelOfDetail = !camera);
            Look(insect, 0.001f);
            if (!camera)
                Camera.enabled = false;
            WingSystem.DetailCameras.Clear();
            if (camera)
                WingSystem.DetailCameras.Add(Camera);
            yield return Frames(60);

            Assert.That(insect.Detail, Is.EqualTo(WingDetail.Full));
        }

        [UnityTest]
        public IEnumerator OfTwoCameras_TheNearerOneCounts()
        {
            InsectWings insect = Hatch();
            Look(insect, 0.001f);
            Camera second = Keep(new GameObject("second")).AddComponent<Camera>();
            second.transform.position = insect.transform.position + 3f * Vector3.back;
            WingSystem.DetailCameras.Add(second);
            yield return Frames(10);
            Assert.That(insect.Detail, Is.EqualTo(WingDetail.Full));

            second.transform.position += 1e5f * Vector3.back;
            yield return Frames(120);
            Assert.That(insect.Detail, Is.EqualTo(WingDetail.Frozen));
        }

        [UnityTest]
        public IEnumerator WhereForcesAreKept_TheyAreComputedHoweverFar()
        {
            InsectWings insect = Hatch(made => made.Quality.keepForces = true);
            Look(insect, 0.001f);
            yield return Frames(120);

            Assert.That(insect.Detail, Is.EqualTo(WingDetail.CoarsePatches));
            Assert.That(insect.AirForce.magnitude, Is.GreaterThan(0f));
        }

        [UnityTest]
        public IEnumerator AtAThreshold_TheLevelDoesNotFlicker()
        {
            InsectWings insect = Hatch();
            Look(insect, 0.3f);
            yield return Frames(3);
            int switches = 0;
            WingDetail last = insect.Detail;
            for (int frame = 0; frame < 60; frame++)
            {
                Look(insect, 0.2f * (1f + 0.05f * math.sin(frame)));
                yield return null;
                switches += insect.Detail != last ? 1 : 0;
                last = insect.Detail;
            }

            Assert.That(switches, Is.EqualTo(1));
        }

        [UnityTest]
        public IEnumerator ASwitch_IsNoJump([Values] bool inWind)
        {
            InsectWings insect = Hatch(made => made.Air.wind = inWind ? new Vector3(3f, 0f, -10f) : Vector3.zero);
            Look(insect, 0.5f);
            yield return Frames(60);
            float usual = 0f, worst = 0f;
            yield return Moves(insect, 60, move => usual = math.max(usual, move));
            foreach (float height in new[] { 0.15f, 0.05f, 0.01f, 0.05f, 0.15f, 0.5f, 0.01f, 0.5f, 0.001f, 0.5f, 0.001f, 0.15f })
            {
                // At several points of the beat.
                yield return Moves(insect, height < 0.002f ? 80 : 17, move => usual = math.max(usual, move));
                Look(insect, height);
                yield return Moves(insect, 6, move => worst = math.max(worst, move));
            }

            Assert.That(worst, Is.LessThan(1.5f * usual));
            Assert.That(WingSystem.ResetCount, Is.Zero);
        }

        [UnityTest]
        public IEnumerator FarAway_TheWingsComeToRest_AndNothingIsComputed()
        {
            InsectWings insect = Hatch();
            Look(insect, 0.001f);
            yield return Frames(120);
            Assert.That(insect.Detail, Is.EqualTo(WingDetail.Frozen));
            long steps = WingSystem.StepCount;
            Vector3[] drawn = Shown(insect, 0).vertices;
            yield return Frames(30);

            Assert.That(WingSystem.StepCount, Is.EqualTo(steps));
            Assert.That(Shown(insect, 0).vertices, Is.EqualTo(drawn));
            float y = insect.JointPosition(0, 0, 4).y;
            // The middle of a monarch's stroke is ten degrees above level.
            Assert.That(math.degrees(math.asin(y)), Is.EqualTo(10f).Within(3f));
        }

        [UnityTest]
        public IEnumerator LevelsOfOneInsect_AreNotThoseOfAnother()
        {
            InsectWings near = Hatch(), far = Hatch(), twin = Hatch(made => made.Quality.levelOfDetail = false);
            Look(near, 0.5f);
            far.transform.position = Camera.transform.position + 400f * Vector3.forward;
            yield return Frames(60);

            Assert.That(near.Detail, Is.EqualTo(WingDetail.Full));
            Assert.That(far.Detail, Is.Not.EqualTo(WingDetail.Full));
            Assert.That(Farthest(Joints(near, 0), Joints(twin, 0)), Is.LessThan(1e-5f));
        }

        [UnityTest]
        public IEnumerator BoundsHoldEveryVertex([Values(1f, 0.1f)] float elasticity)
        {
            WingPreset preset = Keep(InsectCatalogue.Monarch());
            preset.Stiffness.elasticity = elasticity;
            preset.Beat.flapRange = 180f;
            preset.Beat.amplitudeFloor = 1f;
            InsectWings insect = Hatch(made =>
            {
                made.Preset = preset;
                made.Air.wind = new Vector3(20f, 30f, -40f);
            });
            yield return Frames(2);
            for (int frame = 0; frame < 120; frame++)
            {
                yield return null;
                for (int wing = 0; wing < 2; wing++)
                {
                    Mesh shown = Shown(insect, wing);
                    Bounds whole = Grown(shown.bounds), tight = Grown(insect.BoundsOf(wing));
                    foreach (Vector3 vertex in shown.vertices)
                    {
                        if (!whole.Contains(vertex) || !tight.Contains(vertex))
                            Assert.Fail($"frame {frame}: {vertex} is outside {whole} or {tight}");
                    }
                }
            }
        }

        private static Bounds Grown(Bounds bounds)
        {
            bounds.Expand(1e-4f);
            return bounds;
        }

        private static IEnumerator Moves(InsectWings insect, int frames, System.Action<float> tell)
        {
            Vector3[] last = Shown(insect, 0).vertices;
            int[] drawn = Shown(insect, 0).triangles;
            for (int frame = 0; frame < frames; frame++)
            {
                yield return null;
                Vector3[] now = Shown(insect, 0).vertices;
                int[] corners = Shown(insect, 0).triangles;
                float largest = 0f;
                foreach (int v in drawn.Intersect(corners))
                    largest = math.max(largest, (now[v] - last[v]).magnitude);
                tell(largest);
                (last, drawn) = (now, corners);
            }
        }
    }
}
