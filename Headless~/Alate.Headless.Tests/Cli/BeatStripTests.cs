using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text.RegularExpressions;
using Alate.Cli;
using Alate.Drawing;
using NUnit.Framework;
using Unity.Mathematics;
using Unity.StandIns;
using UnityEngine;

namespace Alate.Tests.Cli
{
    /// <summary>Content of the strip of a flight, read back from its pixels and its labels.</summary>
    [Explicit]
    [Category("Long")]
    [Category("Faults")]
    public sealed class BeatStripTests
    {
        private const int k_Phases = 12;

        private PngFile m_Picture;
        private PixelPage m_Page;
        private StripLayout m_Layout;
        private List<List<int2>> m_Panels;

        [OneTimeSetUp]
        public void Draw()
        {
            m_Page = BeatStrip.Compose(MonarchFlight.Level, out m_Layout);
            m_Picture = PngFile.Read(m_Page.Write());
            m_Panels = Enumerable.Range(0, k_Phases).Select(k => Painted(m_Picture, m_Layout[k])).ToList();
        }

        [Test]
        public void Edges_ArePaper()
        {
            Color32 paper = m_Picture.Pixels[0];
            for (int k = 0; k < m_Picture.Pixels.Length; k++)
            {
                int x = k % m_Picture.Width, y = k / m_Picture.Width;
                if (x < 8 || y < 8 || x >= m_Picture.Width - 8 || y >= m_Picture.Height - 8)
                    Assert.That(m_Picture.Pixels[k], Is.EqualTo(paper), $"{x}, {y}");
            }
        }

        [Test]
        public void AllPhases_HaveOneScale() =>
            Assert.That(Enumerable.Range(0, k_Phases).Select(k => m_Layout[k].Scale).Distinct().Count(), Is.EqualTo(1));

        [Test]
        public void TheWings_AreHighAtTheStart_AndLowHalfABeatLater()
        {
            // Within a row, where the body lies at the same place; y points down.
            Assert.That(Top(0), Is.LessThan(Top(3) - 30));
            Assert.That(Bottom(6), Is.GreaterThan(Bottom(4) + 30));
        }

        [Test]
        public void EveryPhase_IsAPoseOfItsOwn()
        {
            Assert.That(
                m_Panels.Select(panel => (panel.Count, panel.Min(pixel => pixel.y), panel.Max(pixel => pixel.x))).Distinct().Count(),
                Is.EqualTo(k_Phases));
            Assert.That(m_Panels.Select(panel => panel.Count), Is.All.GreaterThan(500));
        }

        [Test]
        public void UnderEachPhase_StandItsAngleAndItsTime()
        {
            double period = 1000.0 / MonarchFlight.Level.Wings[0].Frequency;
            double[] told = m_Page.Texts.Where(text => Regex.IsMatch(text, "^[0-9.]+ ms$"))
                .Select(text => double.Parse(text[..^3], CultureInfo.InvariantCulture)).ToArray();

            Assert.That(told, Is.EqualTo(Enumerable.Range(0, k_Phases).Select(k => k * period / k_Phases)).Within(0.051));
            Assert.That(
                m_Page.Texts.Where(text => text.EndsWith("°")), Is.EqualTo(Enumerable.Range(0, k_Phases).Select(k => $"{30 * k}°")));
        }

        [Test]
        public void TheMonarch_IsOrange()
        {
            Color32[] painted = m_Panels[4].Select(pixel => m_Picture.Pixels[pixel.y * m_Picture.Width + pixel.x]).ToArray();
            Assert.That(painted.Count(colour => colour.r > colour.g + 50 && colour.g > colour.b + 50), Is.GreaterThan(painted.Length / 3));
        }

        [Test]
        [Explicit]
        [Category("Long")]
        public void TheFileIsTheSame_EachTimeAndWhateverTheCulture()
        {
            byte[] file = BeatStrip.Draw(MonarchFlight.Level);
            using (new CommaCulture())
                Assert.That(BeatStrip.Draw(MonarchFlight.Level), Is.EqualTo(file));
        }

        [Test]
        public void ItsTexts_AreTheSame_WhateverTheCulture()
        {
            using (new CommaCulture())
                Assert.That(BeatStrip.Compose(MonarchFlight.Level, out _).Texts, Is.EqualTo(m_Page.Texts));
        }

        [Test]
        [Explicit]
        [Category("Long")]
        public void AWingWithoutColours_IsDrawnToo()
        {
            using var run = new CommandRun();
            var plan = new FlightPlan
            {
                Species = "monarch",
                MeshFile = run.Write("R&D.obj", OwnWing.Obj()),
                SkeletonFile = run.Write("wing.json", OwnWing.Skeleton()),
                Seconds = 0.2,
            };
            FlightRecord flight = MonarchFlight.Fly(plan);
            var picture = PngFile.Read(BeatStrip.Draw(flight));
            PixelPage page = BeatStrip.Compose(flight, out StripLayout layout);

            for (int k = 0; k < k_Phases; k++)
                Assert.That(Painted(picture, layout[k]), Has.Count.GreaterThan(100));
            Assert.That(page.Texts[0], Is.EqualTo("R&D"));
        }

        private int Top(int panel) => m_Panels[panel].Min(pixel => pixel.y);

        private int Bottom(int panel) => m_Panels[panel].Max(pixel => pixel.y);

        // Pixels of a panel that are not paper.
        private static List<int2> Painted(PngFile picture, StripPanel panel)
        {
            var painted = new List<int2>();
            Color32 paper = picture.Pixels[0];
            for (int y = (int)(PixelPage.Fineness * panel.Top); y < PixelPage.Fineness * (panel.Top + panel.Height) - 14; y++)
            {
                for (int x = (int)(PixelPage.Fineness * panel.Left); x < Math.Min(
                    PixelPage.Fineness * (panel.Left + panel.Width), picture.Width); x++)
                {
                    Color32 pixel = picture.Pixels[y * picture.Width + x];
                    if (Math.Abs(pixel.r - paper.r) + Math.Abs(pixel.g - paper.g) + Math.Abs(pixel.b - paper.b) > 12)
                        painted.Add(new int2(x, y));
                }
            }

            return painted;
        }
    }
}
