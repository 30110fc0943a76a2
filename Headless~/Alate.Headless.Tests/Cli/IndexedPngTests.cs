using System;
using System.Buffers.Binary;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using Alate.Formats;
using NUnit.Framework;
using Unity.StandIns;
using UnityEngine;

namespace Alate.Tests.Cli
{
    /// <summary>Pictures and films of 255 colours, read back by the decoder of the stand-ins, which knows nothing of the writer.</summary>
    public sealed class IndexedPngTests
    {
        private const int k_Width = 40, k_Height = 24;

        [Test]
        public void FewColours_AreKeptAsTheyAre()
        {
            Color32[] pixels = Picture((x, y) => new Color32((byte)(x / 4 * 25), (byte)(y / 8 * 80), 7, 255));
            var read = PngFile.Read(IndexedPng.Write(k_Width, k_Height, [pixels], 1, true, []));

            Assert.That(read.Width, Is.EqualTo(k_Width));
            Assert.That(read.Height, Is.EqualTo(k_Height));
            Assert.That(read.Pixels, Is.EqualTo(pixels));
        }

        [Test]
        public void ManyColours_StayNear_AndInTheMeanTheSame()
        {
            Color32[] pixels = Picture((x, y) => new Color32((byte)(6 * x), (byte)(10 * y), (byte)(3 * x + 5 * y), 255));
            Color32[] read = PngFile.Read(IndexedPng.Write(k_Width, k_Height, [pixels], 1, true, [])).Pixels;

            Assert.That(read.Distinct().Count(), Is.LessThanOrEqualTo(255));
            for (int k = 0; k < pixels.Length; k++)
            {
                Assert.That(Math.Abs(read[k].r - pixels[k].r) + Math.Abs(read[k].g - pixels[k].g) + Math.Abs(read[k].b - pixels[k].b),
                    Is.LessThan(60));
            }
            Assert.That(read.Average(pixel => pixel.g), Is.EqualTo(pixels.Average(pixel => pixel.g)).Within(1.5));
        }

        [Test]
        public void Film_HasItsFrames_EachWithWhatChanged()
        {
            var frames = Enumerable.Range(0, 3).Select(
                k => Picture((x, y) => x / 8 == k && y is > 4 and < 9 ? new Color32(200, 30, 0, 255) : new Color32(240, 240, 230, 255)))
                .ToList();
            byte[] film = IndexedPng.Write(k_Width, k_Height, frames, 24, true, ["a title"]);
            List<(string Name, byte[] Content)> chunks = Chunks(film);

            Assert.That(PngFile.Read(film).Pixels, Is.EqualTo(frames[0]), "programs that know no films show the first frame");
            Assert.That(chunks.Select(chunk => chunk.Name),
                Is.EqualTo(new[] { "IHDR", "iTXt", "PLTE", "tRNS", "acTL", "fcTL", "IDAT", "fcTL", "fdAT", "fcTL", "fdAT", "IEND" }));
            Assert.That(Number(chunks[4].Content, 0), Is.EqualTo(3));
            Assert.That(chunks.Where(chunk => chunk.Name is "fcTL" or "fdAT").Select(chunk => Number(chunk.Content, 0)),
                Is.EqualTo(new[] { 0, 1, 2, 3, 4 }));
            Assert.That(Encoding.UTF8.GetString(chunks[1].Content), Does.EndWith("a title"));
            var played = new ApngPlayer(film);
            Assert.That(played.Frames, Is.EqualTo(frames));
            Assert.That(played.Delays, Is.All.EqualTo(1.0 / 24.0).Within(1e-9));
            Assert.That((played.Width, played.Height, played.Repeats), Is.EqualTo((k_Width, k_Height, 0)));
        }

        [TestCase(1)]
        [TestCase(24)]
        [TestCase(300)]
        public void AFilmOnce_ShowsFramesThatCome_GoAndStay(int rate)
        {
            // A spot that wanders over another and off the edge, a frame as the one before, and the first one again.
            Color32 ground = new(250, 250, 250, 255), spot = new(200, 30, 0, 255), other = new(0, 60, 120, 255);
            Color32[] At(int left, int top) => Picture(
                (x, y) => x >= left && x < left + 5 && y >= top && y < top + 4 ? spot : x is > 10 and < 20 && y > 8 ? other : ground);
            Color32[][] frames = [At(-9, 0), At(36, 20), At(12, 9), At(13, 10), At(13, 10), At(0, 0), At(-9, 0)];
            var played = new ApngPlayer(IndexedPng.Write(k_Width, k_Height, frames, rate, false, []));

            Assert.That(played.Frames, Is.EqualTo(frames));
            Assert.That(played.Repeats, Is.EqualTo(1));
            Assert.That(played.Delays, Is.All.EqualTo(1.0 / rate).Within(1e-9));
        }

        private static List<(string Name, byte[] Content)> Chunks(byte[] file)
        {
            var chunks = new List<(string, byte[])>();
            for (int at = 8; at < file.Length;)
            {
                int length = Number(file, at);
                chunks.Add((Encoding.ASCII.GetString(file, at + 4, 4), file[(at + 8)..(at + 8 + length)]));
                at += 12 + length;
            }

            return chunks;
        }

        private static int Number(byte[] bytes, int at) => BinaryPrimitives.ReadInt32BigEndian(bytes.AsSpan(at));

        private static Color32[] Picture(Func<int, int, Color32> colourOf) =>
            Enumerable.Range(0, k_Width * k_Height).Select(k => colourOf(k % k_Width, k / k_Width)).ToArray();
    }
}
