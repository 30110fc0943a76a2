using System;
using System.Globalization;
using System.Linq;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Flight
{
    /// <summary>Insects that fly by their own wings land on random spots and slopes and leave them again.</summary>
    public sealed class PerchTests
    {
        [Test]
        public void SpotsThatAreHardToReach_AreReached([Values(120, 686)] int seed) =>
            Assert.That(PerchFlights.Of("monarch").Fly(seed).Landed);

        [TestCase("monarch", 2)]
        [TestCase(FlownInsects.Hawkmoth, 1)]
        [TestCase("swallowtail", 1, Explicit = true, Category = "Long")]
        [TestCase("firefly", 1)]
        [TestCase("fishfly", 1, Explicit = true, Category = "Long")]
        [TestCase("painted-lichen-moth", 1, Explicit = true, Category = "Long")]
        [TestCase("dragonfly", 1, Explicit = true, Category = "Long")]
        public void Insects_Land_AndLeave(string name, int count) => FlyAll(name, count);

        // Walls, then overhangs and ceilings.
        [TestCase("monarch", 1, 45f, 90f)]
        [TestCase("monarch", 1, 90f, 180f)]
        [TestCase("painted-lichen-moth", 1, 170f, 180f)]
        [TestCase("monarch", 500, 45f, 90f, Explicit = true, Category = "Long")]
        [TestCase("monarch", 500, 90f, 180f, Explicit = true, Category = "Long")]
        [TestCase("swallowtail", 100, 45f, 180f, Explicit = true, Category = "Long")]
        [TestCase("firefly", 100, 45f, 180f, Explicit = true, Category = "Long")]
        [TestCase("fishfly", 100, 45f, 180f, Explicit = true, Category = "Long")]
        [TestCase("painted-lichen-moth", 100, 45f, 180f, Explicit = true, Category = "Long")]
        [TestCase("dragonfly", 100, 45f, 180f, Explicit = true, Category = "Long")]
        [TestCase(FlownInsects.Hawkmoth, 100, 45f, 180f, Explicit = true, Category = "Long")]
        public void OnWallsAndCeilings_InsectsLand_AndLeave(string name, int count, float least, float most) =>
            FlyAll(name, count, least, most);

        [TestCase("monarch", 1000)]
        [TestCase("swallowtail", 200)]
        [TestCase("firefly", 200)]
        [TestCase("fishfly", 200)]
        [TestCase("painted-lichen-moth", 200)]
        [TestCase("dragonfly", 200)]
        [TestCase(FlownInsects.Hawkmoth, 200)]
        [Explicit]
        [Category("Long")]
        public void AThousandLandings(string name, int count) => FlyAll(name, count);

        // As far insects do in play.
        [TestCase("monarch", 79, 1, WingDetail.CoarsePatches)]
        [TestCase("monarch", 206, 1, WingDetail.CoarsePatches)]
        [TestCase("monarch", 404, 1, WingDetail.FewerSubsteps)]
        [TestCase("monarch", 1, 500, WingDetail.Full, Explicit = true, Category = "Long")]
        [TestCase("monarch", 1, 500, WingDetail.CoarsePatches, Explicit = true, Category = "Long")]
        [TestCase("swallowtail", 1, 100, WingDetail.CoarsePatches, Explicit = true, Category = "Long")]
        [TestCase("firefly", 1, 100, WingDetail.CoarsePatches, Explicit = true, Category = "Long")]
        [TestCase("fishfly", 1, 100, WingDetail.CoarsePatches, Explicit = true, Category = "Long")]
        [TestCase("painted-lichen-moth", 1, 100, WingDetail.CoarsePatches, Explicit = true, Category = "Long")]
        [TestCase("dragonfly", 1, 100, WingDetail.CoarsePatches, Explicit = true, Category = "Long")]
        [TestCase(FlownInsects.Hawkmoth, 1, 100, WingDetail.CoarsePatches, Explicit = true, Category = "Long")]
        public void InsectsThatComeFlying_BrakeAndLand(string name, int first, int count, WingDetail detail)
        {
            var flights = PerchFlights.Of(name);
            var all = Enumerable.Range(first, count).Select(seed => (Seed: seed, Flight: flights.FlyIn(seed, 0.8f, detail))).ToList();
            TestContext.Progress.WriteLine(string.Create(
                CultureInfo.InvariantCulture,
                $"{name}, {detail}: {all.Sum(at => at.Flight.Attempts)} new attempts of {count}, "
                + $"{all.Average(at => at.Flight.Seconds):0.0} s on average; "
                + $"lowest {all.Min(at => at.Flight.Lowest) * 1000:0.0} mm over the spot"));
            Assert.That(all.Where(at => !at.Flight.Landed).Select(at => at.Seed), Is.Empty, "in the air after two minutes");
            Assert.That(all.Where(at => at.Flight.Tumbled).Select(at => at.Seed), Is.Empty, "tumble");
            Assert.That(all.Min(at => at.Flight.Lowest), Is.GreaterThan(0f), "below the spot");
        }

        // A wind that begins as they do, as a gust; half of them came down within two minutes before they turned into it.
        [TestCase("monarch", 2, 0.5f)]
        [TestCase("monarch", 100, 0.25f, Explicit = true, Category = "Long")]
        [TestCase("swallowtail", 30, 0.25f, Explicit = true, Category = "Long")]
        [TestCase("dragonfly", 30, 0.25f, Explicit = true, Category = "Long")]
        [TestCase("painted-lichen-moth", 30, 0.25f, Explicit = true, Category = "Long")]
        [TestCase(FlownInsects.Hawkmoth, 30, 0.25f, Explicit = true, Category = "Long")]
        public void InAWind_InsectsLandAgainstIt(string name, int count, float wind)
        {
            var flights = PerchFlights.Of(name);
            int[] flying = [.. Enumerable.Range(1, count).Where(seed => !flights.Fly(seed, 0f, 20f, wind).Landed)];
            Assert.That(flying, Is.Empty, "in the air after two minutes");
        }

        private static void FlyAll(string name, int count, float leastSlope = 0f, float mostSlope = 45f)
        {
            var flights = PerchFlights.Of(name);
            var all = Enumerable.Range(1, count).Select(seed => flights.Fly(seed, leastSlope, mostSlope)).ToList();
            var down = all.Where(flight => flight.Landed).ToList();
            TestContext.Progress.WriteLine(string.Create(
                CultureInfo.InvariantCulture,
                $"{name}, {leastSlope} to {mostSlope}°: {down.Count} of {count} down, {all.Count(flight => flight.Tumbled)} tumbled, "
                + $"{all.Sum(flight => flight.Attempts)} new attempts, {all.Average(flight => flight.Seconds):0.0} s on average"));
            if (down.Count > 0)
            {
                TestContext.Progress.WriteLine(string.Create(
                    CultureInfo.InvariantCulture,
                    $"  held at {down.Max(flight => flight.HeldSpeed):0.000} m/s at most, "
                    + $"{down.Average(flight => flight.HeldSpeed):0.000} on average, "
                    + $"reference {down.Max(flight => flight.MeanSpeed):0.000}, "
                    + $"{down.Count(flight => flight.HeldSpeed > Landing.HoldSpeed)} too low to fly on; "
                    + $"{down.Max(flight => Math.Abs(flight.Gap)) * 1000:0.0} mm over and "
                    + $"{down.Max(flight => flight.Beside) * 1000:0.0} mm beside the place above the spot at most; "
                    + $"lowest on the way {down.Min(flight => flight.Below) * 1000:0.0} mm; "
                    + $"lowest after the start {down.Min(flight => flight.LeastHeight) * 1000:0.0} mm, "
                    + $"{down.Min(flight => flight.LeftBehind):0.00} m away at least"));
            }

            Assert.That(down, Has.Count.EqualTo(count));
            Assert.That(all.Where(flight => flight.Tumbled), Is.Empty);
            Assert.That(
                down.Count(flight => flight.HeldSpeed > Landing.HoldSpeed), Is.LessThanOrEqualTo(0.06 * count), "too low to fly on");
            Assert.That(down.Min(flight => flight.Gap), Is.GreaterThan(-0.5f * flights.WingLength), "wings clear the spot");

            // Who rocks beside a wall is held from farther off, and turns away from it before it leaves.
            bool isSteep = mostSlope > 45f;
            Assert.That(down.Max(flight => flight.Gap), Is.LessThan((isSteep ? 0.8f : 0.5f) * flights.WingLength));
            Assert.That(down.Max(flight => flight.Beside), Is.LessThan(0.8f * flights.WingLength));
            Assert.That(down.Min(flight => flight.LeastHeight), Is.GreaterThan(0f), "hovering insects sink before they climb");
            Assert.That(
                down.Min(flight => flight.LeftBehind),
                Is.GreaterThan((isSteep ? 0.8f : 1f) * math.max(0.3f, 5f * flights.WingLength)), "within three seconds");
        }
    }
}
