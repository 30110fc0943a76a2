using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
using Alate.Cli;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests.Insects
{
    /// <summary>Wings that fold, bask and rest pass neither through each other nor through the body.</summary>
    public sealed class FoldedWingTests
    {
        private static readonly string[] s_Some = { "monarch" };

        private static IEnumerable<string> All => InsectCatalogue.Names;

        private static IEnumerable<string> Others => All.Except(s_Some);

        [TestCaseSource(nameof(s_Some))]
        public void RightAndLeft_NeverPassThroughEachOther(string name) => AssertSidesApart(name);

        [TestCaseSource(nameof(Others))]
        [Explicit]
        [Category("Long")]
        public void RightAndLeft_NeverPassThroughEachOther_InTheOthers(string name) => AssertSidesApart(name);

        private static void AssertSidesApart(string name)
        {
            var folded = FoldedSpecies.Of(name);
            Assert.That(folded.Resets, Is.Zero);
            for (int k = 0; k < folded.Wings.Count; k += 2)
                AssertApart(folded, folded.Wings[k], folded.Wings[k + 1]);
        }

        [TestCase("swallowtail")]
        [TestCase("fishfly", Explicit = true, Category = "Long")]
        public void ForeAndHind_NeverPassThroughEachOther(string name)
        {
            var folded = FoldedSpecies.Of(name);
            AssertApart(folded, folded.Wings[0], folded.Wings[2]);
            AssertApart(folded, folded.Wings[0], folded.Wings[3]);
        }

        [TestCaseSource(nameof(s_Some))]
        public void TheInnerThird_NeverPassesThroughItself(string name) => AssertInnerThirdApart(name);

        [TestCaseSource(nameof(Others))]
        [Explicit]
        [Category("Long")]
        public void TheInnerThird_NeverPassesThroughItself_InTheOthers(string name) => AssertInnerThirdApart(name);

        private static void AssertInnerThirdApart(string name)
        {
            var folded = FoldedSpecies.Of(name);
            foreach (RecordedWing wing in folded.Wings.Where(wing => !wing.Placement.IsLeft))
            {
                List<int3> inner = FlownSpecies.TrianglesWithin(wing, 1f / 3f);
                Assert.That(folded.Sitting.Sum(step => TriangleCrossing.Count(FoldedSpecies.Places(wing, step), inner, inner)), Is.Zero,
                    wing.Wing.Name);
            }
        }

        [TestCaseSource(nameof(s_Some))]
        public void HardlyAnyOfAWing_IsWithinTheBody(string name) => AssertOutsideOfTheBody(name);

        [TestCaseSource(nameof(Others))]
        [Explicit]
        [Category("Long")]
        public void HardlyAnyOfAnyOtherWing_IsWithinTheBody(string name) => AssertOutsideOfTheBody(name);

        [TestCaseSource(nameof(s_Some))]
        public void FoldedWings_StayAboveTheFeet(string name) => AssertAboveTheFeet(name);

        [TestCaseSource(nameof(Others))]
        [Explicit]
        [Category("Long")]
        public void FoldedWings_StayAboveTheFeet_InTheOthers(string name) => AssertAboveTheFeet(name);

        private static void AssertAboveTheFeet(string name)
        {
            var folded = FoldedSpecies.Of(name);
            float ground = InsectCatalogue.Find(name).Wings[0].CreatePreset().Rest.feet.y;
            foreach (RecordedWing wing in folded.Wings.Where(wing => !wing.Placement.IsLeft))
                Assert.That(FoldedSpecies.Places(wing, folded.Closed).Min(place => place.y), Is.GreaterThan(ground), wing.Wing.Name);
        }

        [TestCaseSource(nameof(All))]
        public void Feet_AreWhereTheBodyHasThem(string name)
        {
            InsectDefinition species = InsectCatalogue.Find(name);
            Vector3 feet = species.Wings[0].CreatePreset().Rest.feet;
            Vector3[] body = species.Body.CreateSurface(1f).positions;
            float low = body.Min(place => place.y), length = body.Max(place => place.z) - body.Min(place => place.z);
            Assert.That(feet.y, Is.EqualTo(low).Within(0.01f * length));
            Assert.That(feet.x, Is.Zero);
        }

        [TestCase("monarch", 80f, 100f)]
        [TestCase("swallowtail", 80f, 100f)]
        public void Butterflies_CloseTheirWingsAboveTheBack(string name, float least, float most) =>
            Assert.That(SpanAngle(name), Is.InRange(least, most));

        [TestCase("firefly")]
        [TestCase("fishfly", Explicit = true, Category = "Long")]
        [TestCase("painted-lichen-moth", Explicit = true, Category = "Long")]
        public void TheOthers_FoldThemBackOverTheBody(string name)
        {
            var folded = FoldedSpecies.Of(name);
            foreach (RecordedWing wing in folded.Wings.Where(wing => !wing.Placement.IsLeft))
            {
                float3[] places = FoldedSpecies.Places(wing, folded.Closed);
                float length = wing.Placement.Length;
                Assert.That(places.Max(place => place.x), Is.LessThan(0.5f * length), "narrow");
                Assert.That(wing.Placement.Hinge.z - places.Min(place => place.z), Is.GreaterThan(0.7f * length), "back");
            }
        }

        private static void AssertOutsideOfTheBody(string name)
        {
            var folded = FoldedSpecies.Of(name);
            List<(List<int> Corners, Bounds Bounds)> pieces = BodyPieces.Of(folded.Body)
                .ConvertAll(piece => (Corners: piece, Bounds: BodyPieces.BoundsOf(folded.Body, piece)));
            foreach (RecordedWing wing in folded.Wings.Where(wing => !wing.Placement.IsLeft))
            {
                double Within(int step) => FoldedSpecies.Places(wing, step).Count(place => pieces.Exists(
                    piece => piece.Bounds.Contains(place) && BodyPieces.Winding(folded.Body, piece.Corners, place) > 0.5))
                    / (double)wing.Rest.Length;
                double closed = Within(folded.Closed), mean = folded.Sitting.Average(Within);
                TestContext.Progress.WriteLine(FormattableString.Invariant(
                    $"{name} {wing.Wing.Name}: {closed:P2} within the body while closed, {mean:P2} on average"));
                Assert.That(closed, Is.LessThan(0.01), wing.Wing.Name);
                Assert.That(mean, Is.LessThan(0.01), wing.Wing.Name);
            }
        }

        private static float SpanAngle(string name)
        {
            var folded = FoldedSpecies.Of(name);
            RecordedWing wing = folded.Wings[0];
            int tip = Enumerable.Range(0, wing.Rest.Length).OrderByDescending(k => wing.Rest[k].x).First();
            float3 way = FoldedSpecies.Places(wing, folded.Closed)[tip] - wing.Placement.ToBody(default);
            return math.degrees(math.atan2(way.y, way.x));
        }

        private static void AssertApart(FoldedSpecies folded, RecordedWing one, RecordedWing other)
        {
            var found = folded.Sitting.Select(step => (Step: step, Count: Crossings(one, other, step))).Where(at => at.Count > 0).ToList();
            Assert.That(found, Is.Empty, $"{one.Wing.Name}: "
                + string.Join(", ", found.Select(at => FormattableString.Invariant($"fold {folded.Folds[at.Step]:0.00}: {at.Count}"))));
        }

        private static int Crossings(RecordedWing one, RecordedWing other, int step)
        {
            float3[] a = FoldedSpecies.Places(one, step), b = FoldedSpecies.Places(other, step);
            List<int3> front = FlownSpecies.TrianglesWithin(one, float.PositiveInfinity);
            List<int3> rear = FlownSpecies.TrianglesWithin(other, float.PositiveInfinity).ConvertAll(corners => corners + a.Length);
            return TriangleCrossing.Count(a.Concat(b).ToArray(), front, rear);
        }
    }
}
