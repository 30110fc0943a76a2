using System;
using Alate.Authoring;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    /// <summary>Work of the wizard without its window.</summary>
    public sealed class WingFromImageTests
    {
        private Texture2D m_Texture;

        [SetUp]
        public void MakeTexture()
        {
            m_Texture = new Texture2D(120, 80) { name = "my wing" };
            var pixels = new Color32[120 * 80];
            for (int k = 0; k < pixels.Length; k++)
                pixels[k] = IsWing(k % 120, k / 120) ? new Color32(30, 20, 10, 255) : new Color32(240, 240, 240, 255);
            m_Texture.SetPixels32(pixels);
            m_Texture.Apply();
        }

        [TearDown]
        public void DestroyTexture() => UnityEngine.Object.DestroyImmediate(m_Texture);

        [Test]
        public void Picture_IsReadFromItsFile_WhateverTheTextureHolds()
        {
            byte[] file = m_Texture.EncodeToPNG();
            var imported = new Texture2D(4, 4) { name = "small and closed" };
            imported.Apply(false, true);

            Texture2D read = WingImageFile.Read(imported, file);

            Assert.That((read.width, read.height), Is.EqualTo((120, 80)));
            Assert.That(read.GetPixels32(), Is.EqualTo(m_Texture.GetPixels32()));
            UnityEngine.Object.DestroyImmediate(read);
            UnityEngine.Object.DestroyImmediate(imported);
        }

        [Test]
        public void ReadableTexture_ServesWhereItsFileDoesNot()
        {
            Texture2D read = WingImageFile.Read(m_Texture, new byte[] { 1, 2, 3 });

            Assert.That(read, Is.Not.SameAs(m_Texture));
            Assert.That(read.GetPixels32(), Is.EqualTo(m_Texture.GetPixels32()));
            UnityEngine.Object.DestroyImmediate(read);
        }

        [Test]
        public void TextureThatNeitherServes_IsRefusedWithTheRemedy()
        {
            m_Texture.Apply(false, true);

            Assert.That(
                () => WingImageFile.Read(m_Texture, null),
                Throws.TypeOf<FormatException>().With.Message.Contains("my wing").And.Message.Contains("Read/Write"));
        }

        [Test]
        public void Wing_IsTraced()
        {
            var tracing = WingImageTracing.Run(m_Texture, WingTracingSettings.Default);

            Assert.That(tracing.Problem, Is.Null);
            Assert.That(tracing.Trace.Surface.TriangleCount, Is.EqualTo(1000));
        }

        [TestCase(2, 1000, "3 to 16 chains")]
        [TestCase(5, 1, "50 to 200000")]
        public void WrongSetting_IsOneLineForTheUser(int chains, int triangles, string said)
        {
            WingTracingSettings settings = WingTracingSettings.Default;
            settings.chains = chains;
            settings.triangles = triangles;

            var tracing = WingImageTracing.Run(m_Texture, settings);

            Assert.That(tracing.Trace, Is.Null);
            Assert.That(tracing.Problem, Does.Contain(said).And.Not.Contain("\n").And.Not.Contain("Parameter"));
        }

        [Test]
        public void PictureWithoutAWing_IsOneLineForTheUser()
        {
            var empty = new Texture2D(100, 100);

            var tracing = WingImageTracing.Run(empty, WingTracingSettings.Default);

            Assert.That(tracing.Problem, Does.StartWith("No wing"));
            UnityEngine.Object.DestroyImmediate(empty);
        }

        [TestCase("Assets/Wings/moth.png", "Assets/Wings")]
        [TestCase("Assets/moth.png", "Assets")]
        [TestCase("Packages/com.somebody.wings/moth.png", "Assets")]
        [TestCase("Library/unity default resources", "Assets")]
        [TestCase("AssetsOfOthers/moth.png", "Assets")]
        [TestCase("", "Assets")]
        [TestCase(null, "Assets")]
        public void Assets_GoBesideThePicture_ButNeverIntoAPackage(string image, string folder) =>
            Assert.That(WingTraceAssets.FolderFor(image), Is.EqualTo(folder));

        [Test]
        public void Place_IsDrawnWhereThePictureShowsIt()
        {
            Vector3 at = WingTracePreview.InWindow(new Vector2(60f, 20f), new Rect(10f, 30f, 240f, 160f), new Vector2(120f, 80f));

            Assert.That((at.x, at.y), Is.EqualTo((130f, 70f)));
        }

        [Test]
        public void Sides_AreDirectionsWithYDown()
        {
            Assert.That(WingImageSide.Automatic.ToDirection(), Is.Null);
            Assert.That(WingImageSide.Up.ToDirection(), Is.EqualTo(new Vector2(0f, -1f)));
            Assert.That(WingImageSide.Down.ToDirection(), Is.EqualTo(new Vector2(0f, 1f)));
            Assert.That(WingImageSide.Left.ToDirection(), Is.EqualTo(new Vector2(-1f, 0f)));
            Assert.That(WingImageSide.Right.ToDirection(), Is.EqualTo(new Vector2(1f, 0f)));
        }

        // Half an ellipse from the left, wider below.
        private static bool IsWing(int x, int y)
        {
            double along = (x - 10) / 100.0, across = (y - 50) / (y > 50 ? 10.0 : 35.0);
            return along > 0.0 && along * along + across * across < 1.0;
        }
    }
}
