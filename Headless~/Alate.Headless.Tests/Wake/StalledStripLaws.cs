using System;
using System.Linq;
using Alate.Cli;
using Alate.Flight;
using Alate.Tests.FreeFlights;
using Alate.Wake;
using NUnit.Framework;

namespace Alate.Tests.Wake
{
    /// <summary>Strips beyond the stall, where lift falls with the angle: one smooth circulation, whatever their number.</summary>
    public sealed class StalledStripLaws
    {
        [Test]
        public void AStalledWing_HasOneSmoothCirculation_WhateverTheNumberOfStrips([Values(50, 60, 70, 80)] int degrees)
        {
            float[] lifts = Array.ConvertAll(new[] { 10, 20, 40 }, panels =>
            {
                using FreeWake wake = Fly(degrees, panels);
                float[] circulation = Array.ConvertAll(wake.Wings[0].Lattice.Circulation, ring => -ring);
                float most = circulation.Max();
                Assert.That(wake.Failures, Is.Zero, $"{panels} strips");
                Assert.That(circulation.Min(), Is.GreaterThan(0f), $"{panels} strips turn one way");
                Assert.That(circulation.Zip(circulation.Skip(1), (a, b) => Math.Abs(b - a)).Skip(1).SkipLast(1).Max(),
                    Is.LessThan(0.5f * most), $"{panels} strips, away from the ends");
                return wake.Loads(0).Force.y;
            });

            Assert.That(lifts[1], Is.EqualTo(lifts[2]).Within(5).Percent);
            Assert.That(lifts[0], Is.EqualTo(lifts[2]).Within(10).Percent);
        }

        // Their wings stand across the air, a right angle within the stroke; without the exchange a tenth of the steps finds none.
        [Test]
        public void WingsThatHover_FindTheirCirculationInEachStep([Values("monarch", "swallowtail", "painted-lichen-moth")] string species)
        {
            using var insect = new FlyingInsect(species);
            var trim = TrimState.Read(insect.Table.PointNear(0f, 0f), insect.Model.Frequency);
            var motion = new TrimMotion(insect.Model, trim, new FlightCondition(0f, 0f), TrimPoint.Pairs, 8);
            var settings = new WakeSettings { Symmetric = true };
            settings.WidenCores();
            using var wake = new FreeWake(settings, motion.Wings);
            for (int k = 0; k < 12 * settings.StepsPerBeat; k++)
                wake.Step();

            Assert.That(wake.Failures, Is.Zero, $"of {wake.StepCount} steps");
        }

        [Test]
        public void Neighbours_OfOneWing_ExchangeWhatTheStalledOneAnswers()
        {
            var stalled = new StalledStrips([0, 3, 5]);
            float[] circulation = [1f, 4f, 2f, 7f, 3f];
            Assert.That(stalled.Meet(1, -3f), Is.False, "attached: it answers against what it has");
            Assert.That(stalled.Taken(0, 1, circulation), Is.Zero);
            Assert.That(new[] { stalled.Meet(1, 2f), stalled.Meet(1, 1f), stalled.Meet(3, 0.5f), stalled.Meet(2, 0.1f) },
                Is.EqualTo(new[] { true, false, true, true }), "the largest answer of a step counts");

            Assert.That(stalled.Taken(0, 1, circulation), Is.EqualTo(2f * (1f - 4f + 2f - 4f)));
            Assert.That(stalled.Taken(1, 3, circulation), Is.EqualTo(0.5f * (3f - 7f)), "nothing from another wing");
            Assert.That(stalled.Taken(0, 2, circulation), Is.EqualTo(0.1f * (4f - 2f)).Within(1e-6f), "nor to one");
            Assert.That(stalled.Taken(0, 0, circulation), Is.Zero, "attached");
            stalled.Clear();
            Assert.That(stalled.Taken(0, 1, circulation), Is.Zero);
        }

        [Test]
        public void TheSlope_IsThatOfWhatIsTaken([Range(0, 4)] int strip, [Range(0, 4)] int source)
        {
            var stalled = new StalledStrips([0, 3, 5]);
            for (int k = 0; k < 5; k++)
                stalled.Meet(k, 0.5f + k);
            int wing = strip < 3 ? 0 : 1;
            float[] circulation = new float[5];
            float before = stalled.Taken(wing, strip, circulation);
            circulation[source] = 1f;
            Assert.That(stalled.Slope(wing, strip, source), Is.EqualTo(stalled.Taken(wing, strip, circulation) - before));
        }

        // A rectangle of six chords that is dragged along at an angle, until the wake of its start is far away.
        private static FreeWake Fly(int degrees, int panels)
        {
            var settings = new WakeSettings
            {
                SpanPanels = panels,
                StepsPerBeat = 8,
                Keep = 4f,
                Stream = new(0f, 0f, -4f),
            };
            settings.WidenCores();
            var wake = new FreeWake(
                settings, [new WakeWing(ThinWing.Steady(6f, Math.PI / 180.0 * degrees)) { Downwash = MeasuredDownwash.None }]);
            for (int k = 0; k < 40; k++)
                wake.Step();
            return wake;
        }
    }
}
