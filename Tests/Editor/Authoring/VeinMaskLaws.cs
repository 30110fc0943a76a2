using Alate.Authoring;
using NUnit.Framework;

namespace Alate.Editor.Tests
{
    /// <summary>Laws of the pixels that are taken for veins where much of the wing shows lines.</summary>
    public sealed class VeinMaskLaws
    {
        [Test]
        public void WhereFaintStretchesCoverTooMuch_OnlyTheStrongestCount()
        {
            // Three tenths of the wing have a grain of 10: what is hardly above it is grain too.
            var response = new PixelPlane(200, 70);
            var wing = new PixelMask(200, 70);
            for (int k = 0; k < response.values.Length; k++)
            {
                wing[k % 200, k / 200] = true;
                response.values[k] = k < 200 * 21 ? 10f : 0f;
            }

            for (int x = 20; x < 100; x++)
            {
                response[x, 40] = 12f;
                response[x, 55] = 20f;
            }

            PixelMask veins = VeinMask.Of(response, wing, 200.0);

            Assert.That(veins[60, 40], Is.False, "hardly above the grain");
            Assert.That(veins[60, 55], Is.True, "twice the grain");
            Assert.That(veins.Count, Is.EqualTo(80));
        }
    }
}
