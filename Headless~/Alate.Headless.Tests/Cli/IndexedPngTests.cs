using System;
using System.Buffers.Binary;
using System.Collections.Generic;
using System.IO;
using System.IO.Compression;
using System.Linq;
using System.Text;
using Alate.Cli.Pictures.Png;
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
            var read = PngFile.Read(IndexedPng.Write(k_Width, k_Height, pixels, []));

            Assert.That(read.Width, Is.EqualTo(k_Width));
            Assert.That(read.Height, Is.EqualTo(k_Height));
            Assert.That(read.Pixels, Is.EqualTo(pixels));
        }

        [Test]
        public void ManyColours_StayNear_AndInTheMeanTheSame()
        {
            Color32[] pixels = Picture((x, y) => new Color32((byte)(6 * x), (byte)(10 * y), (byte)(3 * x + 5 * y), 255));
            Color32[] read = PngFile.Read(IndexedPng.Write(k_Width, k_Height, pixels, [])).Pixels;

            Assert.That(read.Distinct().Count(), Is.LessThanOrEqualTo(255));
            for (int k = 0; k < pixels.Length; k++)
                Assert.That(Math.Abs(read[k].r - pixels[k].r) + Math.Abs(read[k].g - pixels[k].g) + Math.Abs(read[k].b - pixels[k].b), Is.LessThan(60));
            Assert.That(read.Average(pixel => pixel.g), Is.EqualTo(pixels.Average(pixel => pixel.g)).Within(1.5));
        }

        [Test]
        public void Film_HasItsFrames_EachWithWhatChanged()
        {
            var frames = Enumerable.Range(0, 3).Select(k => Picture((x, y) => x / 8 == k && y is > 4 and < 9 ? new Color32(200, 30, 0, 255) : new Color32(240, 240, 230, 255))).ToList();
            byte[] film = IndexedPng.Write(k_Width, k_Height, frames, 24, true, ["a title"]);
            List<(string Name, byte[] Content)> chunks = Chunks(film);

            Assert.That(PngFile.Read(film).Pixels, Is.EqualTo(frames[0]), "programs that know no films show the first frame");
            Assert.That(chunks.Select(chunk => chunk.Name), Is.EqualTo(new[] { "IHDR", "iTXt", "PLTE", "tRNS", "acTL", "fcTL", "IDAT", "fcTL", "fdAT", "fcTL", "fdAT", "IEND" }));
            Assert.That(Number(chunks[4].Content, 0), Is.EqualTo(3));
            Assert.That(chunks.Where(chunk => chunk.Name is "fcTL" or "fdAT").Select(chunk => Number(chunk.Content, 0)), Is.EqualTo(new[] { 0, 1, 2, 3, 4 }));
            Assert.That(Encoding.UTF8.GetString(chunks[1].Content), Does.EndWith("a title"));
            Assert.That(Played(chunks), Is.EqualTo(frames));
        }

        // As a viewer plays it: each frame's pixels over the picture so far, where they are not see-through.
        private static List<Color32[]> Played(List<(string Name, byte[] Content)> chunks)
        {
            byte[] palette = chunks.First(chunk => chunk.Name == "PLTE").Content;
            var shown = new Color32[k_Width * k_Height];
            var played = new List<Color32[]>();
            for (int k = 0; k < chunks.Count; k++)
            {
                if (chunks[k].Name != "fcTL")
                    continue;
                int width = Number(chunks[k].Content, 4), height = Number(chunks[k].Content, 8), left = Number(chunks[k].Content, 12), top = Number(chunks[k].Content, 16);
                Assert.That(BinaryPrimitives.ReadUInt16BigEndian(chunks[k].Content.AsSpan(22)), Is.EqualTo(24), "frames a second");
                byte[] packed = chunks[k + 1].Content[(chunks[k + 1].Name == "fdAT" ? 4 : 0)..];
                using var zlib = new ZLibStream(new MemoryStream(packed), CompressionMode.Decompress);
                byte[] rows = new byte[height * (width + 1)];
                zlib.ReadExactly(rows);
                for (int y = 0; y < height; y++)
                {
                    for (int x = 0; x < width; x++)
                    {
                        int entry = rows[y * (width + 1) + 1 + x];
                        if (entry > 0)
                            shown[(top + y) * k_Width + left + x] = new Color32(palette[3 * entry], palette[3 * entry + 1], palette[3 * entry + 2], 255);
                    }
                }

                played.Add((Color32[])shown.Clone());
            }

            return played;
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

        private static Color32[] Picture(Func<int, int, Color32> colourOf) => Enumerable.Range(0, k_Width * k_Height).Select(k => colourOf(k % k_Width, k / k_Width)).ToArray();
    }
}
