using System;
using System.Collections.Generic;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests.FreeFlights
{
    /// <summary>Insects wander by their wings alone, without aid.</summary>
    public sealed class WanderFlights
    {
        /// <summary>Seconds of a flight.</summary>
        private const double k_Seconds = 40;

        private static readonly FlightVolume s_Volume = new FlightVolume(VolumeShape.Box, Vector3.zero, new Vector3(4f, 1.6f, 4f));

        // A seed that tumbled with this step while the wanderer asked for all the acceleration that the reference follows.
        [Test]
        [Explicit]
        [Category("Long")]
        [Category("Faults")]
        public void AMonarch_Wanders() => Fly("monarch", 0.01f, [14]);

        [Test, Explicit, Category("Long")]
        public void OfAHundredMonarchs_NoneTumbles([Values(0.01f, 1f / 60f, 0.02f)] float step) => Fly("monarch", step, Seeds(100));

        [Test, Explicit, Category("Long")]
        public void OfTwentyInsects_NoneTumbles(
            [Values("swallowtail", "firefly", "fishfly", "painted-lichen-moth", "dragonfly")] string species,
            [Values(0.01f, 0.02f)] float step) =>
            Fly(species, step, Seeds(20));

        private static IEnumerable<int> Seeds(int count)
        {
            for (int seed = 1; seed <= count; seed++)
                yield return seed;
        }

        private static void Fly(string species, float step, IEnumerable<int> seeds)
        {
            using var insect = new FlyingInsect(species);
            var tumbled = new List<string>();
            double worst = 0, path = 0, seconds = 0;
            foreach (int seed in seeds)
            {
                using var flight = new FreeFlight(insect.Model, insect.Table);
                var course = new ErraticCourse(seed);
                while (flight.Time < k_Seconds && flight.State != FlightState.Tumbling)
                {
                    FlightSituation situation = flight.Situation(step);
                    var command = FlightCommand.Fly(course.Next(situation, s_Volume, WanderSettings.Default));
                    flight.Step(command, step);
                    worst = Math.Max(worst, flight.Tilt);
                    path += math.length(flight.Velocity) * step;
                }

                seconds += flight.Time;
                if (flight.State == FlightState.Tumbling)
                    tumbled.Add(FormattableString.Invariant($"{seed} after {flight.Time:0.0} s"));
            }

            TestContext.Out.WriteLine(FormattableString.Invariant(
                $"{species}, {step:0.0000} s: {path / seconds:0.00} m/s, largest turn out of the trim {worst * 180 / Math.PI:0}°"));
            Assert.That(tumbled, Is.Empty);
            Assert.That(path / seconds, Is.InRange(0.7, 1.3), "m/s");
        }
    }
}
