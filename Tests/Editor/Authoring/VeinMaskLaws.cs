using Alate.Authoring;
using NUnit.Framework;

namespace Alate.Editor.Tests
{
    /// <summary>Laws of the pixels that are taken for veins: sure lines, faint ones that hang on them, and grain.</summary>
    public sealed class VeinMaskLaws
    {
        [Test]
        public void WhereFaintStretchesCoverTooMuch_OnlyTheStrongestCount()
        {
            // Three tenths of the wing have a grain of 10: what is hardly above it is grain too.
            var response = new PixelPlane(200, 70);
            for (int k = 0; k < response.values.Length; k++)
                response.values[k] = k < 200 * 21 ? 10f : 0f;

            for (int x = 20; x < 100; x++)
            {
                response[x, 40] = 12f;
                response[x, 55] = 20f;
            }

            PixelMask veins = VeinMask.Of(response, Whole(), 200.0);

            Assert.That(veins[60, 40], Is.False, "hardly above the grain");
            Assert.That(veins[60, 55], Is.True, "twice the grain");
            Assert.That(veins.Count, Is.EqualTo(80));
        }

        [Test]
        public void Veins_AreSureLines_AndFaintOnesThatHangOnThem_LongEnough()
        {
            // Half of the wing has a faint grain of 2; sure is five times the median, at least 3.
            var response = new PixelPlane(200, 70);
            for (int k = 0; k < response.values.Length; k++)
                response.values[k] = 0.1f * (k % 5);
            void Line(int row, int from, int to, float value)
            {
                for (int x = from; x < to; x++)
                    response[x, row] = value;
            }

            Line(10, 20, 60, 20f);
            Line(10, 60, 100, 1.8f);
            Line(25, 20, 100, 1.8f);
            Line(40, 20, 31, 20f);
            Line(55, 20, 33, 20f);
            PixelMask veins = VeinMask.Of(response, Whole(), 200.0);

            Assert.That((veins[40, 10], veins[80, 10]), Is.EqualTo((true, true)), "a faint stretch of a sure line");
            Assert.That(veins[40, 25], Is.False, "faint alone");
            Assert.That(veins[25, 40], Is.False, "shorter than six hundredths of the wing");
            Assert.That(veins[25, 55], Is.True);
            Assert.That(veins.Count, Is.EqualTo(80 + 13));
        }

        [TestCase(18, true)]
        [TestCase(21, false)]
        public void FaintStretches_CountWhileTheyCoverNoMoreThan28HundredthsOfTheWing(int rows, bool count)
        {
            var response = new PixelPlane(200, 70);
            for (int k = 0; k < 200 * rows; k++)
                response.values[k] = 2f;
            for (int x = 20; x < 60; x++)
                response[x, 3] = 20f;
            PixelMask veins = VeinMask.Of(response, Whole(), 200.0);

            Assert.That(veins[40, 3], Is.True);
            Assert.That(veins[150, 10], Is.EqualTo(count));
        }

        private static PixelMask Whole()
        {
            var mask = new PixelMask(200, 70);
            for (int k = 0; k < mask.width * mask.height; k++)
                mask[k % mask.width, k / mask.width] = true;
            return mask;
        }
    }
}
