using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Alate.Cli;
using NUnit.Framework;
using Unity.StandIns;
using UnityEngine;

namespace Alate.Tests.Cli
{
    /// <summary>JPEG pictures of wings, and the turn that a camera writes beside a picture.</summary>
    public sealed class CameraPictureTests
    {
        private CommandRun m_Run;

        [SetUp]
        public void MakeFolder() => m_Run = new CommandRun();

        [TearDown]
        public void RemoveFolder() => m_Run.Dispose();

        // Pale ground; a wing from the left, red before and ochre behind.
        [Test]
        public void Jpegs_HaveTheirColours([Values("base", "progressive")] string kind)
        {
            PictureFile picture = Read("wing.jpg", CameraPicture.Of(kind));

            Assert.That((picture.Picture.Width, picture.Picture.Height), Is.EqualTo((120, 72)));
            AssertColour(picture.Picture[5, 5], 245, 245, 240);
            AssertColour(picture.Picture[60, 30], 155, 90, 40);
            AssertColour(picture.Picture[60, 46], 170, 150, 40);
            AssertColour(picture.Picture[118, 66], 245, 245, 240);
            var png = PngFile.Read(picture.Bytes);
            Assert.That((png.Width, png.Height), Is.EqualTo((120, 72)));
            AssertColour(png.Pixels[30 * 120 + 60], 155, 90, 40);
        }

        [Test]
        public void AGreyJpeg_IsRead()
        {
            PictureFile picture = Read("wing.jpeg", CameraPicture.Of("grey"));
            Color32 wing = picture.Picture[60, 30];
            Assert.That(wing.r, Is.EqualTo(wing.g).And.EqualTo(wing.b).And.InRange(80, 125));
        }

        /// <summary>Sides where the first row and the first column are, as Exif 2.32 names them.</summary>
        [TestCase(1, "top", "left")]
        [TestCase(2, "top", "right")]
        [TestCase(3, "bottom", "right")]
        [TestCase(4, "bottom", "left")]
        [TestCase(5, "left", "top")]
        [TestCase(6, "right", "top")]
        [TestCase(7, "right", "bottom")]
        [TestCase(8, "left", "bottom")]
        public void APicture_IsTurnedAsTheCameraSays(int orientation, string firstRow, string firstColumn)
        {
            // Three columns and two rows, as they lie in the file.
            Color32[] pixels = [.. Enumerable.Range(1, 6).Select(k => new Color32((byte)k, 0, 0, 255))];
            int width = 3, height = 2;
            Color32[] turned = ExifTurn.Upright(orientation, ref width, ref height, pixels);

            Assert.That((width, height), Is.EqualTo(firstRow is "top" or "bottom" ? (3, 2) : (2, 3)));
            byte[] Side(string side) => [.. side switch
            {
                "top" => Enumerable.Range(0, width).Select(x => turned[x].r),
                "bottom" => Enumerable.Range(0, width).Select(x => turned[(height - 1) * width + x].r),
                "left" => Enumerable.Range(0, height).Select(y => turned[y * width].r),
                _ => Enumerable.Range(0, height).Select(y => turned[y * width + width - 1].r),
            }];
            Assert.That(Side(firstRow), Is.EquivalentTo(new[] { 1, 2, 3 }), "the first row");
            Assert.That(Side(firstColumn), Is.EquivalentTo(new[] { 1, 4 }), "the first column");
        }

        [Test]
        public void TheTurn_IsReadFromJpegAndPng_OfBothByteOrders([Values(1, 3, 6, 8)] int orientation, [Values] bool little)
        {
            byte[] exif = CameraPicture.Exif(orientation, little);
            PictureFile upright = Read("plain.jpg", CameraPicture.Of("base"));
            PictureFile jpeg = Read("turned.jpg", CameraPicture.WithExif(CameraPicture.Of("base"), exif));
            PictureFile png = Read("turned.png", CameraPicture.WithExif(upright.Bytes, exif));

            int width = 120, height = 72;
            Color32[] pixels = Enumerable.Range(0, width * height).Select(k => upright.Picture[k % 120, k / 120]).ToArray();
            Color32[] expected = ExifTurn.Upright(orientation, ref width, ref height, pixels);
            foreach (PictureFile turned in new[] { jpeg, png })
            {
                Assert.That((turned.Picture.Width, turned.Picture.Height), Is.EqualTo((width, height)));
                Assert.That(PngFile.Read(turned.Bytes).Pixels.Select(pixel => pixel.r), Is.EqualTo(expected.Select(pixel => pixel.r)));
                Assert.That(turned.Picture[7, 31].r, Is.EqualTo(expected[31 * width + 7].r));
            }
        }

