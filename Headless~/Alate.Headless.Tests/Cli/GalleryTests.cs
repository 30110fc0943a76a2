using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Alate.Catalogue;
using Alate.Drawing;
using NUnit.Framework;
using Unity.Mathematics;
using Unity.StandIns;
using UnityEngine;

namespace Alate.Tests.Cli
{
    /// <summary>The command that draws all species in one picture.</summary>
    public sealed class GalleryTests
    {
        private const int k_Width = 240, k_Column = 80, k_Row = 64;

        private static IEnumerable<int> Cells => Enumerable.Range(0, InsectCatalogue.All.Count);

        private CommandRun m_Run;
        private PngFile m_Picture;

        [OneTimeSetUp]
        public void Draw()
        {
            m_Run = new CommandRun();
            Assert.That(m_Run.Run("gallery", "--width", k_Width.ToString(), "--out", m_Run.Out), Is.Zero, m_Run.Errors);
            m_Picture = PngFile.Read(File.ReadAllBytes(Path.Combine(m_Run.Out, "insects.png")));
        }

        [OneTimeTearDown]
        public void RemoveFolder() => m_Run.Dispose();

        [Test]
        [Explicit]
        [Category("Long")]
        public void WithTheirWakes_InsectsAreSmaller_AndRingsFillTheCells()
        {
            using var run = new CommandRun();
            Assert.That(run.Run("gallery", "--wake", "--width", k_Width.ToString(), "--out", run.Out), Is.Zero, run.Errors);
            var picture = PngFile.Read(File.ReadAllBytes(Path.Combine(run.Out, "insects.png")));
            Color32 paper = m_Picture.Pixels[0];
            int Dark(PngFile one) => one.Pixels.Count(pixel => pixel.r + pixel.g + pixel.b < 200);

            Assert.That((picture.Width, picture.Height), Is.EqualTo((m_Picture.Width, m_Picture.Height)));
            Assert.That(Dark(picture), Is.LessThan(0.7 * Dark(m_Picture)));
            Assert.That(picture.Pixels.Count(pixel => pixel.b > pixel.r + 15), Is.GreaterThan(300), "blue rings");
            Assert.That(picture.Pixels[0], Is.EqualTo(paper));
        }

        // The same ground as that of every other page and photo.
        [Test]
        public void ThePaper_IsThatOfThePages()
        {
            var paper = (int3)math.round(255f * Shading.Paper);
            Color32 corner = m_Picture.Pixels[0];
            Assert.That((corner.r, corner.g, corner.b), Is.EqualTo(((byte)paper.x, (byte)paper.y, (byte)paper.z)));
            Assert.That(paper.x, Is.GreaterThan(paper.y).And.GreaterThan(paper.z), "a warm white");
            Assert.That(paper.y, Is.GreaterThan(paper.z));
        }

        [Test]
        public void ThePicture_HasACellForEachSpecies()
        {
            Assert.That(m_Picture.Width, Is.EqualTo(k_Width));
            Assert.That(m_Picture.Height, Is.EqualTo((InsectCatalogue.All.Count + 2) / 3 * k_Row));
        }

        [Test]
        public void EveryCell_ShowsAnInsect_WithPaperAroundIt([ValueSource(nameof(Cells))] int cell)
        {
            int count = InsectCatalogue.All.Count, inRow = Math.Min(3, count - cell / 3 * 3);
            int left = cell % 3 * k_Column + (3 - inRow) * k_Column / 2, top = cell / 3 * k_Row;
            Color32 paper = At(0, 0);
            int drawn = 0;
            for (int y = 0; y < k_Row; y++)
            {
                for (int x = 0; x < k_Column; x++)
                {
                    bool isDrawn = !At(left + x, top + y).Equals(paper);
                    drawn += isDrawn ? 1 : 0;
                    if (x < 2 || y < 2 || x >= k_Column - 2 || y >= k_Row - 2)
                        Assert.That(isDrawn, Is.False, $"{x}, {y}");
                }
            }

            Assert.That(drawn / (double)(k_Column * k_Row), Is.InRange(0.1, 0.7));
        }

        [Test]
        public void TheFirst_IsAMonarch() => Assert.That(
            m_Picture.Pixels.Where((pixel, k) =>
                k % k_Width < k_Column && k / k_Width < k_Row && pixel.r > 180 && pixel.g is > 70 and < 150 && pixel.b < 70).Count(),
            Is.GreaterThan(200));

        [TestCase("10", "between 90 and 3000")]
        [TestCase("100000", "between 90 and 3000")]
        [TestCase("wide", "whole number")]
        public void AnImpossibleWidth_IsRefused_WithWhatIsAllowed(string width, string allowed)
        {
            using var run = new CommandRun();

            Assert.That(run.Run("gallery", "--width", width, "--out", run.Out), Is.EqualTo(2));
            Assert.That(run.Errors, Does.Contain("--width").And.Contain(allowed).And.Contain(width));
        }

        private Color32 At(int x, int y) => m_Picture.Pixels[y * k_Width + x];
    }
}
