using System;
using System.Linq;
using Alate.Authoring;
using Alate.Geometry;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    /// <summary>Laws of shades and veins at their ends: beyond the wing, at the tip and at the root.</summary>
    public sealed class VeinEndLaws
    {
        // A wing that lies along the other axis, or backwards, has the widths that it has: between pixels shades blend both ways.
        [Test]
        public void WidthsOfVeins_AreTheSame_HoweverThePictureLies([Values] bool isTurned, [Values] bool acrossColumns,
            [Values] bool acrossRows)
        {
            const int width = 150, height = 90;
            var shades = new PixelPlane(width, height);
            PixelPlane other = isTurned ? new PixelPlane(height, width) : new PixelPlane(width, height);
            PlanPoint Moved(PlanPoint at)
            {
                double x = acrossColumns ? width - at.x : at.x, y = acrossRows ? height + at.z : -at.z;
                return isTurned ? new PlanPoint(y, -x) : new PlanPoint(x, -y);
            }

            for (int k = 0; k < shades.values.Length; k++)
            {
                double x = k % width + 0.5, y = k / width + 0.5, line = y - 0.3 * x - 20.0;
                double dark = 90.0 * Math.Exp(-0.02 * line * line * (1.0 + 0.01 * x));
                shades.values[k] = (float)(180.0 + 3.0 * Math.Sin(0.4 * x + 0.11 * y) - dark);
                PlanPoint place = Moved(new PlanPoint(x, -y));
                other[(int)place.x, (int)-place.z] = shades.values[k];
            }

            PlanPoint[] chain = Enumerable.Range(0, 5).Select(j => new PlanPoint(15.0 + 25.0 * j, -24.5 - 7.5 * j)).ToArray();
            float[] Widths(PixelPlane plane, PlanPoint[] along) => new VeinWidths(plane, 1.0, 400.0)
                .Measure(new[] { along }, new[] { new RadialVein(Polyline.Even(along, 120), 0.0, 1.0) })[0];
            float[] measured = Widths(shades, chain);

            Assert.That(measured, Is.All.Positive);
            Assert.That(Widths(other, Array.ConvertAll(chain, Moved)), Is.EqualTo(measured).Within(0.005f * measured.Max()));
        }

        [Test]
        public void Shades_GoOn_InAPictureThatIsNoSquare([Values(40, 90)] int width)
        {
            int height = 130 - width;
            var pixels = new Color32[width * height];
            var wing = new PixelMask(width, height);
            for (int k = 0; k < pixels.Length; k++)
            {
                bool isWing = k % width < width / 2;
                pixels[k] = isWing ? new Color32(90, 90, 90, 255) : new Color32(255, 255, 255, 255);
                wing[k % width, k / width] = isWing;
            }

            PixelPlane shades = RidgeField.Shades(new WorkingPicture(new WingPicture(width, height, pixels)), wing);
            Assert.That((shades.width, shades.height), Is.EqualTo((width, height)));
            for (int row = 0; row < height; row += 3)
                Assert.That(shades[width / 2 + 4, row], Is.EqualTo(90f).Within(0.1f), $"row {row}");
        }

        // A vein that ends on the last bone: what is measured there is not its width.
        [Test]
        public void TheTip_HasTheWidthOfTheJointBesideIt_AndSoHasTheRoot()
        {
            var shades = new PixelPlane(300, 60);
            for (int k = 0; k < shades.values.Length; k++)
                shades.values[k] = k / 300 >= 28 && k / 300 < 32 && k % 300 > 50 && k % 300 < 225 ? 100f : 200f;
            PlanPoint[] chain = Enumerable.Range(0, 5).Select(j => new PlanPoint(20.0 + 60.0 * j, -30.0)).ToArray();
            float[] widths = new VeinWidths(shades, 1.0, 400.0).Measure(
                new[] { chain, chain }, new[] { null, new RadialVein(Polyline.Even(chain, 200), 0.0, 1.0) })[1];
            Assert.That(widths[3], Is.EqualTo(0.01f).Within(5e-4f), "4 of 400 pixels");
            Assert.That((widths[4], widths[0]), Is.EqualTo((widths[3], widths[1])));
        }
    }
}
