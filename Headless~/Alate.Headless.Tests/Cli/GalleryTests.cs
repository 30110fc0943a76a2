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
        private const int k_Width = 240;

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

            Assert.That(picture.Width, Is.EqualTo(m_Picture.Width));
            Assert.That(Dark(picture), Is.LessThan(0.7 * Dark(m_Picture)));
            Assert.That(picture.Pixels.Count(pixel => pixel.b > pixel.r + 15), Is.GreaterThan(300), "blue rings");
            Assert.That(picture.Pixels[0], Is.EqualTo(paper));
        }

        [Test]
        public void ATransparentPicture_OnPaper_IsThePictureOnPaper()
        {
            Color32[] Drawn(params string[] options)
            {
                using var run = new CommandRun();
                Assert.That(run.Run(["gallery", "monarch", "--width", "160", "--out", run.Out, .. options]), Is.Zero, run.Errors);
                return PngFile.Read(File.ReadAllBytes(Path.Combine(run.Out, "insects.png"))).Pixels;
            }

            Color32[] paper = Drawn(), cut = Drawn("--transparent");
            float3 ground = 255f * Shading.Paper;
            float off = cut.Zip(paper, (over, seen) => math.cmax(math.abs(
                math.lerp(ground, new float3(over.r, over.g, over.b), over.a / 255f) - new float3(seen.r, seen.g, seen.b)))).Max();
            Assert.That(off, Is.LessThan(12f), "of 255");
            Assert.That((cut[0].a, paper.Min(pixel => pixel.a)), Is.EqualTo((0, 255)));
            Assert.That(cut.Count(pixel => pixel.a == 255), Is.GreaterThan(cut.Length / 20));
        }

        // Front, side, above, below; head, wing base, apex, at rest.
        [Test]
        public void ASheet_ShowsAllSides_ThePaleOneToo_AndPartsFromNearBy()
        {
            using var run = new CommandRun();
            Assert.That(run.Run("gallery", "monarch", "--sheets", "--width", "480", "--out", run.Out), Is.Zero, run.Errors);
            var sheet = PngFile.Read(File.ReadAllBytes(Path.Combine(run.Out, "sheet-monarch.png")));
            Assert.That(Directory.GetFiles(run.Out), Has.Length.EqualTo(1));
            Assert.That(sheet.Width, Is.EqualTo(480));
            Color32[][] panels = [.. Enumerable.Range(0, 8).Select(panel => sheet.Pixels.Where((_, k) =>
                k % 480 / 120 == panel % 4 && k / 480 / (sheet.Height / 2) == panel / 4).ToArray())];
            foreach (Color32[] panel in panels)
                Assert.That(Seen(panel), Is.InRange(0.03 * panel.Length, 0.95 * panel.Length));
            Assert.That(Orange(panels[2]), Is.GreaterThan(1.3 * Orange(panels[3])), "paler below");
            Assert.That(Seen(panels[6]), Is.GreaterThan(2 * Seen(panels[2])), "the apex from near by");
            Assert.That(panels[6].Count(pixel => pixel.r < 60), Is.GreaterThan(0.5 * Seen(panels[6])), "which is dark");

            Assert.That(run.Run("gallery", "monarch", "--sheets", "--wake", "--out", run.Out), Is.EqualTo(2));
            Assert.That(run.Errors, Does.Contain("--sheets shows insects on paper"));

            int Seen(Color32[] panel) => panel.Count(pixel => !pixel.Equals(sheet.Pixels[0]));

            static double Orange(Color32[] panel) =>
                panel.Where(pixel => pixel.r > 1.5 * pixel.b).Average(pixel => (pixel.r - pixel.b) / 255.0);
        }

        [Test]
        public void BeforeAWall_InsectsAreThoseOnPaper_AndTheirShadowsGoBeyondTheirPanels()
        {
            using var run = new CommandRun();
            PngFile Drawn(params string[] options)
            {
                string[] words = ["gallery", "firefly", "dragonfly", "--width", "240", "--out", run.Out, .. options];
                Assert.That(run.Run(words), Is.Zero, run.Errors);
                return PngFile.Read(File.ReadAllBytes(Path.Combine(run.Out, "insects.png")));
            }

            PngFile cut = Drawn("--transparent"), dark = Drawn("--backdrop", "dark");
            Assert.That((dark.Width, dark.Height), Is.EqualTo((cut.Width, cut.Height)));
            Assert.That(dark.Pixels.All(pixel => pixel.a == 255), Is.True);
            for (int k = 0; k < cut.Pixels.Length; k++)
            {
                if (cut.Pixels[k].a == 255)
                    Assert.That(Math.Abs(cut.Pixels[k].g - dark.Pixels[k].g), Is.LessThanOrEqualTo(1));
            }

            Assert.That(dark.Pixels[0].b, Is.LessThan(0x38), "a dim corner");
            Assert.That(run.Run("gallery", "--transparent", "--backdrop", "studio", "--out", run.Out), Is.EqualTo(2));
            Assert.That(run.Errors, Does.Contain("--transparent leaves nothing behind the insects; it does not go with --backdrop."));
            Assert.That(run.Run("gallery", "--backdrop", "paper", "--out", run.Out), Is.EqualTo(2));
            Assert.That(run.Errors, Does.Contain("--backdrop takes studio or dark, not 'paper'."));
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
        public void EverySpecies_IsSeenApart_InRowsThatFillThePage()
        {
            List<(int2 Min, int2 Max, int Drawn)> insects = Insects();
            Assert.That(m_Picture.Width, Is.EqualTo(k_Width));
            Assert.That(m_Picture.Height / (double)k_Width, Is.InRange(0.55, 0.95));
            Assert.That(insects, Has.Count.EqualTo(InsectCatalogue.All.Count));
            foreach ((int2 min, int2 max, int drawn) in insects)
            {
                int2 size = max - min + 1;
                Assert.That(drawn / (double)(size.x * size.y), Is.InRange(0.1, 0.8), "not a box, not a line");
                Assert.That(math.all(min >= 4) && max.x < k_Width - 4 && max.y < m_Picture.Height - 4, Is.True, "paper around");
                (int2 Min, int2 Max, int Drawn)[] row = [.. insects.Where(other => other.Min.y < max.y - 8 && other.Max.y > min.y + 8)];
                Assert.That(row.Min(other => other.Min.x), Is.LessThan(16), "from the left");
                Assert.That(row.Max(other => other.Max.x), Is.GreaterThan(k_Width - 16), "to the right");
                Assert.That(row.Max(other => other.Max.y - other.Min.y) - row.Min(other => other.Max.y - other.Min.y), Is.LessThan(6));
            }
        }

        [Test]
        public void TheFirst_IsAMonarch()
        {
            (int2 min, int2 max, int _) = Insects().OrderBy(insect => insect.Min.y / 20).ThenBy(insect => insect.Min.x).First();
            bool IsIn(int2 place) => math.all(place >= min) && math.all(place <= max);
            Assert.That(
                m_Picture.Pixels.Where((pixel, k) =>
                    IsIn(new int2(k % k_Width, k / k_Width)) && pixel.r > 180 && pixel.g is > 70 and < 150 && pixel.b < 70).Count(),
                Is.GreaterThan(200));
        }

        [TestCase("10", "between 90 and 3000")]
        [TestCase("100000", "between 90 and 3000")]
        [TestCase("wide", "whole number")]
        public void AnImpossibleWidth_IsRefused_WithWhatIsAllowed(string width, string allowed)
        {
            using var run = new CommandRun();

            Assert.That(run.Run("gallery", "--width", width, "--out", run.Out), Is.EqualTo(2));
            Assert.That(run.Errors, Does.Contain("--width").And.Contain(allowed).And.Contain(width));
        }

        // What is drawn, where gaps of four pixels are none: antennae are thin.
        private List<(int2 Min, int2 Max, int Drawn)> Insects()
        {
            const int k_Near = 4;
            Color32 paper = m_Picture.Pixels[0];
            HashSet<int> left = [.. Enumerable.Range(0, m_Picture.Pixels.Length).Where(k => !m_Picture.Pixels[k].Equals(paper))];
            var insects = new List<(int2, int2, int)>();
            while (left.Count > 0)
            {
                int2 min = int.MaxValue, max = int.MinValue;
                int drawn = 0;
                var next = new Stack<int>([left.First()]);
                left.Remove(next.Peek());
                while (next.TryPop(out int pixel))
                {
                    var place = new int2(pixel % k_Width, pixel / k_Width);
                    (min, max, drawn) = (math.min(min, place), math.max(max, place), drawn + 1);
                    for (int k = 0; k < (2 * k_Near + 1) * (2 * k_Near + 1); k++)
                    {
                        int2 other = place + new int2(k % (2 * k_Near + 1), k / (2 * k_Near + 1)) - k_Near;
                        if (other.x is >= 0 and < k_Width && left.Remove(other.y * k_Width + other.x))
                            next.Push(other.y * k_Width + other.x);
                    }
                }

                insects.Add((min, max, drawn));
            }

            return insects;
        }
    }
}
