using System;
using NUnit.Framework;
using UnityEngine.TestTools.Constraints;
using Is = UnityEngine.TestTools.Constraints.Is;

namespace Alate.Editor.Tests
{
    public sealed class BeatTraceTests
    {
        [Test]
        public void Trace_KeepsTheNewestSamples_OldestFirst()
        {
            var trace = new BeatTrace(4, 100.0);
            for (int k = 0; k < 11; k++)
                trace.Add(new BeatSample(k, k, 0f));

            Assert.That(trace.Count, Is.EqualTo(4));
            for (int k = 0; k < 4; k++)
                Assert.That(trace[k].flap, Is.EqualTo(7f + k));
            Assert.That(trace.Last.flap, Is.EqualTo(10f));
        }

        [Test]
        public void SameTimeAgain_IsNotASample()
        {
            var trace = new BeatTrace(8, 4.0);
            trace.Add(new BeatSample(1.5, 1f, 0f));
            trace.Add(new BeatSample(1.5, 2f, 0f));

            Assert.That(trace.Count, Is.EqualTo(1));
            Assert.That(trace.Last.flap, Is.EqualTo(1f));
        }

        [Test]
        public void EarlierTime_BeginsANewTrace()
        {
            var trace = new BeatTrace(8, 4.0);
            trace.Add(new BeatSample(7.0, 1f, 0f));
            trace.Add(new BeatSample(8.0, 1f, 0f));
            trace.Add(new BeatSample(0.1, 5f, 0f));

            Assert.That(trace.Count, Is.EqualTo(1));
            Assert.That(trace.Last.flap, Is.EqualTo(5f));
        }

        [TestCase(double.NaN, 0f, 0f)]
        [TestCase(double.PositiveInfinity, 0f, 0f)]
        [TestCase(2.0, float.NaN, 0f)]
        [TestCase(2.0, 0f, float.NegativeInfinity)]
        public void SamplesThatAreNotFinite_AreLeftOut(double beat, float flap, float lift)
        {
            var trace = new BeatTrace(8, 4.0);
            trace.Add(new BeatSample(1.0, 0f, 0f));
            trace.Add(new BeatSample(beat, flap, lift));

            Assert.That(trace.Count, Is.EqualTo(1));
        }

        [Test]
        public void FoldedBeat_IsTheSameWave_HoweverFarApartTheFramesAre()
        {
            // At 62 beats a second every frame is more than a whole beat after the last.
            foreach (double beatsPerFrame in new[] { 0.0137, 0.1467, 1.0337 })
            {
                var trace = new BeatTrace(256, 1e6);
                for (int frame = 0; frame < 256; frame++)
                    trace.Add(Wave(frame * beatsPerFrame));

                ReadOnlySpan<BeatSample> folded = trace.Fold();

                Assert.That(folded.Length, Is.EqualTo(256));
                for (int k = 0; k < folded.Length; k++)
                {
                    Assert.That(folded[k].flap, Is.EqualTo(60.0 * Math.Cos(2.0 * Math.PI * folded[k].Phase)).Within(1e-2));
                    Assert.That(k == 0 || folded[k].Phase >= folded[k - 1].Phase, "phases are not in order");
                }
            }
        }

        [Test]
        public void FoldedBeat_IsOfTheLastBeatsOnly()
        {
            var trace = new BeatTrace(512, 3.0);
            for (int frame = 0; frame <= 500; frame++)
                trace.Add(Wave(0.1 * frame));

            foreach (BeatSample sample in trace.Fold())
                Assert.That(sample.beat, Is.InRange(47.0 - 1e-9, 50.0));
            Assert.That(trace.Fold().Length, Is.EqualTo(31).Within(1));
        }

        [Test]
        public void EmptyTrace_FoldsToNothing()
        {
            var trace = new BeatTrace(8, 4.0);
            trace.Add(Wave(1.0));
            trace.Clear();

            Assert.That(trace.Fold().Length, Is.Zero);
            Assert.That(trace.Last.flap, Is.Zero);
        }

        [Test]
        public void FullTrace_AllocatesNothing()
        {
            var trace = new BeatTrace(64, 4.0);
            for (int frame = 0; frame < 100; frame++)
                trace.Add(Wave(0.1 * frame));

            Assert.That(() => trace.Add(Wave(100.0)), Is.Not.AllocatingGCMemory());
        }

        [Test]
        public void ImpossibleTraces_AreRefusedWithTheValue()
        {
            Assert.That(
                () => new BeatTrace(0, 1.0), Throws.InstanceOf<ArgumentOutOfRangeException>().With.Property("ActualValue").EqualTo(0));
            Assert.That(
                () => new BeatTrace(1, double.NaN), Throws.InstanceOf<ArgumentOutOfRangeException>().With.Property("ActualValue").NaN);
            Assert.That(() => new BeatTrace(1, 1.0)[0], Throws.InstanceOf<ArgumentOutOfRangeException>());
        }

        private static BeatSample Wave(double beat) =>
            new BeatSample(beat, (float)(60.0 * Math.Cos(2.0 * Math.PI * beat)), (float)Math.Sin(2.0 * Math.PI * beat));
    }
}
