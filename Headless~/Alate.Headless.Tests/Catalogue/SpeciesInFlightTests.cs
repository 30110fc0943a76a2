using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
using Alate.Cli;
using Alate.Geometry;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests.Insects
{
    /// <summary>
    /// Every species in every variant, as it flies: a wing is one sheet that neither tears nor folds through itself or the body.
    /// </summary>
    public sealed class SpeciesInFlightTests
    {
        private static IEnumerable<TestCaseData> All => InsectCatalogue.All.SelectMany(
            species => species.Variants.Select(variant => new TestCaseData(species.Name, variant)));

        private static IEnumerable<string> Species => InsectCatalogue.Names;

        [TestCaseSource(nameof(Species))]
        public void NoWing_Tears(string name) => AssertWhole(name, InsectVariant.Standard);

        [TestCaseSource(nameof(All))]
        [Explicit]
        [Category("Long")]
        public void NoWing_OfAnyVariant_Tears(string name, InsectVariant variant) => AssertWhole(name, variant);

        private static void AssertWhole(string name, InsectVariant variant)
        {
            float bound = variant == InsectVariant.Expressive ? 0.08f : 0.06f;
            foreach (RecordedWing wing in FlownSpecies.Of(name, variant).Wings)
            {
                var edges = new EdgeStretch(wing.Rest, wing.Triangles);
                float[] stretches = new float[edges.Count];
                float largest = 0f;
                foreach (RecordedFrame frame in wing.Frames)
                {
                    edges.Measure(frame.Positions, stretches);
                    largest = math.max(largest, stretches.Max());
                }

                Tell($"{name} {variant} {wing.Wing.Name}: edges stretch by {largest:P2}");
                Assert.That(largest, Is.LessThan(bound), wing.Wing.Name);
            }
        }

        // The root is one stiff line. It turns with feathering, so that the rear end of a broad one leaves the skin.
        [TestCaseSource(nameof(Species))]
        public void TheRoot_StaysAtTheBody(string name) => AssertRooted(name, InsectVariant.Standard);

        [TestCaseSource(nameof(All))]
        [Explicit]
        [Category("Long")]
        public void TheRoot_OfAnyVariant_StaysAtTheBody(string name, InsectVariant variant) => AssertRooted(name, variant);

        private static void AssertRooted(string name, InsectVariant variant)
        {
            var flown = FlownSpecies.Of(name, variant);
            foreach (RecordedWing wing in flown.Wings)
            {
                int[] root = Enumerable.Range(0, wing.Rest.Length).Where(k => wing.Rest[k].x < 0.002f).ToArray();
                float farthest = 0f;
                foreach (float3[] places in FlownSpecies.Poses(wing))
                    farthest = root.Aggregate(farthest, (far, k) => math.max(far, DistanceToSkin(flown.Body, places[k])));
                farthest /= wing.Placement.Length;
                Tell(
                    $"{name} {variant} {wing.Wing.Name}: {root.Length} vertices of the root up to {farthest:P2} of the span from the skin");
                Assert.That(root, Is.Not.Empty);
                Assert.That(farthest, Is.LessThan(0.065f), wing.Wing.Name);
            }
        }

        [TestCaseSource(nameof(Species))]
        public void TheInnerThird_NeverPassesThroughItself(string name) => AssertApart(name, InsectVariant.Standard);

        [TestCaseSource(nameof(All))]
        [Explicit]
        [Category("Long")]
        public void TheInnerThird_OfAnyVariant_NeverPassesThroughItself(string name, InsectVariant variant) => AssertApart(name, variant);

        private static void AssertApart(string name, InsectVariant variant)
        {
            foreach (RecordedWing wing in FlownSpecies.Of(name, variant).Wings)
            {
                List<int3> inner = FlownSpecies.TrianglesWithin(wing, 1f / 3f);
                int crossings = FlownSpecies.Poses(wing).Sum(places => TriangleCrossing.Count(places, inner, inner));
                Tell($"{name} {variant} {wing.Wing.Name}: {crossings} crossings of {inner.Count} triangles");
                Assert.That(crossings, Is.Zero, wing.Wing.Name);
            }
        }

        [TestCaseSource(nameof(Species))]
        public void HardlyAnyOfAWing_IsWithinTheBody(string name) => AssertOutsideOfTheBody(name, InsectVariant.Standard);

        [TestCaseSource(nameof(All))]
        [Explicit]
        [Category("Long")]
        public void HardlyAnyOfAWing_OfAnyVariant_IsWithinTheBody(string name, InsectVariant variant) =>
            AssertOutsideOfTheBody(name, variant);

        [TestCase(InsectVariant.Standard)]
        [TestCase(InsectVariant.Expressive)]
        public void TheHindWingOfASwallowtail_StaysBeneathTheForeWing_AndNear(InsectVariant variant)
        {
            var flown = FlownSpecies.Of("swallowtail", variant);
            RecordedWing fore = flown.Wings[0], hind = flown.Wings[1];
            var seam = new WingSeam(fore, hind);
            List<float3[]> front = FlownSpecies.Poses(fore).ToList(), rear = FlownSpecies.Poses(hind).ToList();
            float widest = front.Zip(rear, seam.WidestGap).Max() / fore.Placement.Length;
            int crossings = front.Zip(rear, seam.Crossings).Sum();
            Tell($"swallowtail {variant}: {widest:P1} of the fore wing's span apart at most, {crossings} crossings");

            Assert.That(seam.Count, Is.GreaterThan(5));
            Assert.That(widest, Is.LessThan(0.13f));
            Assert.That(crossings, Is.Zero);
        }

        private static void AssertOutsideOfTheBody(string name, InsectVariant variant)
        {
            var flown = FlownSpecies.Of(name, variant);
            List<(List<int> Corners, Bounds Bounds)> pieces = BodyPieces.Of(flown.Body)
                .ConvertAll(piece => (Corners: piece, Bounds: BodyPieces.BoundsOf(flown.Body, piece)));
            foreach (RecordedWing wing in flown.Wings)
            {
                int within = FlownSpecies.Poses(wing).Sum(places => places.Count(place => pieces.Exists(
                    piece => piece.Bounds.Contains(place) && BodyPieces.Winding(flown.Body, piece.Corners, place) > 0.5)));
                double share = within / (double)(FlownSpecies.k_Phases * wing.Rest.Length);
                Tell($"{name} {variant} {wing.Wing.Name}: {share:P2} within the body");
                Assert.That(share, Is.LessThan(0.01), wing.Wing.Name);
            }
        }

        private static float DistanceToSkin(SurfaceMesh body, Vector3 place)
        {
            float nearest = float.MaxValue;
            for (int k = 0; k < body.triangles.Length; k += 3)
            {
                nearest = Math.Min(nearest, TriangleDistance.Square(
                    place, body.positions[body.triangles[k]], body.positions[body.triangles[k + 1]],
                    body.positions[body.triangles[k + 2]]));
            }

            return (float)Math.Sqrt(nearest);
        }

        private static void Tell(FormattableString words) => TestContext.Progress.WriteLine(FormattableString.Invariant(words));
    }
}
