using System;
using Alate.Catalogue;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    public sealed class WingPatternTests
    {
        private static WingDefinition Monarch => InsectCatalogue.Find("monarch").Wings[0];

        [Test]
        public void AMonarch_IsOrangeInside_AndDarkAtItsMargin()
        {
            WingPattern pattern = Monarch.Pattern;
            Color inside = pattern.ColourAt(0.3, 0.04, 0.01);
            Color margin = pattern.ColourAt(0.6, Monarch.Contour.TrailingAt(0.6) + 0.003, 0.001);

            Assert.That(inside.r, Is.GreaterThan(0.6f));
            Assert.That(inside.b, Is.LessThan(0.2f));
            Assert.That(Math.Max(margin.r, Math.Max(margin.g, margin.b)), Is.LessThan(0.2f));
        }

        [Test]
        public void APicture_HasAColourForEachPixel_FromTheRearUp()
        {
            WingOutline outline = Monarch.Contour;
            Color32[] picture = Monarch.Pattern.Paint(outline, 64, 32);

            double softness = Math.Max(1.0 / 64, (outline.Front - outline.Rear) / 32);
            var expected = (UnityEngine.Color32)Monarch.Pattern.ColourAt(
                20.5 / 64, outline.Rear + 5.5 / 32 * (outline.Front - outline.Rear), softness);
            Assert.That(picture, Has.Length.EqualTo(64 * 32));
            Assert.That(picture[5 * 64 + 20], Is.EqualTo(expected));
            Assert.That(() => Monarch.Pattern.Paint(outline, 0, 4), Throws.InstanceOf<ArgumentOutOfRangeException>());
        }
    }
}
