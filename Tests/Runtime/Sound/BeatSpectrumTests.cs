using System;
using System.Linq;
using Alate.Sound;
using NUnit.Framework;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests.Sound
{
    /// <summary>Overtones of a beat's force, against forces that are made of known ones.</summary>
    public sealed class BeatSpectrumTests
    {
        [TestCase(1)]
        [TestCase(2)]
        [TestCase(7)]
        [TestCase(16)]
        public void AForceOfOneOvertone_SoundsOfItAlone_WithAMeanSquareOfOne(int overtone)
        {
            float[] read = Read(phase => new float3(0.3f, 2f * math.cos(2f * math.PI * overtone * phase + 0.4f), 0f));

            for (int k = 0; k < read.Length; k++)
                Assert.That(read[k], Is.EqualTo(k + 1 == overtone ? math.sqrt(2f) : 0f).Within(0.02f), $"overtone {k + 1}");
        }

        [Test]
        public void Overtones_SoundByTheRateOfTheForce_FromAllAxes()
        {
            // 3 cos a up, and cos 2 a and sin 4 a to the side: 3, 2 and 4 times as strong in the rate.
            float[] read = Read(phase =>
            {
                float angle = 2f * math.PI * phase;
                return new float3(math.cos(2f * angle) + math.sin(4f * angle), 3f * math.cos(angle), 0f);
            });

            float unit = math.sqrt(2f / (9f + 4f + 16f));
            Assert.That(read.Take(4), Is.EqualTo(new[] { 3f * unit, 2f * unit, 0f, 4f * unit }).Within(0.01f));
        }

        // What counts as steady depends on the size of the force: a louder one has the same sound.
        [Test]
        public void Overtones_AreTheSame_WhateverTheUnitOfTheForce([Values(1e-6f, 1e-3f, 1e4f)] float unit)
        {
            float3 Force(float phase) => new float3(0.2f, math.cos(2f * math.PI * phase), 0.4f * math.sin(6f * math.PI * phase));
            float[] one = Read(Force), other = Read(phase => unit * Force(phase));

            Assert.That(other, Is.EqualTo(one).Within(1e-4f));
            Assert.That(Read(_ => unit * new float3(1f, 2f, 3f)), Is.All.Zero, "one that stays");
            Assert.That(one[0], Is.Positive);
        }

        [Test]
        public void AForceThatStays_OrThatNobodyKnows_IsSilent()
        {
            Assert.That(Read(_ => new float3(1f, 2f, 3f)), Is.All.LessThan(1e-3f));
            float[] read = Enumerable.Repeat(1f, BeatSpectrum.Overtones).ToArray();
            new BeatSpectrum().Read(read);
            Assert.That(read, Is.All.Zero);
        }

        [Test]
        public void PhasesBetweenFrames_LieOnALine_AndBrokenForcesAreLeftOut()
        {
            // 23 frames a beat, at phases that drift from beat to beat.
            var beat = new BeatSpectrum();
            for (int frame = 0; frame < 23; frame++)
                beat.Add(frame / 23f, new float3(0f, math.cos(2f * math.PI * frame / 23f), 0f));
            beat.Add(0.5f, new float3(float.NaN, 0f, 0f));
            beat.Add(float.NaN, new float3(1e3f, 0f, 0f));
            beat.Add(1.5f, new float3(1e3f, 0f, 0f));
            float[] read = new float[BeatSpectrum.Overtones];
            beat.Read(read);

            Assert.That(read[0], Is.EqualTo(math.sqrt(2f)).Within(0.1f));
            Assert.That(read.Skip(1).Max(), Is.LessThan(0.4f));
        }

        [Test]
        public void ANewForce_TakesThePlaceOfTheOld_AndClearForgetsIt()
        {
            var beat = new BeatSpectrum();
            var random = new Random(3u);
            for (int k = 0; k < 200; k++)
                beat.Add(random.NextFloat(), random.NextFloat3(-1f, 1f));
            for (int round = 0; round < 12; round++)
                Fill(beat, phase => new float3(0f, math.sin(6f * math.PI * phase), 0f));
            float[] read = new float[BeatSpectrum.Overtones];
            beat.Read(read);
            Assert.That(read[2], Is.EqualTo(math.sqrt(2f)).Within(0.02f));
            beat.Clear();
            beat.Read(read);
            Assert.That(read, Is.All.Zero);
        }

        [Test]
        public void AForceThatIsMetAgain_CountsHalf_AndAllOlderOnesTogetherTheOtherHalf()
        {
            // Three beats of one overtone each: a quarter, a quarter and a half of them are left.
            var beat = new BeatSpectrum();
            for (int overtone = 1; overtone <= 3; overtone++)
                Fill(beat, phase => new float3(0f, math.cos(2f * math.PI * overtone * phase), 0f));
            float[] read = new float[BeatSpectrum.Overtones];
            beat.Read(read);

            float unit = math.sqrt(2f / (1f + 4f + 36f));
            Assert.That(read.Take(4), Is.EqualTo(new[] { unit, 2f * unit, 6f * unit, 0f }).Within(1e-3f));
        }

        [TestCase(1.99e-4f, false)]
        [TestCase(2.01e-4f, true)]
        public void AForceIsSteady_WhereItsChangeIsBelowTheRoundingOfItsSquare(float share, bool isHeard)
        {
            // Half of the change's square is its mean square, half of which is one overtone's: a quarter is compared with 1e-8.
            float[] read = Read(phase => new float3(0f, 1f + share * math.cos(2f * math.PI * phase), 0f));
            Assert.That(read[0], Is.EqualTo(isHeard ? math.sqrt(2f) : 0f).Within(0.1f));
        }

        [Test]
        public void TheEndOfABeat_IsItsLastPhase_AndOnePhaseAloneIsSteady()
        {
            var beat = new BeatSpectrum();
            beat.Add(1f, new float3(0f, 5f, 0f));
            float[] read = new float[BeatSpectrum.Overtones];
            beat.Read(read);
            Assert.That(read, Is.All.Zero);

            // A second phase half a beat before: lines up and down, a triangle, whose even overtones are none and odd ones fall by n².
            beat.Add(0.5f - 0.5f / 64f, float3.zero);
            beat.Read(read);
            for (int k = 0; k < 6; k++)
                Assert.That(read[k], Is.EqualTo(k % 2 == 0 ? read[0] / (k + 1) : 0f).Within(0.01f), $"overtone {k + 1}");
            Assert.That(read[0], Is.GreaterThan(1f));
        }

        private static float[] Read(Func<float, float3> force)
        {
            var beat = new BeatSpectrum();
            Fill(beat, force);
            float[] read = new float[BeatSpectrum.Overtones];
            beat.Read(read);
            return read;
        }

        private static void Fill(BeatSpectrum beat, Func<float, float3> force)
        {
            for (int k = 0; k < 64; k++)
                beat.Add((k + 1e-3f) / 64f, force(k / 64f));
        }
    }
}
