using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Insects
{
    /// <summary>
    /// The delay between leading and trailing edge at mid-span, by correlation. The wings only flap here: feathering moves the edges
    /// against one another by itself, on a rigid wing too.
    /// </summary>
    public sealed class DeformationWaveTests
    {
        private const float k_MidSpan = 0.5f;

        private static readonly float[] s_Delays = { 0f, 0.05f, 0.1f, 0.2f, 0.3f };

        private static readonly string[] s_Some = { "monarch", "fishfly" };

        private static IEnumerable<string> Others => InsectCatalogue.Names.Except(s_Some);

        [TestCaseSource(nameof(s_Some))]
        public void TheDriveAlone_HasNoDelayWithoutTheWave_AndMoreTheLargerLambdaIs(string species) => AssertDriven(species);

        [TestCaseSource(nameof(Others))]
        [Explicit]
        [Category("Long")]
        public void TheDriveAlone_OfAnyOtherSpecies_HasNoDelayWithoutTheWave_AndMoreTheLargerLambdaIs(string species) =>
            AssertDriven(species);

        [TestCaseSource(nameof(s_Some))]
        public void TheWholeModel_AddsToTheDelayOfTheLoads(string species) => AssertLoaded(species);

        [TestCaseSource(nameof(Others))]
        [Explicit]
        [Category("Long")]
        public void TheWholeModel_OfAnyOtherSpecies_AddsToTheDelayOfTheLoads(string species) => AssertLoaded(species);

        private static void AssertDriven(string species)
        {
            var delays = s_Delays.Select(delay => Delays(species, delay, holdJoints: true)).ToList();

            Assert.That(delays[0], Is.All.EqualTo(0.0).Within(0.1), "degrees");
            AssertRising(delays);
            // λ half beats from edge to edge are 180° λ; sections of a fan see a part of it.
            Assert.That(delays[2], Is.All.InRange(0.5 * 18.0, 1.1 * 18.0));
        }

        private static void AssertLoaded(string species)
        {
            var delays = s_Delays.Select(delay => Delays(species, delay, holdJoints: false)).ToList();

            Assert.That(delays[0], Is.All.InRange(0.0, 8.0), "without the wave the trailing edge follows by what the loads bend alone");
            AssertRising(delays);
        }

        private static void AssertRising(List<double[]> delays)
        {
            for (int k = 1; k < delays.Count; k++)
            {
                for (int wing = 0; wing < delays[k].Length; wing++)
                    Assert.That(delays[k][wing], Is.GreaterThan(delays[k - 1][wing] + 1.0), $"wing {wing}, λ {s_Delays[k]}");
            }
        }

        private static double[] Delays(string species, float chordDelay, bool holdJoints)
        {
            var plan = new FlightPlan
            {
                Species = species,
                Speed = FlightPlan.CruiseOf(InsectCatalogue.Find(species)),
                Substeps = 48,
                HoldJoints = holdJoints,
                Column = chordDelay > 0f ? ComparisonColumn.FullModel : ComparisonColumn.NoWave,
            };
            var insect = Insect.Of(plan);
            foreach (InsectWing wing in insect.Wings)
            {
                wing.Preset.Beat.featherRange = wing.Preset.Beat.sweepRange = 0f;
                wing.Preset.Wave.chordDelay = chordDelay;
            }

            using var flight = new TetheredFlight(plan, insect);
            return flight.Run(_ => { }).Wings.Where(wing => !wing.Placement.IsLeft).Select(Delay).ToArray();
        }

        private static double Delay(RecordedWing wing)
        {
            var section = WingSection.Cut(wing.Rest, wing.Triangles, k_MidSpan);
            return PhaseDelay.Of(wing.Frames, frame => section.Leading(frame.Positions).y, frame => section.Trailing(frame.Positions).y);
        }
    }
}
