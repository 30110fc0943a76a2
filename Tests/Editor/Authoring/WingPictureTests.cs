using Alate.Authoring;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    public sealed class WingPictureTests
    {
        private Texture2D m_Texture;

        [SetUp]
        public void MakeTexture()
        {
            m_Texture = new Texture2D(40, 50);
            var pixels = new Color32[40 * 50];
            for (int k = 0; k < pixels.Length; k++)
                pixels[k] = new Color32((byte)(k % 40), (byte)(k / 40), 7, 255);
            m_Texture.SetPixels32(pixels);
            m_Texture.Apply();
        }

        [TearDown]
        public void DestroyTexture() => Object.DestroyImmediate(m_Texture);

        [Test]
        public void Picture_BeginsWithTheTexturesHighestRow()
        {
            var picture = WingPicture.FromTexture(m_Texture);

            Assert.That((picture.Width, picture.Height), Is.EqualTo((40, 50)));
            Assert.That(picture[3, 0], Is.EqualTo(new Color32(3, 49, 7, 255)));
            Assert.That(picture[0, 49], Is.EqualTo(new Color32(0, 0, 7, 255)));
            Assert.That(picture[39, 25], Is.EqualTo(new Color32(39, 24, 7, 255)));
        }

        [Test]
        public void TextureThatIsNotReadable_IsRefusedByItsName()
        {
            m_Texture.name = "my wing";
            m_Texture.Apply(false, true);

            Assert.That(() => WingPicture.FromTexture(m_Texture), Throws.ArgumentException.With.Message.Contains("my wing").And.Message
                .Contains("Read/Write"));
        }

        [Test]
        public void PngInATexture_IsTracedLikeItsPixels()
        {
            DrawnPicture drawn = DrawnWing.Fan().In(200).Draw(DrawnKind.Gradient);
            Color32[] pixels = drawn.ToPixels();
            var texture = new Texture2D(200, 200);
            for (int k = 0; k < pixels.Length; k++)
                texture.SetPixel(k % 200, 199 - k / 200, pixels[k]);
            byte[] png = texture.EncodeToPNG();
            Assert.That(m_Texture.LoadImage(png), Is.True);

            WingTrace trace = WingTracer.Trace(WingPicture.FromTexture(m_Texture), WingTracingSettings.Default);

            Assert.That(trace.Outline, Is.EqualTo(WingTracer.Trace(drawn.ToPicture(), WingTracingSettings.Default).Outline));
            Object.DestroyImmediate(texture);
        }
    }
}
