using System;
using Alate.Catalogue;
using NUnit.Framework;

namespace Alate.Tests
{
    public sealed class WingOutlineTests
    {
        private static WingOutline Monarch => InsectCatalogue.Find("monarch").Wings[0].Outline;

        [Test]
        public void AMonarchsWing_HasTheMeasuredArea()
        {
            double squareCentimetres = Monarch.Area * Monarch.Length * Monarch.Length * 1e4;

            Assert.That(squareCentimetres, Is.EqualTo(12.7).Within(0.05));
        }

        [Test]
        public void StraightEdges_PassThroughTheirLandmarks_AndHalfway()
        {
            var outline = WingOutline.FromMillimetres(new[] { 0.0, 10, 20 }, new[] { 1.0, 3, 2 }, new[] { -1.0, -5, 0 });

            Assert.That(outline.Length, Is.EqualTo(0.02).Within(1e-12));
            Assert.That(outline.LeadingAt(0.5), Is.EqualTo(0.15).Within(1e-12));
            Assert.That(outline.TrailingAt(0.75), Is.EqualTo(-0.125).Within(1e-12));
            Assert.That(outline.Area, Is.EqualTo((0.5 * (0.1 + 0.4) + 0.5 * (0.4 + 0.1)) / 2).Within(1e-12));
        }

        [Test]
        public void SmoothedEdges_PassThroughTheLandmarks_InsideTheTip()
        {
            WingOutline smooth = Monarch.Smoothed();

            for (int i = 0; i < Monarch.LandmarkSpans.Count - 2; i++)
            {
                double span = Monarch.LandmarkSpans[i];
                Assert.That(smooth.LeadingAt(span), Is.EqualTo(Monarch.LeadingAt(span)).Within(1e-12));
                Assert.That(smooth.TrailingAt(span), Is.EqualTo(Monarch.TrailingAt(span)).Within(1e-12));
            }
        }

        [Test]
        public void SmoothedEdges_StayInTheBandBetweenTwoLandmarks_UpToTheTip()
        {
            WingOutline smooth = Monarch.Smoothed();
            for (int i = 0; i + 3 < Monarch.LandmarkSpans.Count; i++)
            {
                double from = Monarch.LandmarkSpans[i];
                double to = Monarch.LandmarkSpans[i + 1];
                for (int step = 0; step <= 50; step++)
                {
                    double span = from + (to - from) * step / 50;
                    AssertBetween(smooth.LeadingAt(span), Monarch.LeadingAt(from), Monarch.LeadingAt(to));
                    AssertBetween(smooth.TrailingAt(span), Monarch.TrailingAt(from), Monarch.TrailingAt(to));
                }
            }
        }

        [Test]
        public void SmoothedTip_ClosesToAPoint_AtTheSameSpan()
        {
            WingOutline smooth = Monarch.Smoothed();

            Assert.That(smooth.HasRoundedTip, Is.True);
            Assert.That(smooth.ChordAt(1), Is.EqualTo(0).Within(1e-12));
            Assert.That(smooth.ChordAt(0.995), Is.GreaterThan(0.3 * Monarch.ChordAt(1)));
            Assert.That(smooth.Area, Is.EqualTo(Monarch.Area).Within(1).Percent);
        }

        [Test]
        public void ASmoothedEdge_DoesNotOvershoot_BesideASteepRise()
        {
            WingOutline smooth = WingOutline.FromMillimetres(
                new[] { 0.0, 10, 20, 30, 40 }, new[] { 1.0, 1.1, 11, 11.1, 11.1 }, new[] { -20.0, -20, -20, -20, 11 }).Smoothed();

            for (double span = 0.0; span < 0.25; span += 0.005)
            {
                AssertBetween(smooth.LeadingAt(span), 1.0 / 40, 1.1 / 40);
                AssertBetween(smooth.LeadingAt(span + 0.5), 11.0 / 40, 11.1 / 40);
            }
        }

        [Test]
        public void Smoothing_NeverPinchesTheWing()
        {
            var steep = WingOutline.FromMillimetres(
                new[] { 0.0, 10, 20, 30 }, new[] { 12.0, 6, 0, 0 }, new[] { 5.5, 5.4, -1, -12 });

            WingOutline smooth = steep.Smoothed();

            for (double span = 0.0; span < 0.7; span += 0.01)
            {
                Assert.That(smooth.ChordAt(span), Is.GreaterThanOrEqualTo(0.5 * steep.ChordAt(span)));
            }
        }

        [Test]
        public void ABrokenOutline_IsRefused_WithTheLandmarkAtFault()
        {
            Assert.That(
                () => WingOutline.FromMillimetres(new[] { 0.0, 10, 9 }, new[] { 1.0, 1, 1 }, new[] { 0.0, 0, 0 }),
                Throws.ArgumentException.With.Message.Contains("Landmark 2"));
            Assert.That(
                () => WingOutline.FromMillimetres(new[] { 0.0, 10, 20 }, new[] { 1.0, 1, 1 }, new[] { 0.0, 2, 0 }),
                Throws.ArgumentException.With.Message.Contains("Landmark 1"));
            Assert.That(
                () => WingOutline.FromMillimetres(new[] { 0.0, 10 }, new[] { double.NaN, 1 }, new[] { 0.0, 0 }),
                Throws.ArgumentException.With.Message.Contains("Landmark 0"));
            Assert.That(() => WingOutline.FromMillimetres(new[] { 0.0 }, new[] { 1.0 }, new[] { 0.0 }), Throws.ArgumentException);
            Assert.That(() => WingOutline.FromMillimetres(null, new[] { 1.0 }, new[] { 0.0 }), Throws.ArgumentNullException);
        }

        private static void AssertBetween(double value, double a, double b)
        {
            Assert.That(value, Is.InRange(Math.Min(a, b) - 1e-12, Math.Max(a, b) + 1e-12));
        }
    }
}
