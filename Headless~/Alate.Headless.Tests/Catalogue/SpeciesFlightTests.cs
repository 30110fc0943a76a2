using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
using Alate.Cli;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Insects
{
    /// <summary>Every species in every variant, as it flies.</summary>
    public sealed class SpeciesFlightTests
    {
        private static IEnumerable<TestCaseData> All => InsectCatalogue.All.SelectMany(
            species => species.Variants.Select(variant => new TestCaseData(species.Name, variant)));

        [Test]
        public void NoEdge_IsStretchedBeyondItsBound(
            [ValueSource(typeof(InsectCatalogue), nameof(InsectCatalogue.Names))] string species) =>
            AssertWithinBound(species, InsectVariant.Standard);

        [TestCaseSource(nameof(All))]
        [Explicit]
        [Category("Long")]
        public void NoEdge_OfAnyVariant_IsStretchedBeyondItsBound(string species, InsectVariant variant) =>
            AssertWithinBound(species, variant);

        private static void AssertWithinBound(string species, InsectVariant variant)
        {
            var summary = FlightSummary.Of(Fly(species, variant));

            Assert.That(summary.Resets, Is.Zero);
            Assert.That(
                summary.Wings.Select(wing => wing.EdgeStretchMaxPct), Is.All.LessThan(variant == InsectVariant.Expressive ? 8.0 : 6.0));
        }

        [TestCase("monarch")]
        [TestCase("swallowtail", Explicit = true, Category = "Long")]
        [TestCase("firefly", Explicit = true, Category = "Long")]
        [TestCase("fishfly")]
        [TestCase("painted-lichen-moth", Explicit = true, Category = "Long")]
        [TestCase("snailfish", Explicit = true, Category = "Long")]
        public void TheExpressiveVariant_DeformsMoreThanTheStandardOne(string species)
        {
            WingSummary standard = FlightSummary.Of(Fly(species, InsectVariant.Standard)).Main;
            WingSummary expressive = FlightSummary.Of(Fly(species, InsectVariant.Expressive)).Main;

            Assert.That(expressive.TwistPpDeg, Is.GreaterThan(standard.TwistPpDeg));
            Assert.That(expressive.TipBendMaxDeg, Is.GreaterThan(1.3 * standard.TipBendMaxDeg));
            Assert.That(expressive.TipLagDeg, Is.GreaterThan(standard.TipLagDeg));
        }

        [TestCase(InsectVariant.Standard)]
        [TestCase(InsectVariant.Expressive)]
        public void TheSwallowtailsHindWing_StaysWithItsForeWing(InsectVariant variant)
        {
            FlightRecord flight = Fly("swallowtail", variant);
            double flexible = LargestGap(flight, out double atBottom);
            double rigid = LargestGap(TetheredFlight.Fly(flight.Plan with { Column = ComparisonColumn.RigidWing }), out _);

            TestContext.Progress.WriteLine($"swallowtail {variant}: gap "
                + $"{flexible:P1} of the fore wing's length, {atBottom:P1} at the bottom of the stroke; {rigid:P1} with rigid wings");
            Assert.That(flexible, Is.LessThan(0.12));
            Assert.That(atBottom, Is.LessThan(0.05));
            Assert.That(flexible, Is.LessThan(rigid), "the wings bend towards one another");
        }

        [Test]
        public void APlansSpeed_IsTheCruiseOfEveryInsect()
        {
            foreach (InsectDefinition insect in InsectCatalogue.All.Where(one => one.Name != "snailfish"))
                Assert.That(FlightPlan.CruiseOf(insect), Is.EqualTo(new FlightPlan().Speed), insect.Name);
        }

        private static FlightRecord Fly(string species, InsectVariant variant) =>
            TetheredFlight.Fly(
                new FlightPlan { Species = species, Variant = variant, Speed = FlightPlan.CruiseOf(InsectCatalogue.Find(species)) });

        // Of the inner half of the hind wing's front edge, where the wings lie against one another, from the nearest place of the fore
        // wing.
        private static double LargestGap(FlightRecord flight, out double atBottom)
        {
            const int k_Phases = 12;
            RecordedWing fore = flight.Wings[0], hind = flight.Wings[2];
            int[] edge = FrontEdge(hind.Rest);
            double[] gaps = new double[k_Phases];
            for (int phase = 0; phase < k_Phases; phase++)
            {
                float3[] ahead = fore.At(phase / (double)k_Phases).Positions, behind = hind.At(phase / (double)k_Phases).Positions;
                gaps[phase] = edge.Max(vertex => ahead.Min(place => math.distance(place, behind[vertex]))) / fore.Placement.Length;
            }

            atBottom = gaps[k_Phases / 2];
            return gaps.Max();
        }

        private static int[] FrontEdge(float3[] rest)
        {
            const float k_Step = 0.05f;
            return Enumerable.Range(0, rest.Length).GroupBy(vertex => (int)Math.Floor(rest[vertex].x / k_Step))
                .Where(strip => strip.Key >= 2 && strip.Key < 10)
                .Select(strip => strip.OrderByDescending(vertex => rest[vertex].z).First()).ToArray();
        }
    }
}
