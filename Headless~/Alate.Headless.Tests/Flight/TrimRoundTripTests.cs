using System;
using System.Linq;
using Alate.Cli;
using Alate.Flight;
using NUnit.Framework;

namespace Alate.Tests.FreeFlights
{
    /// <summary>Shipped tables are those that their makers make of their own trims.</summary>
    public sealed class TrimRoundTripTests
    {
        [TestCase("monarch")]
        [TestCase("dragonfly")]
        public void GainsOfATable_AreThoseOfItsTrims(string species)
        {
            using var insect = new FlyingInsect(species);
            float[] point = Point(insect, out TrimState trim, out FlightCondition condition);
            using var tunnel = new FlightTunnel(insect.Model, BeatMap.Insects);
            var map = BeatMap.Fly(tunnel, insect.Model, trim, condition);
            float[] again = new float[point.Length];
            trim.Write(again, insect.Model.Frequency);

            Assert.That(FlightGains.Write(map, again), Is.True);
            Assert.That(map.Period, Is.EqualTo(1.0 / point[TrimPoint.Drive]).Within(1e-3).Percent);
            Assert.That(again.Take(TrimPoint.LongGains), Is.EqualTo(point.Take(TrimPoint.LongGains)));
            double size = point.Skip(TrimPoint.LongGains).Max(Math.Abs);
            for (int k = TrimPoint.LongGains; k < point.Length; k++)
                Assert.That(again[k], Is.EqualTo(point[k]).Within(2e-3 * size), $"gain {k}");
        }

        [TestCase("monarch")]
        [TestCase("dragonfly")]
        public void ATablesTrim_Balances_AndItsPowerIsThatOfTheSteadyFlight(string species)
        {
            using var insect = new FlyingInsect(species);
            Point(insect, out TrimState trim, out FlightCondition condition);
            using var solver = new TrimSolver(insect.Model);
            double[] residual = solver.Residual(trim, condition, out double power);
            var flown = FlightMeans.Fly(insect.Model, insect.Table, condition);

            Assert.That(TrimSolver.Norm(residual), Is.LessThan(TrimSolver.Closed));
            Assert.That(power, Is.EqualTo(flown.Power).Within(5).Percent, "W");
        }

        // Pitch, frequency, amplitude, tilt or mean sweep is off; what the flight settles on is a trim, whose beat and attitude a second
        // flight hardly changes, and whose bob a third one: with the air of wakes a flight takes its bob half of the way.
        [Test]
        public void WhatAFlightSettlesOn_IsATrim([Values(0, 3)] int part) => AssertSettles(part);

        [Test]
        [Explicit]
        [Category("Long")]
        public void WhatAFlightSettlesOn_FromEachOtherPart_IsATrim([Values(1, 2, 4)] int part) => AssertSettles(part);

        private static void AssertSettles(int part)
        {
            using var insect = new FlyingInsect("monarch");
            float[] point = Point(insect, out TrimState trim, out FlightCondition condition);
            TrimState moved = trim.Copy();
            moved.z[part] += 0.02;
            TrimState once = FlownTrim.Fly(insect.Model, point, moved, condition, out _),
                twice = FlownTrim.Fly(insect.Model, point, once, condition, out _),
                thrice = FlownTrim.Fly(insect.Model, point, twice, condition, out _);
            using var solver = new TrimSolver(insect.Model);
            double before = TrimSolver.Norm(solver.Residual(moved, condition, out _)),
                after = TrimSolver.Norm(solver.Residual(twice, condition, out _));

            Assert.That(Off(twice.z, once.z), Is.LessThan(0.4 * Off(once.z, moved.z)));
            Assert.That(Off(twice.bob, once.bob), Is.LessThan(0.7 * Off(once.bob, moved.bob)));
            Assert.That(Off(thrice.bob, twice.bob), Is.LessThan(0.4 * Off(once.bob, moved.bob)));
            Assert.That(after, Is.LessThan(TrimSolver.Closed).And.LessThan(0.4 * before));
        }

        private static double Off(double[] a, double[] b) => a.Zip(b, (x, y) => Math.Abs(x - y)).Max();

        private static float[] Point(FlyingInsect insect, out TrimState trim, out FlightCondition condition)
        {
            int s = Enumerable.Range(0, insect.Table.Speeds.Length).MinBy(k => Math.Abs(insect.Table.Speeds[k] - 1f)),
                c = insect.Table.LevelClimb;
            condition = new FlightCondition(insect.Table.Speeds[s], insect.Table.ClimbRates[c]);
            float[] point = insect.Table.Point(s, c);
            trim = TrimState.Read(point, insect.Model.Frequency);
            return point;
        }
    }
}
