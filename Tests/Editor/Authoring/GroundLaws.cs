using System;
using Alate.Authoring;
using NUnit.Framework;

namespace Alate.Editor.Tests
{
    /// <summary>Laws of the ground behind a wing: it is the same however the picture lies, and what most of the border shows.</summary>
    public sealed class GroundLaws
    {
        [Test]
        public void TheGround_IsTheSame_HoweverThePictureLies([Values] bool acrossColumns, [Values] bool acrossRows)
        {
            const int width = 90, height = 60;
            var random = new Random(3);
            PixelPlane plane = new PixelPlane(width, height), turned = new PixelPlane(width, height);
            int Turned(int k)
            {
                int column = k % width, row = k / width;
                return (acrossColumns ? width - 1 - column : column) + width * (acrossRows ? height - 1 - row : row);
            }

            for (int k = 0; k < plane.values.Length; k++)
                plane.values[k] = 90f + 0.4f * (k % width) + 60f * (float)random.NextDouble();
            for (int k = 0; k < plane.values.Length; k++)
                turned.values[Turned(k)] = plane.values[k];
            PlainGround one = PlainGround.FromBorder(plane), other = PlainGround.FromBorder(turned);

            for (int k = 0; k < plane.values.Length; k += 7)
                Assert.That(other.Distance.values[Turned(k)], Is.EqualTo(one.Distance.values[k]).Within(0.02f), $"pixel {k}");
            Assert.That(other.Noise, Is.EqualTo(one.Noise).Within(0.02));
        }

        // The band that is looked at is a fiftieth of the shorter side, whichever that is.
        [TestCase(1000, 60)]
        [TestCase(60, 1000)]
        public void AWingNearTheRimOfALongPicture_IsNoGround(int width, int height)
        {
            var plane = new PixelPlane(width, height);
            for (int k = 0; k < plane.values.Length; k++)
            {
                int column = k % width, row = k / width;
                int rim = Math.Min(Math.Min(column, width - 1 - column), Math.Min(row, height - 1 - row));
                plane.values[k] = rim < 2 ? 20f : 200f;
            }

            var ground = PlainGround.FromBorder(plane);
            Assert.That(ground.Distance[width / 2, height / 2], Is.EqualTo(180f).Within(1f));
            Assert.That(ground.Distance[0, height / 2], Is.EqualTo(0f).Within(1f));
        }

        [Test]
        public void TheGround_IsWhatMoreThanHalfOfTheBorderShows()
        {
            const int side = 80;
            var random = new Random(8);
            var plane = new PixelPlane(side, side);
            for (int k = 0; k < plane.values.Length; k++)
                plane.values[k] = random.NextDouble() < 0.56 ? 200f : 20f;
            var ground = PlainGround.FromBorder(plane);

            for (int k = 0; k < plane.values.Length; k += 3)
                Assert.That(ground.Distance.values[k], Is.EqualTo(Math.Abs(plane.values[k] - 200f)).Within(1f), $"pixel {k}");
        }
    }
}