        private static IEnumerable<TestCaseData> NoExif()
        {
            byte[] whole = CameraPicture.Exif(6, true);
            for (int length = 0; length < 34; length += 3)
                yield return new TestCaseData(whole[..length]).SetArgDisplayNames($"{length} bytes");
            foreach (int orientation in new[] { 0, 9, 65535 })
                yield return new TestCaseData(CameraPicture.Exif(orientation, false)).SetArgDisplayNames($"orientation {orientation}");
        }

        [TestCaseSource(nameof(NoExif))]
        public void AnExifThatIsDamaged_SaysNothing(byte[] exif) => Assert.That(ExifTurn.Of(exif), Is.EqualTo(1));

        [Test]
        public void AJpeg_IsAsLongAsItsLongestSide()
        {
            byte[] file = CameraPicture.Of("base");
            var whole = JpegFile.Read(file, int.MaxValue);
            int longest = Math.Max(whole.Width, whole.Height), shortest = Math.Min(whole.Width, whole.Height);
            Assert.That(shortest, Is.LessThan(longest));
            Assert.That(JpegFile.Read(file, longest).Pixels, Has.Length.EqualTo(longest * shortest));
            Assert.That(() => JpegFile.Read(file, longest - 1),
                Throws.TypeOf<FormatException>().With.Message.Contains($"{longest - 1} a side"));
        }

        [Test]
        public void ADamagedJpeg_IsRefused_OrRead() => AssertReadOrRefused(90);

        [Test]
        [Explicit]
        [Category("Long")]
        public void ManyDamagedJpegs_AreRefused_OrRead() => AssertReadOrRefused(300);

        private void AssertReadOrRefused(int count)
        {
            byte[] whole = CameraPicture.Of("base");
            var random = new System.Random(5);
            for (int k = 0; k < count; k++)
            {
                byte[] bytes = k % 3 == 0 ? whole[..random.Next(3, whole.Length - 2)] : [.. whole];
                for (int n = 0; k % 3 != 0 && n < 4; n++)
                    bytes[random.Next(3, bytes.Length)] = (byte)random.Next(256);
                string file = Path.Combine(m_Run.Folder, "damaged.jpg");
                File.WriteAllBytes(file, bytes);
                try
                {
                    PictureFile.Read(file);
                    Assert.That(k % 3, Is.Not.Zero, "a picture that is cut off is refused");
                }
                catch (UserException problem)
                {
                    Assert.That(problem.Message, Does.Contain("damaged.jpg").And.Not.Contain("\n"));
                }
            }
        }

        [Test]
        public void AJpeg_BecomesAWing()
        {
            string image = Write("wing.jpg", CameraPicture.WithExif(CameraPicture.Of("base"), CameraPicture.Exif(3, true)));
            Assert.That(m_Run.Run("skeleton", "from-image", image, "--leading", "down", "--out", m_Run.Out), Is.Zero, m_Run.Errors);
            Assert.That(m_Run.Output, Does.Contain("1000 triangles"));
            Assert.That(PngFile.Read(File.ReadAllBytes(Path.Combine(m_Run.Out, "wing.png"))).Width, Is.EqualTo(120));
        }

        private PictureFile Read(string name, byte[] bytes) => PictureFile.Read(Write(name, bytes));

        private string Write(string name, byte[] bytes)
        {
            string file = Path.Combine(m_Run.Folder, name);
            File.WriteAllBytes(file, bytes);
            return file;
        }

        private static void AssertColour(Color32 colour, int red, int green, int blue) => Assert.That(
            Math.Abs(colour.r - red) + Math.Abs(colour.g - green) + Math.Abs(colour.b - blue), Is.LessThan(45), colour.ToString());
    }
}
