using System.Collections.Concurrent;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Alate.Catalogue;
using Alate.Cli;
using Alate.Fitting;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>The automatic skeleton of every species' wings, next to the one that its author made.</summary>
    public sealed class SpeciesFitTests
    {
        private const int k_Moves = 1, k_ManyMoves = 3;

        private static readonly ConcurrentDictionary<WingDefinition, SkeletonFit> s_Fits =
            new ConcurrentDictionary<WingDefinition, SkeletonFit>();

        private static IEnumerable<TestCaseData> Wings()
        {
            foreach (InsectDefinition species in InsectCatalogue.All)
            {
                foreach (WingDefinition wing in species.Wings)
                    yield return new TestCaseData(wing).SetArgDisplayNames(species.Name, wing.Name);
            }
        }

        private static IEnumerable<TestCaseData> EveryOtherWing() => Wings().Where((_, k) => k % 2 == 0);

        [TestCaseSource(nameof(Wings))]
        public void ItsChains_LieInsideTheWing_AlongTheLeadingEdge(WingDefinition wing)
        {
            SkeletonFit fit = Fit(wing);
            var measure = new FitMeasure(fit.Skeleton, fit.Outline);

            Assert.That(fit.Skeleton.Validate(), Is.Empty);
            Assert.That(fit.Warnings, Is.Empty);
            Assert.That(measure.Outside(), Is.LessThan(0.01));
            Assert.That(measure.OffLeadingEdge(), Is.LessThan(0.03));
        }

        [TestCaseSource(nameof(EveryOtherWing))]
        public void AnotherPlaceSizeSideAndTriangulation_GiveTheSame(WingDefinition wing) => AssertSame(wing, 1, k_Moves);

        [TestCaseSource(nameof(Wings))]
        [Explicit]
        [Category("Long")]
        public void MorePlacesSizesSidesAndTriangulations_GiveTheSame(WingDefinition wing) => AssertSame(wing, 1, k_ManyMoves);

        private static void AssertSame(WingDefinition wing, int first, int last)
        {
            SkeletonFitSettings hints = FittedFlight.Hints(wing);
            SkeletonFit fit = Fit(wing);
            var measure = new FitMeasure(fit.Skeleton, fit.Outline);

            for (int seed = first; seed <= last; seed++)
            {
                var move = new WingMove(seed);
                SkeletonFitSettings moved = hints;
                moved.bodySide = move.Direction(hints.bodySide.Value);
                moved.forward = move.Direction(hints.forward.Value);
                moved.up = move.Direction(Vector3.up);

                SurfaceMesh split = Split(Surface(wing, wing.TriangleCount), seed),
                    finer = Surface(wing, wing.TriangleCount * (seed + 4) / 4);
                WingSkeleton same = SkeletonFitter.Fit(move.Surface(split), moved).Skeleton;
                WingSkeleton near = SkeletonFitter.Fit(move.Surface(finer), moved).Skeleton;

                Assert.That(measure.Apart(same, move.Point, move.Scale), Is.LessThan(0.01), $"move {seed}");
                Assert.That(measure.Apart(near, move.Point, move.Scale, 1), Is.LessThan(0.01), $"move {seed}, a finer mesh");
                Assert.That(measure.Apart(near, move.Point, move.Scale), Is.LessThan(0.03),
                    $"move {seed}, a finer mesh, along whose rounder edge joints lie elsewhere");
            }
        }

        [TestCaseSource(nameof(EveryOtherWing))]
        public void WithTheSameDelays_ItTwistsAndBows_AsTheAuthorsDoes(WingDefinition wing) => AssertTwistsAlike(wing);

        [TestCaseSource(nameof(Wings))]
        [Explicit]
        [Category("Long")]
        public void WithTheSameDelays_AnyWingTwistsAndBows_AsTheAuthorsDoes(WingDefinition wing) => AssertTwistsAlike(wing);

        private static void AssertTwistsAlike(WingDefinition wing)
        {
            var flight = FittedFlight.Of(wing, byFirstOrder: true);

            Assert.That(flight.Fitted.TwistRange, Is.EqualTo(flight.ByHand.TwistRange).Within(25).Percent, "twist");
            Assert.That(Camber(flight.Fitted), Is.EqualTo(Camber(flight.ByHand)).Within(25).Percent, "camber");
        }

        [TestCaseSource(nameof(EveryOtherWing))]
        public void Flown_ItTwistsBowsAndStretches_AsTheAuthorsDoes(WingDefinition wing) => AssertFliesAlike(wing);

        [TestCaseSource(nameof(Wings))]
        [Explicit]
        [Category("Long")]
        public void Flown_AnyWingTwistsBowsAndStretches_AsTheAuthorsDoes(WingDefinition wing) => AssertFliesAlike(wing);

        private static void AssertFliesAlike(WingDefinition wing)
        {
            var flight = FittedFlight.Of(wing);
            WingDeformation hand = flight.ByHand, fitted = flight.Fitted;

            // The fitter spreads the chains of narrow wings wider than their authors did, which gives the delay more room: 32 % more twist,
            // 67 % more camber.
            bool isFishfly = wing == InsectCatalogue.Find("fishfly").Wings[0], isFirefly = wing == InsectCatalogue.Find("firefly").Wings[0];
            Assert.That(fitted.TwistRange, Is.EqualTo(hand.TwistRange).Within(isFishfly ? 35 : 25).Percent, "twist");
            Assert.That(Camber(fitted), Is.EqualTo(Camber(hand)).Within(isFirefly ? 70 : 25).Percent, "camber");
            Assert.That(fitted.StretchMax, Is.EqualTo(hand.StretchMax).Within(25).Percent.And.LessThan(0.06f), "largest stretch");
        }

        [Test]
        public void TheManualsTable_HasTheseNumbers()
        {
            double[][] rows = File.ReadLines(Path.Combine(PackageRoot.Find(), "Documentation~", "results.md"))
                .Where(line => line.StartsWith("| ") && line.Contains("° → "))
                .Select(line =>
                    Regex.Matches(line, @"[\d.]+").Select(number => double.Parse(number.Value, CultureInfo.InvariantCulture)).ToArray())
                .ToArray();
            WingDefinition[] wings = InsectCatalogue.All.SelectMany(species => species.Wings).ToArray();

            Assert.That(rows, Has.Length.EqualTo(wings.Length));
            for (int k = 0; k < wings.Length; k++)
            {
                var flight = FittedFlight.Of(wings[k]);
                double[] numbers =
                [
                    math.degrees(flight.ByHand.TwistRange), math.degrees(flight.Fitted.TwistRange),
                    100.0 * Camber(flight.ByHand), 100.0 * Camber(flight.Fitted), 100.0 * flight.ByHand.StretchMax,
                    100.0 * flight.Fitted.StretchMax,
                ];
                Assert.That(rows[k], Is.EqualTo(numbers).Within(0.1), $"row {k}, {wings[k].Name}");
            }
        }

        // Wings that are not moved are fitted once for all tests.
        private static SkeletonFit Fit(WingDefinition wing) =>
            s_Fits.GetOrAdd(wing, own => SkeletonFitter.Fit(Surface(own, own.TriangleCount), FittedFlight.Hints(own)));

        private static float Camber(in WingDeformation beat) => beat.CamberMax - beat.CamberMin;

        // The same surface and outline of more triangles: many are split in three at a random place.
        private static SurfaceMesh Split(SurfaceMesh surface, int seed)
        {
            var random = new System.Random(seed);
            var positions = new List<Vector3>(surface.positions);
            var triangles = new List<int>();
            for (int k = 0; k < surface.triangles.Length; k += 3)
            {
                int a = surface.triangles[k], b = surface.triangles[k + 1], c = surface.triangles[k + 2];
                float u = (float)random.NextDouble(), v = (1f - u) * (float)random.NextDouble();
                if (random.Next(2) == 0 || u * v * (1f - u - v) < 1e-3f)
                {
                    triangles.AddRange([a, b, c]);
                    continue;
                }

                triangles.AddRange([a, b, positions.Count, b, c, positions.Count, c, a, positions.Count]);
                positions.Add(u * positions[a] + v * positions[b] + (1f - u - v) * positions[c]);
            }

            return new SurfaceMesh { name = surface.name, positions = positions.ToArray(), triangles = triangles.ToArray() };
        }

        private static SurfaceMesh Surface(WingDefinition wing, int triangles)
        {
            SurfaceMesh mesh = wing.IsFilled
                ? WingMesher.Fill(wing.Contour, wing.Scallops, triangles, 1f) : WingMesher.Strips(wing.Contour, triangles);
            return mesh;
        }
    }
}
