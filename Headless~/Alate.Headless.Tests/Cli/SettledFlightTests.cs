using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
using Alate.Cli;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Cli
{
    /// <summary>A short flight is recorded when its beat has settled, so that the animation of it loops.</summary>
    public sealed class SettledFlightTests
    {
        private const int k_KeyFrames = 24;

        private static readonly Dictionary<(string, InsectVariant), FlightRecord> s_OneBeat =
            new Dictionary<(string, InsectVariant), FlightRecord>();

        private static IEnumerable<TestCaseData> Some => Cases(IsQuick);

        private static IEnumerable<TestCaseData> Others => Cases((species, variant) => !IsQuick(species, variant));

        private static IEnumerable<TestCaseData> Cases(Func<string, InsectVariant, bool> wanted) =>
            from species in InsectCatalogue.All
            from variant in species.Variants
            where wanted(species.Name, variant)
            select new TestCaseData(species.Name, variant);

        // The soft variant of the wings that flutter longest, and the monarch as it is.
        private static bool IsQuick(string species, InsectVariant variant) =>
            (species, variant) is ("swallowtail", InsectVariant.Expressive) or ("monarch", InsectVariant.Standard);

        [TestCaseSource(nameof(Some))]
        public void AFlightOfOneBeat_HasTheBeatOfALongOne(string name, InsectVariant variant) => AssertSettled(name, variant);

        [TestCaseSource(nameof(Others))]
        [Explicit]
        [Category("Long")]
        public void AFlightOfOneBeat_OfAnyOtherVariant_HasTheBeatOfALongOne(string name, InsectVariant variant) =>
            AssertSettled(name, variant);

        [TestCaseSource(nameof(Some))]
        public void NoStepBetweenKeyFrames_IsLargerThanThoseBesideIt_AllRound(string name, InsectVariant variant) =>
            AssertEven(name, variant);

        [TestCaseSource(nameof(Others))]
        [Explicit]
        [Category("Long")]
        public void NoStepBetweenKeyFrames_OfAnyOtherVariant_IsLargerThanThoseBesideIt(string name, InsectVariant variant) =>
            AssertEven(name, variant);

        [Test]
        public void TheClock_StartsAfterSettling()
        {
            FlightRecord flight = OneBeat("monarch", InsectVariant.Standard);
            List<RecordedFrame> frames = flight.Wings[0].Frames;

            Assert.That(frames[0].Time, Is.EqualTo(flight.Seconds / frames.Count).Within(1e-6));
            Assert.That(frames[^1].Time, Is.EqualTo(flight.Seconds).Within(1e-6));
        }

        private static void AssertSettled(string name, InsectVariant variant)
        {
            FlightRecord one = OneBeat(name, variant),
                many = MonarchFlight.Fly(Plan(name, variant) with { Seconds = 40.0 / one.Wings[0].Frequency });

            Assert.That(one.Beats, Is.EqualTo(1));
            for (int k = 0; k < one.Wings.Count; k++)
            {
                float length = one.Wings[k].Placement.Length;
                for (int key = 0; key < k_KeyFrames; key++)
                    Assert.That(Farthest(Shape(one.Wings[k], key), Shape(many.Wings[k], key)) / length, Is.LessThan(2e-3f), $"key {key}");
            }
        }

        private static void AssertEven(string name, InsectVariant variant)
        {
            foreach (RecordedWing wing in OneBeat(name, variant).Wings)
            {
                float[] steps = Enumerable.Range(0, k_KeyFrames)
                    .Select(key => Farthest(Shape(wing, key), Shape(wing, key + 1))).ToArray();
                for (int key = 0; key < k_KeyFrames; key++)
                {
                    float beside = math.max(steps[(key + k_KeyFrames - 1) % k_KeyFrames], steps[(key + 1) % k_KeyFrames]);
                    Assert.That(steps[key], Is.LessThan(1.25f * beside), $"{wing.Wing.Name}, from key {key}");
                }
            }
        }

        // Flown once for all tests.
        private static FlightRecord OneBeat(string name, InsectVariant variant)
        {
            if (!s_OneBeat.TryGetValue((name, variant), out FlightRecord flight))
            {
                double frequency = MonarchFlight.Fly(Plan(name, variant)).Wings[0].Frequency;
                s_OneBeat.Add((name, variant), flight = MonarchFlight.Fly(Plan(name, variant) with { Seconds = 1.0 / frequency }));
            }

            return flight;
        }

        private static FlightPlan Plan(string name, InsectVariant variant) =>
            new FlightPlan { Species = name, Variant = variant, Speed = FlightPlan.CruiseOf(InsectCatalogue.Find(name)) };

        private static float3[] Shape(RecordedWing wing, int key) => wing.At((double)key / k_KeyFrames).Positions;

        private static float Farthest(float3[] one, float3[] other) => one.Zip(other, math.distance).Max();
    }
}
