using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
using Alate.Geometry;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>Laws of the curves, grains and spots that wings are painted with.</summary>
    public sealed class WingColourLaws
    {
        // Of length 1: leading edge at 0.1, trailing edge at -0.3.
        private static WingOutline Plate() =>
            WingOutline.FromMillimetres(new[] { 0.0, 25.0, 50.0 }, new[] { 5.0, 5.0, 5.0 }, new[] { -15.0, -15.0, -15.0 });

        [Test]
        public void ASmoothCurve_GoesThroughItsPoints_AndTurnsNoCorner()
        {
            double[] points = { 0.0, 0.0, 1.0, 0.5, 2.0, 0.2, 3.0, 0.9 };
            List<double> curve = Ink.Smooth(points);
            for (int k = 0; k < points.Length; k += 2)
            {
                double nearest = Enumerable.Range(0, curve.Count / 2)
                    .Min(i => Math.Abs(curve[2 * i] - points[k]) + Math.Abs(curve[2 * i + 1] - points[k + 1]));
                Assert.That(nearest, Is.LessThan(1e-9), $"point {k / 2}");
            }

            double sharpest = 0;
            for (int k = 2; k + 3 < curve.Count; k += 2)
            {
                double before = Math.Atan2(curve[k + 1] - curve[k - 1], curve[k] - curve[k - 2]);
                double after = Math.Atan2(curve[k + 3] - curve[k + 1], curve[k + 2] - curve[k]);
                sharpest = Math.Max(sharpest, Math.Abs(after - before));
            }

            Assert.That(sharpest, Is.LessThan(0.2), "radians; the points themselves turn by up to 0.76");
            Assert.That(Ink.Smooth(new[] { 0.0, 1.0, 2.0, 1.0, 5.0, 1.0 }).Where((_, k) => k % 2 == 1), Is.All.EqualTo(1.0).Within(1e-9));
        }

        [Test]
        public void PlacesOnALine_AreCountedAlongIt()
        {
            double[] line = { 0.0, 0.0, 3.0, 4.0, 3.0, 10.0 };
            Assert.That(Ink.Length(line), Is.EqualTo(11.0));
            Assert.That(new[] { Ink.On(line, 2.5), Ink.On(line, 7.0), Ink.On(line, 99.0) },
                Is.EqualTo(new[] { (1.5, 2.0), (3.0, 6.0), (3.0, 10.0) }));
        }

        [Test]
        public void TheGrain_IsEven_Continuous_AndGoneWhereNoSampleShowsIt()
        {
            const double k_Size = 0.01;
            float[] grains = Enumerable.Range(0, 5000)
                .Select(k => Ink.Grain(k % 71 * 0.0137, k / 71 * 0.0119, k_Size, 1e-4)).ToArray();
            Assert.That(grains, Is.All.GreaterThanOrEqualTo(-1f).And.All.LessThanOrEqualTo(1f));
            Assert.That(grains.Average(), Is.EqualTo(0f).Within(0.03f));
            Assert.That(grains.Max() - grains.Min(), Is.GreaterThan(1.2f));
            for (int k = 0; k < 50; k++)
            {
                double edge = k * k_Size;
                Assert.That(Ink.Grain(edge + 1e-9, 0.0043, k_Size, 1e-4),
                    Is.EqualTo(Ink.Grain(edge - 1e-9, 0.0043, k_Size, 1e-4)).Within(1e-4f), "from one scale to the next");
            }

            // Scales lie in rows beside each other, so that their edges run in three directions.
            for (int k = 0; k < 4000; k++)
            {
                double x = k * 0.618034 % 1.0 * 10.0 * k_Size, z = k * 0.754878 % 1.0 * 10.0 * k_Size;
                Assert.That(Ink.Grain(x + 1e-4 * k_Size, z + 1e-4 * k_Size, k_Size, 1e-4),
                    Is.EqualTo(Ink.Grain(x, z, k_Size, 1e-4)).Within(2e-3f), $"{x}, {z}");
            }

            Assert.That(Ink.Grain(0.123, 0.456, k_Size, 2.0 * k_Size), Is.Zero);
        }

        [Test]
        public void AFade_EndsWithoutAStep() =>
            Assert.That(new[] { -1.0, 0.0, 1.0, 2.0, 9.0 }.Select(distance => Ink.Fade(distance, 2.0)),
                Is.EqualTo(new[] { 1.0, 1.0, 0.25, 0.0, 0.0 }));

        [Test]
        public void SeveralEllipses_AreDrawnAsEach()
        {
            double[] ellipses = { 0.0, 0.0, 2.0, 1.0, 10.0, 5.0, 1.0, 3.0 };
            Assert.That(Ink.Ellipses(ellipses, 2.0, 0.0, 0.1), Is.EqualTo(0.5f).Within(1e-5f));
            Assert.That(Ink.Ellipses(ellipses, 10.0, 8.0, 0.1), Is.EqualTo(0.5f).Within(1e-5f));
            Assert.That(Ink.Ellipses(ellipses, 5.0, 2.5, 0.1), Is.Zero);
        }

        [Test]
        public void SpotsOfAMargin_LieHalfWayBetweenVeins()
        {
            double[] margin = { 0.0, 0.0, 10.0, 0.0 };
            var spots = new MarginSpots(margin, new[] { 1.0, 0.0, 3.0, 0.0, 7.0, 0.0 }, new PlanPoint(4.0, 1.0));
            float At(double along, double edge) => spots.At(along, edge, 2.0, 0.5, 0.25, 0.01);

            Assert.That(new[] { At(2.0, 2.0), At(5.0, 2.0) }, Is.All.EqualTo(1f), "in both cells");
            Assert.That(new[] { At(1.0, 2.0), At(3.0, 2.0), At(7.0, 2.0), At(2.0, 0.0) }, Is.All.EqualTo(0f), "on veins and on the margin");
            Assert.That(new[] { At(2.5, 2.0), At(5.0, 2.25) }, Is.All.EqualTo(0.5f).Within(1e-4f), "as long and as wide as asked");
        }

        // Where a margin bends within less than their depth, its nearest place jumps within a spot.
        [Test]
        public void ASpotBesideASharpBend_IsWhole()
        {
            double[] margin = { 0.0, 5.0, 0.0, 0.0, 5.0, 0.0 };
            var spots = new MarginSpots(margin, new[] { 0.0, 1.0, 3.0, 0.0 }, new PlanPoint(1.0, 1.0));
            int seen = 0;
            for (int k = 0; k < 200 * 200; k++)
                seen += spots.At(k % 200 * 0.02, k / 200 * 0.02, 0.9, 0.6, 0.4, 1e-6) > 0.5f ? 1 : 0;
            Assert.That(seen * 4e-4, Is.EqualTo(Math.PI * 0.6 * 0.4).Within(2).Percent);
        }

        // A spot that a margin or a neighbour clips is what one sees first on a close look.
        [Test]
        public void TheSpotsOfAMonarch_AreWhole_AndApart()
        {
            WingOutline outline = InsectCatalogue.Find("monarch").Wings[0].Contour;
            foreach (double[] spots in new[] { new MonarchForePattern(outline).Spots, new MonarchHindPattern(outline).Spots })
            {
                Assert.That(spots.Length, Is.GreaterThan(3 * 12));
                for (int k = 0; k < spots.Length; k += 3)
                {
                    double span = spots[k], forward = spots[k + 1], radius = spots[k + 2];
                    Assert.That(outline.LeadingAt(span) - forward, Is.GreaterThan(radius), $"spot {k / 3}");
                    Assert.That(forward - outline.TrailingAt(span), Is.GreaterThan(radius), $"spot {k / 3}");
                    for (int other = 0; other < k; other += 3)
                    {
                        double apart = Math.Sqrt(Math.Pow(span - spots[other], 2) + Math.Pow(forward - spots[other + 1], 2));
                        Assert.That(apart, Is.GreaterThan(radius + spots[other + 2]), $"spots {k / 3} and {other / 3}");
                    }
                }
            }
        }

        [Test]
        public void TheForeWingOfAMonarch_LiesOnItsHindWing_WhichItShades()
        {
            WingPattern pattern = InsectCatalogue.Find("monarch").Wings[0].Pattern;
            float Light(double forward) => pattern.ColourAt(0.4, forward, 1e-3).r;

            float seam = Light(-0.1015), fore = Light(-0.09), shaded = Light(-0.112), hind = Light(-0.15);
            Assert.That(seam, Is.LessThan(0.2f), "the dark edge of the fore wing");
            Assert.That(fore, Is.GreaterThan(0.6f));
            Assert.That(shaded, Is.InRange(0.3f, 0.75f));
            Assert.That(hind, Is.GreaterThan(1.15f * shaded));
        }

        [Test]
        public void Light_ChangesNoOpacity() =>
            Assert.That(Ink.Lit(new Color(0.2f, 0.4f, 0.6f, 0.3f), 0.5), Is.EqualTo(new Color(0.1f, 0.2f, 0.3f, 0.3f)));

        // The second vein is over at 0.24 of the span: a cross vein from farther out would run along the margin.
        [Test]
        public void BeyondTheTipOfTheNextVein_NothingIsCrossedTo()
        {
            WingOutline plate = Plate();
            VeinFan fan = new VeinFan(plate, 0.0).Add(0.5, 0.9).Cross(0, 0.1, 0.6);
            float Drawn(double span) =>
                Enumerable.Range(0, 40).Max(k => fan.CrossVeins(span, -0.1 - 0.005 * k, 0.01, 0.002));

            Assert.That(Drawn(0.058), Is.EqualTo(1f), "within the length of both");
            Assert.That(Math.Max(Drawn(0.6), Drawn(0.4)), Is.Zero);
        }

        [Test]
        public void StrewnScales_CoverAsMuchAsTheirShare()
        {
            Color ground = new Color(1f, 0.8f, 0.4f), dust = new Color(0f, 0f, 0.1f);
            foreach (float share in new[] { 0f, 0.3f, 0.6f, 1f })
            {
                float mean = Enumerable.Range(0, 4000).Average(
                    k => 1f - SwallowtailColours.Dusted(ground, dust, share, k % 63 * 0.0137, k / 63 * 0.0119, 1e-4).r);
                Assert.That(mean, Is.EqualTo(share).Within(0.03f));
            }
        }

        [Test]
        public void AMembrane_HasAStigma_AndASheenThatKeepsItClear()
        {
            WingOutline plate = Plate();
            Color Of(float sheen, float stigma, double span, double forward) =>
                new MembranePattern(plate, new VeinFan(plate, 0.0).Add(0.6))
                {
                    Membrane = new Color(0.8f, 0.8f, 0.8f, 0.3f),
                    Base = new Color(0.8f, 0.8f, 0.8f, 0.3f),
                    Vein = new Color(0.1f, 0.1f, 0.1f, 1f),
                    Sheen = sheen,
                    Stigma = new Vector2(stigma > 0f ? 0.7f : 0f, stigma),
                }.ColourAt(span, forward, 1e-4);

            double vein = new VeinFan(plate, 0.0).Add(0.6).ForwardOf(0, 0.55);
            Assert.That(Of(0f, 0.8f, 0.75, 0.1 - 0.016).a, Is.GreaterThan(0.9f), "the cell behind the leading edge");
            Assert.That(Of(0f, 0.8f, 0.55, vein + 0.02).a, Is.GreaterThan(0.85f), "as far as the vein, at a slant");
            foreach ((double span, double forward) in new[] { (0.65, 0.084), (0.85, 0.084), (0.55, vein - 0.02) })
                Assert.That(Of(0f, 0.8f, span, forward).a, Is.EqualTo(0.3f).Within(1e-4f), "and none beside it");
            float reddest = 0f, greenest = 0f;
            for (double span = 0.3; span < 0.95; span += 0.01)
            {
                Color film = Of(0.5f, 0f, span, 0.05);
                Assert.That(film.a, Is.EqualTo(0.3f).Within(1e-4f));
                reddest = Math.Max(reddest, film.r - film.g);
                greenest = Math.Max(greenest, film.g - film.r);
            }

            Assert.That(Math.Min(reddest, greenest), Is.GreaterThan(0.08f), "pink and green by turns");
        }

        // A knot on the leading edge, and a cross vein that runs back from it towards the base.
        [Test]
        public void ANodus_IsAKnotOfTheLeadingEdge_WithACrossVeinTowardsTheBase()
        {
            WingOutline plate = Plate();
            float At(double nodus, double span, double behind) => new MembranePattern(plate, new VeinFan(plate, 0.0).Add(0.9))
            {
                Membrane = new Color(0.8f, 0.8f, 0.8f, 0.3f),
                Base = new Color(0.8f, 0.8f, 0.8f, 0.3f),
                Vein = new Color(0.1f, 0.1f, 0.1f, 1f),
                CostaHalfWidth = 0.004,
                Nodus = nodus,
            }.ColourAt(span, 0.1 - behind, 1e-4).a;

            Assert.That(new[] { At(0.5, 0.5 - 0.7 * 0.03, 0.03), At(0.5, 0.5 - 0.7 * 0.04, 0.04) }, Is.All.GreaterThan(0.9f));
            Assert.That(new[] { At(0.5, 0.5 + 0.7 * 0.03, 0.03), At(0.5, 0.5 - 0.7 * 0.06, 0.06), At(0.0, 0.479, 0.03) },
                Is.All.EqualTo(0.3f).Within(1e-4f), "towards the tip, beyond its end, and without one");
        }

        // Half of the way along a vein is pale, from a quarter of a wing length on.
        [Test]
        public void Beads_DivideAVein_ButNotAtItsBase()
        {
            WingOutline plate = Plate();
            VeinFan veins = new VeinFan(plate, 0.0).Curve(0.0, 0.0, 0.5, 0.0, 1.0, 0.0);
            float Red(float beads, double span, double forward = 0.0) => new MembranePattern(plate, veins)
            {
                Membrane = new Color(0.4f, 0.4f, 0.4f, 0.3f),
                Base = new Color(0.4f, 0.4f, 0.4f, 0.3f),
                Vein = new Color(0.1f, 0.1f, 0.1f, 1f),
                Beads = beads,
                BeadLength = 0.02,
            }.ColourAt(span, forward, 1e-4).r;

            int pale = 0, dark = 0;
            for (int k = 0; k < 1000; k++)
            {
                float red = Red(1f, 0.5 + 2e-4 * k);
                pale += red > 0.8f ? 1 : 0;
                dark += red < 0.15f ? 1 : 0;
                Assert.That(Red(1f, 0.1 * k / 1000), Is.EqualTo(0.1f).Within(1e-4f), "the base");
            }

            // Half each, but for soft ends of a tenth of a bead.
            Assert.That(new[] { pale, dark }, Is.EqualTo(new[] { 410, 410 }).Within(10));
            Assert.That(new[] { Red(1f, 0.52), Red(1f, 0.53), Red(0f, 0.52), Red(1f, 0.52, 0.05) },
                Is.EqualTo(new[] { 0.86f, 0.1f, 0.1f, 0.4f }).Within(1e-3f));
        }

        // As many rungs as are asked for, from the first vein to the leading edge, the outer end nearer to the tip.
        [Test]
        public void ALadder_IsOfCrossVeins_BeforeTheFirstVein()
        {
            WingOutline plate = Plate();
            VeinFan fan = new VeinFan(plate, 0.0).Add(0.4, 0.6).Ladder(8);
            int rungs = 0;
            bool isOn = false;
            for (int k = 0; k < 20000; k++)
            {
                double span = k / 20000.0, forward = 0.5 * (plate.LeadingAt(span) + fan.ForwardOf(0, span));
                bool wasOn = isOn;
                isOn = fan.CrossVeins(span, forward, 5e-4, 1e-6) > 0.5f;
                rungs += isOn && !wasOn ? 1 : 0;
                Assert.That(fan.CrossVeins(span, fan.ForwardOf(0, span) - 0.01, 5e-4, 1e-6), Is.Zero, "behind the vein");
            }

            Assert.That(rungs, Is.EqualTo(8));
        }

        [Test]
        public void ACurveOfItsOwn_IsAVeinOfAFan()
        {
            WingOutline plate = Plate();
            VeinFan fan = new VeinFan(plate, 0.0).Add(0.9).Curve(0.3, 0.0, 0.4, 0.05, 0.5, 0.0);
            foreach ((double span, double forward) in new[] { (0.3, 0.0), (0.4, 0.05), (0.5, 0.0) })
                Assert.That(fan.Distance(span, forward, out _), Is.LessThan(1e-9));
            Assert.That(fan.Distance(0.4, 0.0, out _), Is.GreaterThan(0.02));
        }

        [Test]
        public void NoPlaceOfAWing_IsPaintedWithNumbersThatAreNone()
        {
            foreach (WingDefinition wing in InsectCatalogue.All.SelectMany(insect => insect.Wings).Where(wing => wing.Pattern != null))
            {
                for (double span = -0.05; span < 1.05; span += 0.03)
                {
                    for (double forward = wing.Contour.Rear - 0.05; forward < wing.Contour.Front + 0.05; forward += 0.03)
                    {
                        Color colour = wing.Pattern.ColourAt(span, forward, 0.002);
                        float[] numbers = { colour.r, colour.g, colour.b, colour.a };
                        Assert.That(numbers, Is.All.GreaterThanOrEqualTo(0f).And.All.LessThan(1.1f));
                    }
                }
            }
        }
    }
}
