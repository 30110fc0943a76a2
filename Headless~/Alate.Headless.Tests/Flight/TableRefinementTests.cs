using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.FreeFlights
{
    /// <summary>Trim tables are fine enough to fly by what is mixed of two of their points, and get points where they are not.</summary>
    public sealed class TableRefinementTests
    {
        [Test]
        [Explicit]
        [Category("Long")]
        [Category("Faults")]
        public void BetweenItsSlowestSpeeds_ASwallowtailFlies() =>
            FlyBetween("swallowtail", (speed, climb) => speed < 0.08f && math.abs(climb) < 0.08f);

        [TestCase("monarch")]
        [TestCase("swallowtail")]
        [TestCase("firefly")]
        [TestCase("fishfly")]
        [TestCase("painted-lichen-moth")]
        [TestCase("dragonfly")]
        [Explicit]
        [Category("Long")]
        public void BetweenAnyTwoPointsOfItsTable_AnInsectFlies(string species)
        {
            // Straight down at more than 0.15 m/s a monarch tumbles; pilots do not ask for it.
            FlyBetween(species, (speed, climb) => species != "monarch" || speed > 0.2f || climb > -0.15f);
        }

        [Test]
        [Explicit]
        [Category("Long")]
        public void WhereTwoSpeedsDoNotMix_ATableGetsMore()
        {
            using var insect = new FlyingInsect("swallowtail");
            using TrimTable table = new TrimBake(insect.Model).Bake([0f, 0.15f], [-0.15f, 0f]);
            Assert.That(table.Speeds, Has.Length.GreaterThan(2));
            Assert.That(table.Speeds, Is.Ordered);
            Assert.That((table.Speeds[0], table.Speeds[^1]), Is.EqualTo((0f, 0.15f)));
            for (int s = 0; s < table.Speeds.Length; s++)
                Assert.That(table.IsClosed(s, table.LevelClimb), $"{table.Speeds[s]} m/s");
        }

        // The guard of commands lets a slow firefly climb by 0.03 m/s, where trims for 0.3 m/s hardly count.
        [Test]
        public void TrimsThatDoNotFit_AreNoticed_WhereTheGuardOfCommandsWouldNotFly()
        {
            using var insect = new FlyingInsect("firefly");
            TrimTable table = insect.Table;
            int s = Array.FindIndex(table.Speeds, speed => speed > 0.2f), c = Array.IndexOf(table.ClimbRates, 0.3f);
            var between = new FlightCondition(0.5f * (table.Speeds[s - 1] + table.Speeds[s]), table.ClimbRates[c]);
            Assert.That(table.IsClosed(s - 1, c) && table.IsClosed(s, c));
            Assert.That(TableFlight.Mixes(insect.Model, table, between));
            foreach (int speed in new[] { s - 1, s })
            {
                float[] off = (float[])table.Point(speed, c).Clone();
                off[TrimPoint.Pitch] += 0.3f;
                table.Set(speed, c, off);
            }

            table.Fill();
            Assert.That(TableFlight.Mixes(insect.Model, table, between), Is.False);
        }

        [Test]
        public void AnotherSpeedOrClimb_LeavesThePointsAsTheyAre()
        {
            using var insect = new FlyingInsect("swallowtail");
            TrimTable table = insect.Table;
            using TrimTable faster = table.WithSpeed(0.5f), steeper = table.WithClimb(0.01f);
            int s = Array.IndexOf(faster.Speeds, 0.5f), c = Array.IndexOf(steeper.ClimbRates, 0.01f);
            Assert.That(faster.Speeds.Where((_, k) => k != s), Is.EqualTo(table.Speeds));
            Assert.That(steeper.ClimbRates.Where((_, k) => k != c), Is.EqualTo(table.ClimbRates));
            foreach ((int speed, int climb) in Points(table))
            {
                Assert.That(faster.IsClosed(speed < s ? speed : speed + 1, climb), Is.EqualTo(table.IsClosed(speed, climb)));
                Assert.That(steeper.IsClosed(speed, climb < c ? climb : climb + 1), Is.EqualTo(table.IsClosed(speed, climb)));
                if (!table.IsClosed(speed, climb))
                    continue;
                Assert.That(faster.Point(speed < s ? speed : speed + 1, climb), Is.EqualTo(table.Point(speed, climb)));
                Assert.That(steeper.Point(speed, climb < c ? climb : climb + 1), Is.EqualTo(table.Point(speed, climb)));
            }

            Assert.That(Enumerable.Range(0, table.ClimbRates.Length).Any(climb => faster.IsClosed(s, climb)), Is.False);
            Assert.That(Enumerable.Range(0, table.Speeds.Length).Any(speed => steeper.IsClosed(speed, c)), Is.False);
        }

        private static IEnumerable<(int Speed, int Climb)> Points(TrimTable table) =>
            from speed in Enumerable.Range(0, table.Speeds.Length)
            from climb in Enumerable.Range(0, table.ClimbRates.Length)
            select (speed, climb);

        // Halfway between two speeds of a climb, and between two climbs of a speed.
        private static void FlyBetween(string species, Func<float, float, bool> isFlown)
        {
            using var insect = new FlyingInsect(species);
            TrimTable table = insect.Table;
            int count = 0;
            foreach ((int speed, int climb) in Points(table).Where(at => table.IsClosed(at.Speed, at.Climb)))
            {
                foreach ((int s, int c) in new[] { (speed + 1, climb), (speed, climb + 1) })
                {
                    if (s == table.Speeds.Length || c == table.ClimbRates.Length || !table.IsClosed(s, c))
                        continue;
                    var middle = new FlightCondition(
                        0.5f * (table.Speeds[speed] + table.Speeds[s]), 0.5f * (table.ClimbRates[climb] + table.ClimbRates[c]));
                    if (!isFlown(middle.Speed, middle.Climb))
                        continue;
                    count++;
                    Fly(insect, middle);
                }
            }

            Assert.That(count, Is.Positive);
        }

        private static void Fly(FlyingInsect insect, FlightCondition condition)
        {
            // Between the points themselves: the guard of commands keeps a slow insect from climbing and sinking as fast.
            using var flight = new FreeFlight(insect.Model, insect.Table, condition) { GuardCommands = false };
            var command = FlightCommand.Fly(new float3(0f, condition.Climb, condition.Speed), 0f);
            while (flight.Time < 3)
            {
                flight.Step(command, 0.0125f);
                Assert.That(flight.State, Is.EqualTo(FlightState.Flying), $"{condition}, {flight.Time:0.00} s");
            }

            float3 from = flight.Position;
            double start = flight.Time;
            while (flight.Time < 5)
                flight.Step(command, 0.0125f);
            float3 mean = (flight.Position - from) / (float)(flight.Time - start);
            Assert.That(math.distance(mean, command.velocity), Is.LessThan(0.15f), $"{condition} flies by {mean}");
        }
    }
}
