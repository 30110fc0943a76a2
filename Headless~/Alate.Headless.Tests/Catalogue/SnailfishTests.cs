using System;
using System.Linq;
using Alate.Catalogue;
using Alate.Cli;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Insects
{
    /// <summary>Fins in water, hundreds of times denser than the air that the model was made for.</summary>
    public sealed class SnailfishTests
    {
        private const int k_Beats = 200;

        private static readonly Lazy<FlightRecord> s_Short = new Lazy<FlightRecord>(() => TetheredFlight.Fly(Swimming(20)));
        private static readonly Lazy<FlightRecord> s_Long = new Lazy<FlightRecord>(() => TetheredFlight.Fly(Swimming(k_Beats)));

        [Test]
        public void ItBeats_AsOftenAsItIsSet_OverTwoHundredBeats()
        {
            double turns = s_Long.Value.Wings[0].Frames.Last().Phase / (2.0 * Math.PI), expected = s_Long.Value.Seconds * SetFrequency;

            Assert.That(expected, Is.EqualTo(k_Beats).Within(0.1));
            Assert.That(Math.IEEERemainder(turns - expected, 1.0), Is.EqualTo(0.0).Within(0.01), "of a beat, after 200 by Eq. 6");
        }

        [Test]
        public void AfterTwoHundredBeats_ItStillBeatsAsAfterTwenty()
        {
            Assert.That(s_Long.Value.Wings.Sum(wing => wing.Resets), Is.Zero);
            for (int k = 0; k < s_Short.Value.Wings[0].Frames.Count; k++)
            {
                RecordedFrame late = s_Long.Value.Wings[0].Frames[k], early = s_Short.Value.Wings[0].Frames[k];
                for (int joint = 0; joint < late.Joints.Length; joint++)
                    Assert.That(math.distance(late.Joints[joint], early.Joints[joint]), Is.LessThan(2e-3f), $"frame {k}, joint {joint}");
            }
        }

        [Test]
        public void ItsWave_RunsOverTheFin_AsItIsSet()
        {
            double none = Delay(0f), half = Delay(0.1f), whole = Delay(0.2f);

            // What each tenth of a half beat adds: 18° from edge to edge, the larger part of it at mid-span.
            Assert.That(half - none, Is.InRange(9.0, 20.0));
            Assert.That(whole - half, Is.InRange(9.0, 20.0));
        }

        [Test]
        public void ItsTip_IsSlowerInWaterThanInAir_ByTheSameDrive()
        {
            FlightPlan water = Swimming(20);
            FlightRecord air = TetheredFlight.Fly(FlownParameters.Find("fluid-density").In(water, 1.225));

            Assert.That(TipSpeed(s_Short.Value.Wings[0]), Is.LessThan(0.99f * TipSpeed(air.Wings[0])));
        }

        // Eq. 6 at the speed it swims at.
        private static double SetFrequency
        {
            get
            {
                WingPreset preset = InsectCatalogue.Find("snailfish").Wings[0].CreatePreset();
                double drive = 1.0 / (1.0 + Math.Exp(-16.0 * (Cruise / preset.Beat.maxSpeed - 0.5)));
                double frequency = preset.Beat.maxFrequency * Math.Max(drive, preset.Beat.frequencyFloor);
                UnityEngine.Object.DestroyImmediate(preset);
                return frequency;
            }
        }

        private static double Cruise => FlightPlan.CruiseOf(InsectCatalogue.Find("snailfish"));

        private static FlightPlan Swimming(int beats) =>
            new FlightPlan { Species = "snailfish", Speed = Cruise, Seconds = beats / SetFrequency };

        private static double Delay(float chordDelay)
        {
            RecordedWing fin = TetheredFlight.Fly(Swimming(20) with { Lag = chordDelay }).Wings[0];
            var section = WingSection.Cut(fin.Rest, fin.Triangles, 0.5f);
            return PhaseDelay.Of(fin.Frames, frame => section.Leading(frame.Positions).y, frame => section.Trailing(frame.Positions).y);
        }

        // Wing lengths a second, mean over the beat, of the leading ray: in water the soft rear rays flick. Converged (96 substeps), the
        // fastest of all tips is at 8.30 in water and at 8.27 in air.
        private static float TipSpeed(RecordedWing wing)
        {
            int tip = wing.JointsPerChain - 1;
            float path = 0f;
            for (int k = 1; k < wing.Frames.Count; k++)
                path += math.distance(wing.Frames[k - 1].Joints[tip], wing.Frames[k].Joints[tip]);
            return path / (float)(wing.Frames[wing.Frames.Count - 1].Time - wing.Frames[0].Time);
        }
    }
}
