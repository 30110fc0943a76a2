using System.Collections.Generic;
using System.Linq;
using Alate.Tests.Flight;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.FreeFlights
{
    /// <summary>Insects that hover or wander without aid meet gusts from all sides, and right themselves where they tumble.</summary>
    public sealed class GustTests
    {
        /// <summary>Seeds of a flight, and share of the flights into strong gusts that recover.</summary>
        private const int k_Seeds = 10;
        private const double k_Recover = 0.9;

        // From the side: a hovering monarch falls over.
        [Test]
        public void AMonarchThatAGustThrowsOver_RightsItself()
        {
            using var insect = new FlyingInsect("monarch");
            var flight = new GustFlight(insect, 0.02f);
            flight.Fly(new float3(1f, 0f, 0f), false, 1);
            Assert.That(flight.Tumbled, Is.GreaterThan(0.0).And.LessThan(1.0), "seconds");
            Assert.That(flight.Recovers);
        }

        [Test, Explicit, Category("Long")]
        public void OfGustsOfOneMetreASecond_NoneTumblesAnInsectForASecond(
            [ValueSource(typeof(FlownInsects), nameof(FlownInsects.All))] string species, [Values] bool wanders) =>
            Assert.That(Fly(species, 1f, wanders).Max(flight => flight.Tumbled), Is.LessThanOrEqualTo(1.0), "seconds");

        [Test, Explicit, Category("Long")]
        public void OfGustsOfTwoMetresASecond_InsectsRecoverWithinThreeMetres(
            [ValueSource(typeof(FlownInsects), nameof(FlownInsects.All))] string species, [Values] bool wanders) =>
            Assert.That(Fly(species, 2f, wanders).Average(flight => flight.Recovers ? 1.0 : 0.0), Is.GreaterThanOrEqualTo(k_Recover));

        private static List<GustFlight> Fly(string species, float speed, bool wanders)
        {
            using var insect = new FlyingInsect(species);
            var flights = new List<GustFlight>();
            foreach (float3 side in Sides())
            {
                for (int seed = 1; seed <= k_Seeds; seed++)
                {
                    var flight = new GustFlight(insect, 0.02f);
                    flight.Fly(speed * side, wanders, seed);
                    flights.Add(flight);
                }
            }

            var tumbled = flights.Where(flight => flight.Tumbled > 0).ToList();
            TestContext.Out.WriteLine(
                $"{species} {(wanders ? "wanders" : "hovers")}, {speed} m/s: {flights.Count} flights, {tumbled.Count} tumbled, longest "
                + $"{flights.Max(flight => flight.Tumbled):0.00} s, {flights.Count(flight => flight.Tumbled > 0.5)} beyond 0.5 s; "
                + $"{flights.Count(flight => flight.Recovers)} recovered, farthest {flights.Max(flight => flight.TumbleWay):0.0} m in a "
                + $"tumble, {flights.Max(flight => flight.Lost):0.0} m off, {flights.Max(flight => flight.Sunk):0.0} m down; "
                + $"recovery of 90 % within {flights.Select(flight => flight.Recovery).Order().ElementAt(flights.Count * 9 / 10):0.00} s");
            return flights;
        }

        // Faces, edges and corners of a cube.
        private static IEnumerable<float3> Sides()
        {
            for (int k = 0; k < 27; k++)
            {
                var side = new float3(k / 9 - 1, k / 3 % 3 - 1, k % 3 - 1);
                if (math.any(side != 0f))
                    yield return math.normalize(side);
            }
        }
    }
}
