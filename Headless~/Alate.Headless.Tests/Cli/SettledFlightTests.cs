using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
using Alate.Cli.Flights;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Cli
{
    /// <summary>A short flight is recorded when its beat has settled, so that the animation of it loops.</summary>
    public sealed class SettledFlightTests
    {
        private const int k_KeyFrames = 24;

        private static IEnumerable<TestCaseData> All => InsectCatalogue.All.SelectMany(
            species => species.Variants.Select(variant => new TestCaseData(species.Name, variant)));

        [TestCaseSource(nameof(All))]
        public void AFlightOfOneBeat_HasTheBeatOfALongOne(string name, InsectVariant variant)
        {
            FlightRecord one = Fly(name, variant, 1), many = Fly(name, variant, 40);

            Assert.That(one.Beats, Is.EqualTo(1));
            for (int k = 0; k < one.Wings.Count; k++)
            {
                float length = one.Wings[k].Placement.Length;
                for (int key = 0; key < k_KeyFrames; key++)
                    Assert.That(Farthest(Shape(one.Wings[k], key), Shape(many.Wings[k], key)) / length, Is.LessThan(2e-3f), $"key {key}");
            }
        }

        [TestCaseSource(nameof(All))]
        public void NoStepBetweenKeyFrames_IsLargerThanThoseBesideIt_AllRound(string name, InsectVariant variant)
        {
            foreach (RecordedWing wing in Fly(name, variant, 1).Wings)
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

        [Test]
        public void TheClock_StartsAfterSettling()
        {
            FlightRecord flight = Fly("monarch", InsectVariant.Standard, 1);
            List<RecordedFrame> frames = flight.Wings[0].Frames;

            Assert.That(frames[0].Time, Is.EqualTo(flight.Seconds / frames.Count).Within(1e-6));
            Assert.That(frames[^1].Time, Is.EqualTo(flight.Seconds).Within(1e-6));
        }

        private static FlightRecord Fly(string name, InsectVariant variant, int beats)
        {
            InsectDefinition species = InsectCatalogue.Find(name);
            double speed = FlightPlan.CruiseOf(species);
            double frequency = MonarchFlight.Fly(new FlightPlan { Species = name, Variant = variant, Speed = speed }).Wings[0].Frequency;
            return MonarchFlight.Fly(new FlightPlan { Species = name, Variant = variant, Speed = speed, Seconds = beats / frequency });
        }

        private static float3[] Shape(RecordedWing wing, int key)
        {
            var places = new float3[wing.Rest.Length];
            wing.At((double)key / k_KeyFrames, places, new float3[places.Length]);
            return places;
        }

        private static float Farthest(float3[] one, float3[] other) => one.Zip(other, math.distance).Max();
    }
}
