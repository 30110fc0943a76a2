using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>Laws of sizes on screens and of the detail that is chosen by them.</summary>
    public sealed class ViewLaws
    {
        private static readonly ScreenHeights s_Heights = new ScreenHeights
        {
            fewerSubstepsBelow = 0.4f,
            coarsePatchesBelow = 0.2f,
            wavesOnlyBelow = 0.1f,
            restBelow = 0.02f,
        };

        [TestCase(false, 60f)]
        [TestCase(false, 25f)]
        [TestCase(true, 60f)]
        public void ASphere_FillsTheShareThatItsProjectionFills(bool parallel, float fieldOfView)
        {
            var made = new GameObject("camera");
            Camera camera = made.AddComponent<Camera>();
            camera.transform.SetPositionAndRotation(new Vector3(1f, 2f, -3f), Quaternion.Euler(10f, 30f, 0f));
            (camera.orthographic, camera.fieldOfView, camera.orthographicSize) = (parallel, fieldOfView, 4f);
            float bias = QualitySettings.lodBias;
            WingSystem.DetailCameras.Add(camera);
            try
            {
                Vector3 centre = camera.transform.position + 20f * camera.transform.forward, up = 0.5f * camera.transform.up;
                float shown = camera.WorldToViewportPoint(centre + up).y - camera.WorldToViewportPoint(centre - up).y;
                foreach (float factor in new[] { 1f, 2f })
                {
                    QualitySettings.lodBias = factor;
                    var viewers = new Viewers();
                    viewers.UpdateCameras();
                    Assert.That(viewers.ScreenHeight(centre, 0.5f), Is.EqualTo(factor * shown).Within(0.1).Percent);
                    Assert.That(viewers.ScreenHeight(centre, 1f), Is.EqualTo(2f * factor * shown).Within(0.1).Percent);
                }
            }
            finally
            {
                QualitySettings.lodBias = bias;
                WingSystem.DetailCameras.Remove(camera);
                Object.DestroyImmediate(made);
            }
        }

        // The nearest camera counts; those that are gone do not, and without any the main one looks.
        [Test]
        public void OfSeveralCameras_TheLargestPictureCounts()
        {
            Camera far = Made(-40f), near = Made(-10f), gone = Made(-1f);
            float bias = QualitySettings.lodBias;
            QualitySettings.lodBias = 1f;
            try
            {
                var viewers = new Viewers();
                viewers.UpdateCameras();
                Assert.That((viewers.Any, viewers.ScreenHeight(default, 1f)), Is.EqualTo((false, 0f)));
                far.tag = "MainCamera";
                Assert.That(Height(), Is.EqualTo(1f / 40f).Within(1e-5f), "the main camera");
                WingSystem.DetailCameras.AddRange(new[] { gone, near });
                Object.DestroyImmediate(gone.gameObject);
                Assert.That(Height(), Is.EqualTo(1f / 10f).Within(1e-5f), "the one that is listed");
                WingSystem.DetailCameras.Add(far);
                Assert.That(Height(), Is.EqualTo(1f / 10f).Within(1e-5f), "the nearer one of two");

                float Height()
                {
                    viewers.UpdateCameras();
                    Assert.That(viewers.Any);
                    return viewers.ScreenHeight(default, 1f);
                }
            }
            finally
            {
                QualitySettings.lodBias = bias;
                WingSystem.DetailCameras.Clear();
                Object.DestroyImmediate(far.gameObject);
                Object.DestroyImmediate(near.gameObject);
            }

            Camera Made(float z)
            {
                Camera camera = new GameObject("camera").AddComponent<Camera>();
                camera.transform.position = new Vector3(0f, 0f, z);
                camera.fieldOfView = 90f;
                return camera;
            }
        }

        [TestCase(0.41f, WingDetail.Full)]
        [TestCase(0.39f, WingDetail.FewerSubsteps)]
        [TestCase(0.21f, WingDetail.FewerSubsteps)]
        [TestCase(0.19f, WingDetail.CoarsePatches)]
        [TestCase(0.11f, WingDetail.CoarsePatches)]
        [TestCase(0.09f, WingDetail.WavesOnly)]
        [TestCase(0.021f, WingDetail.WavesOnly)]
        [TestCase(0.019f, WingDetail.Frozen)]
        public void WhatShrinks_ChangesAtItsThresholds(float height, WingDetail expected) =>
            Assert.That(s_Heights.Choose(height, WingDetail.Full), Is.EqualTo(expected));

        // 15 % beyond a threshold.
        [TestCase(WingDetail.FewerSubsteps, 0.4f)]
        [TestCase(WingDetail.CoarsePatches, 0.2f)]
        [TestCase(WingDetail.WavesOnly, 0.1f)]
        [TestCase(WingDetail.Frozen, 0.02f)]
        public void WhatGrows_KeepsItsLevelForAWhile(WingDetail level, float threshold)
        {
            Assert.That(s_Heights.Choose(1.14f * threshold, level), Is.EqualTo(level));
            Assert.That(s_Heights.Choose(1.16f * threshold, level), Is.EqualTo(level - 1));
            Assert.That(s_Heights.Choose(1.01f * threshold, level - 1), Is.EqualTo(level - 1), "one that has not reached it stays");
        }

        [Test]
        public void EachLevel_HasItsThreshold()
        {
            WingDetail[] levels =
                { WingDetail.Full, WingDetail.FewerSubsteps, WingDetail.CoarsePatches, WingDetail.WavesOnly, WingDetail.Frozen };
            Assert.That(System.Array.ConvertAll(levels, s_Heights.Of), Is.EqualTo(new[] { 1f, 0.4f, 0.2f, 0.1f, 0.02f }));
        }

        [Test]
        public void AThresholdOfNought_SwitchesItsLevelOff()
        {
            ScreenHeights heights = s_Heights;
            heights.restBelow = heights.coarsePatchesBelow = 0f;

            Assert.That(heights.Choose(0f, WingDetail.Full), Is.EqualTo(WingDetail.WavesOnly));
            Assert.That(heights.Choose(0.15f, WingDetail.Full), Is.EqualTo(WingDetail.FewerSubsteps));
            Assert.That(default(ScreenHeights).Choose(0f, WingDetail.Frozen), Is.EqualTo(WingDetail.Full));
        }

        [Test]
        public void Thresholds_AreSharesOfAScreen()
        {
            var given = new ScreenHeights
            {
                fewerSubstepsBelow = 2f,
                coarsePatchesBelow = -1f,
                wavesOnlyBelow = 0.3f,
                restBelow = 1.5f,
            };
            ScreenHeights clamped = given.Clamped();

            Assert.That((clamped.fewerSubstepsBelow, clamped.coarsePatchesBelow, clamped.wavesOnlyBelow, clamped.restBelow),
                Is.EqualTo((1f, 0f, 0.3f, 1f)));
        }
    }
}
