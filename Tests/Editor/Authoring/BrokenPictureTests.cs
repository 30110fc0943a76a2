using System;
using Alate.Authoring;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    /// <summary>Pictures that show no single wing: one clear line each.</summary>
    public sealed class BrokenPictureTests
    {
        private static readonly Color32 s_White = new Color32(255, 255, 255, 255), s_Black = new Color32(0, 0, 0, 255);

        [TestCase(255)]
        [TestCase(0)]
        [TestCase(128)]
        public void PictureOfOneShade_HasNoWing(byte shade) =>
            AssertRefused(new DrawnPicture(200, 200, new Color32(shade, shade, shade, 255)), "No wing", "stands out");

        [Test]
        public void TransparentPicture_HasNoWing() =>
            AssertRefused(new DrawnPicture(200, 200, new Color32(0, 0, 0, 0)), "No wing", "stands out");

        [Test]
        public void Noise_HasNoWing() =>
            AssertRefused(new DrawnPicture(200, 200, new Color32(128, 128, 128, 255)).Noise(60f, 5), "No wing");

        [Test]
        public void Gradient_HasNoWing() =>
            AssertRefused(new DrawnPicture(200, 200, s_White).Shade((x, y) => -150f * x - 60f * y * y), "No wing", "stands out");

        [Test]
        public void Specks_HaveNoWing() => AssertRefused(
            new DrawnPicture(300, 300, s_White).Stroke(Line(40, 40, 50, 42), 6f, s_Black).Stroke(Line(240, 140, 245, 152), 6f, s_Black),
            "No wing", "pixels long");

        [Test]
        public void OpenLines_HaveNoWing() => AssertRefused(
            new DrawnPicture(400, 400, s_White).Stroke(Line(40, 40, 350, 60), 2f, s_Black).Stroke(Line(350, 60, 300, 340), 2f, s_Black),
            "No wing", "lines");

        [Test]
        public void TwoWings_AreTooMany()
        {
            Vector2[] wing = DrawnWing.Monarch().In(300, 0f, false, 0.4f).Outline;
            DrawnPicture picture = new DrawnPicture(300, 300, s_White)
                .Fill(Array.ConvertAll(wing, p => p + new Vector2(-68f, 0f)), s_Black)
                .Fill(Array.ConvertAll(wing, p => p + new Vector2(75f, 15f)), s_Black);

            AssertRefused(picture, "2 wings", "one wing");
        }

        [Test]
        public void FourWings_AreCounted()
        {
            Vector2[] wing = DrawnWing.Fan().In(360, 0f, false, 0.3f).Outline;
            var picture = new DrawnPicture(360, 360, s_White);
            foreach (Vector2 shift
                in new[] { new Vector2(-90, -90), new Vector2(90, -90), new Vector2(-90, 90), new Vector2(90, 90) })
            {
                picture.Fill(Array.ConvertAll(wing, p => p + shift), s_Black);
            }

            AssertRefused(picture, "4 wings");
        }

        [Test]
        public void CheckerBoard_HasNoPlainGround() =>
            AssertRefused(new DrawnPicture(200, 200, s_White).Shade((x, y) => ((int)(x * 8) + (int)(y * 8)) % 2 * -200f), "No wing");

        [TestCase(31, 300)]
        [TestCase(300, 31)]
        [TestCase(1, 1)]
        public void SmallPicture_IsRefusedWithItsSize(int width, int height)
        {
            FormatException failure = Assert.Throws<FormatException>(() => WingPicture.FromGrey(width, height, new byte[width * height]));

            Assert.That(failure.Message, Does.Contain("too small").And.Contain($"{width} × {height}"));
        }

        [Test]
        public void WrongNumberOfPixels_IsRefused() =>
            Assert.That(() => new WingPicture(100, 100, new Color32[99]), Throws.ArgumentException.With.Message.Contains("10000"));

        [Test]
        public void NoPixelsOrTexture_AreRefused()
        {
            Assert.That(() => new WingPicture(100, 100, null), Throws.ArgumentNullException);
            Assert.That(() => WingPicture.FromGrey(100, 100, null), Throws.ArgumentNullException);
            Assert.That(() => WingPicture.FromTexture(null), Throws.ArgumentNullException);
            Assert.That(() => WingTracer.Trace(null, WingTracingSettings.Default), Throws.ArgumentNullException);
        }

        [TestCase(2, 5, 1000, 1f, "3 to 16 chains")]
        [TestCase(17, 5, 1000, 1f, "3 to 16 chains")]
        [TestCase(5, 2, 1000, 1f, "3 to 16 joints")]
        [TestCase(5, 5, 49, 1f, "50 to 200000")]
        [TestCase(5, 5, 1000, 0f, "above 0")]
        [TestCase(5, 5, 1000, float.NaN, "above 0")]
        public void SettingOutOfItsRange_IsRefused(int chains, int joints, int triangles, float length, string said)
        {
            var settings = new WingTracingSettings { chains = chains, jointsPerChain = joints, triangles = triangles, length = length };
            var picture = WingPicture.FromGrey(50, 50, new byte[2500]);

            Assert.That(
                () => WingTracer.Trace(picture, settings), Throws.TypeOf<ArgumentOutOfRangeException>().With.Message.Contains(said));
        }

        [Test]
        public void HingeOutsideThePicture_IsRefused()
        {
            WingTracingSettings settings = WingTracingSettings.Default;
            settings.hinge = new Vector2(51f, 10f);

            Assert.That(
                () => WingTracer.Trace(WingPicture.FromGrey(50, 50, new byte[2500]), settings),
                Throws.ArgumentException.With.Message.Contains("(51, 10)"));
        }

        [Test]
        public void DirectionThatIsNone_IsRefused()
        {
            WingTracingSettings settings = WingTracingSettings.Default;
            settings.forward = Vector2.zero;

            Assert.That(
                () => WingTracer.Trace(WingPicture.FromGrey(50, 50, new byte[2500]), settings),
                Throws.ArgumentException.With.Message.Contains("zero"));
        }

        private static Vector2[] Line(float ax, float ay, float bx, float by) => new[] { new Vector2(ax, ay), new Vector2(bx, by) };

        private static void AssertRefused(DrawnPicture picture, params string[] said)
        {
            FormatException failure = Assert.Throws<FormatException>(
                () => WingTracer.Trace(picture.ToPicture(), WingTracingSettings.Default));

            Assert.That(failure.Message, Does.Not.Contain("\n"));
            foreach (string part in said)
                Assert.That(failure.Message, Does.Contain(part));
        }
    }
}
