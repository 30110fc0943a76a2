using System.Collections.Generic;
using System.Linq;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.FreeFlights
{
    /// <summary>Insects fly a mission by their wings alone, in steps of games.</summary>
    public sealed class MissionTests
    {
        /// <summary>Largest errors of the species, m/s; a tumble would be above 1.</summary>
        private static readonly Dictionary<string, double> s_Bounds = new Dictionary<string, double>
        {
            ["hover"] = 0.06,
            ["step"] = 0.21,
            ["cruise"] = 0.06,
            ["turn"] = 0.19,
            ["climb"] = 0.07,
            ["side gust"] = 0.34,
            ["head gust"] = 0.36,
            ["stop"] = 0.21,
            ["rest"] = 0.06,
        };

        [Test]
        public void TheMonarch_FliesTheMission() => Fly("monarch", 0.02f);

        [Test, Explicit, Category("Long")]
        public void EverySpecies_FliesTheMission(
            [Values("monarch", "swallowtail", "firefly", "fishfly", "painted-lichen-moth", "dragonfly")] string species,
            [Values(0.01f, 0.02f)] float dt) =>
            Fly(species, dt);

        [Test]
        [Explicit]
        [Category("Long")]
        [Category("Faults")]
        public void WithAPositionLoop_AMinuteOfHovering_StaysWithinAMetre() => Hover("monarch");

        [Test, Explicit, Category("Long")]
        public void WithAPositionLoop_AMinuteOfHoveringOfEverySpecies_StaysWithinAMetre(
            [Values("swallowtail", "firefly", "fishfly", "painted-lichen-moth", "dragonfly")] string species) =>
            Hover(species);

        [Test]
        public void AGustOfOneMetreASecond_IsRecoveredWithinTwoSeconds() => MeetAGust("monarch");

        [Test, Explicit, Category("Long")]
        public void AGustOfOneMetreASecond_IsRecoveredWithinTwoSeconds_ByEverySpecies(
            [Values("swallowtail", "firefly", "fishfly", "painted-lichen-moth", "dragonfly")] string species) =>
            MeetAGust(species);

        [Test]
        public void TheBodysPower_IsThatOfItsWings_AndAsMuchAsTheAirTakesFromThem()
        {
            using var insect = new FlyingInsect("monarch");
            using var flight = new FreeFlight(insect.Model, insect.Table);
            double mean = 0.0;
            for (int step = 0; step < 50; step++)
            {
                flight.Step(FlightCommand.Fly(default, 0f), 0.02f);
                double sum = 0.0;
                for (int wing = 0; wing < flight.Wings.Count; wing++)
                {
                    FlightWing flown = insect.Model.Wings[wing];
                    sum += flight.World.Read(flight.Wings[wing]).AirPower * (flown.Mass * flown.Length * flown.Length);
                }

                Assert.That(sum, Is.EqualTo(flight.Power).Within(1e-4).Percent.Or.EqualTo(flight.Power).Within(1e-7));
                mean += sum / 50.0;
            }

            Assert.That(mean, Is.InRange(1e-3, 50e-3), "watts");
        }

        private static void Hover(string species)
        {
            using var insect = new FlyingInsect(species);
            using var flight = new FreeFlight(insect.Model, insect.Table);
            float farthest = 0f;
            while (flight.Time < 60)
            {
                float3 back = -flight.Position;
                flight.Step(FlightCommand.Fly(math.clamp(0.8f * back, -0.3f, 0.3f), 0f), 0.02f);
                farthest = math.max(farthest, math.length(flight.Position));
            }

            TestContext.Out.WriteLine($"{species}: {farthest:0.000} m");
            Assert.That(farthest, Is.LessThan(1f));
        }

        private static void MeetAGust(string species)
        {
            using var insect = new FlyingInsect(species);
            using var flight = new FreeFlight(insect.Model, insect.Table, new FlightCondition(1.3f, 0f));
            var errors = new List<float>();
            while (flight.Time < 6)
            {
                flight.Wind = flight.Time >= 2 && flight.Time < 3 ? new float3(1f, 0f, 0f) : default;
                flight.Step(FlightCommand.Fly(new float3(0f, 0f, 1.3f)), 0.01f);
                if (flight.Time > 5)
                    errors.Add(math.length(flight.VelocityError));
            }

            TestContext.Out.WriteLine($"{species}: {errors.Max():0.000} m/s left two seconds after the gust");
            Assert.That(errors.Max(), Is.LessThan(0.2f));
        }

        private static void Fly(string species, float dt)
        {
            using var insect = new FlyingInsect(species);
            Dictionary<string, double> errors = insect.Mission(dt);

            TestContext.Out.WriteLine(
                $"{species} at {dt} s: " + string.Join(", ", errors.Select(error => $"{error.Key} {error.Value:0.000}")));
            foreach ((string part, double error) in errors)
                Assert.That(error, Is.LessThanOrEqualTo(s_Bounds[part]), part);
        }
    }
}
