using System;
using System.IO;
using System.Linq;
using Alate.Authoring;
using Alate.Cli;
using Alate.Editor.Tests;
using Unity.StandIns;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests.Cli
{
    /// <summary>Laws of the texture of a traced wing: no colour of the ground, and nothing of the wing changed.</summary>
    public sealed class TracedTextureLaws
    {
        private static readonly Color32 s_Blue = new Color32(90, 120, 220, 255), s_Brown = new Color32(70, 40, 20, 255),
            s_White = new Color32(255, 255, 255, 255), s_Black = new Color32(0, 0, 0, 255);

        private readonly WingPlace m_Place = DrawnWing.Scalloped().In(300);
        private string m_File;

        [SetUp]
        public void Name() => m_File = Path.Combine(Path.GetTempPath(), $"alate-{Guid.NewGuid():N}.png");

        [TearDown]
        public void Remove() => File.Delete(m_File);

        // Of a plain wing all pixels get its colour, and those of its inside keep theirs.
        [Test]
        public void OpaqueGround_TakesTheColoursOfTheWing()
        {
            Color32[] pixels = Texture(new DrawnPicture(300, 300, s_Blue).Fill(m_Place.Outline, s_Brown), out byte[] given);

            Assert.That(pixels.Max(pixel => Difference(pixel, s_Brown)), Is.AtMost(60), "a fifth of the 300 between both");
            Assert.That(pixels.Count(pixel => Difference(pixel, s_Brown) == 0),
                Is.GreaterThan(0.75 * pixels.Length), "the rest has a little of the blurred rim");
            Assert.That(File.ReadAllBytes(m_File), Is.EqualTo(given), "the user's file stays");
        }

        [Test]
        public void TheNearestColour_RunsOut()
        {
            float middle = m_Place.Outline.Average(point => point.x);
            DrawnPicture picture = new DrawnPicture(300, 300, s_White).Fill(m_Place.Outline, s_Brown);
            picture.Fill([.. m_Place.Outline.Select(point => new Vector2(Mathf.Max(middle, point.x), point.y))], s_Black);
            Color32[] pixels = Texture(picture, out _);

            foreach (int row in new[] { 0, 299 })
            {
                Assert.That(Difference(pixels[row * 300 + 40], s_Brown), Is.LessThan(60));
                Assert.That(Difference(pixels[row * 300 + 260], s_Black), Is.LessThan(60));
            }
        }

        // Its contrast is higher than that of the membrane behind it, so that it is no mixture with the ground.
        [Test]
        public void ADrawnMargin_StaysOnTheWing()
        {
            Color32[] pixels = Texture(m_Place.Draw(DrawnKind.Drawing), out byte[] given);
            var before = PngFile.Read(given);

            int dark = before.Pixels.Count(pixel => pixel.r < 100), stays = 0;
            for (int k = 0; k < pixels.Length; k++)
                stays += before.Pixels[k].r < 100 && pixels[k].r < 100 ? 1 : 0;
            Assert.That(stays, Is.GreaterThan(0.9 * dark));
        }

        [Test]
        public void TransparentGround_StaysAsItIs()
        {
            File.WriteAllBytes(m_File, PngOf.Picture(m_Place.Draw(DrawnKind.Transparent)));
            var picture = PictureFile.Read(m_File);

            Assert.That(TracedTexture.Png(picture, m_Place.Outline), Is.SameAs(picture.Bytes));
        }

        private Color32[] Texture(DrawnPicture drawn, out byte[] given)
        {
            given = PngOf.Picture(drawn);
            File.WriteAllBytes(m_File, given);
            var picture = PictureFile.Read(m_File);
            return PngFile.Read(TracedTexture.Png(picture, WingTracer.Trace(picture.Picture, WingTracingSettings.Default).Outline)).Pixels;
        }

        private static int Difference(Color32 a, Color32 b) => Math.Abs(a.r - b.r) + Math.Abs(a.g - b.g) + Math.Abs(a.b - b.b);
    }
}
