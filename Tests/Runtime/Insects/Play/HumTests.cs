using System;
using System.Collections;
using Alate.Sound;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;
using UnityEngine.TestTools.Constraints;
using Is = UnityEngine.TestTools.Constraints.Is;

namespace Alate.Tests.Play
{
    /// <summary>The sound of an insect that beats its wings.</summary>
    public sealed class HumTests : PlayFixture
    {
        [TearDown]
        public void GiveBackTheTime() => Time.timeScale = 1f;

        [UnityTest]
        public IEnumerator TheTone_HasTheBeatsFrequency_AndFollowsThePower()
        {
            InsectWings insect = Insect();
            InsectHum hum = AddHum(insect);
            float[] levels = new float[2], powers = new float[2];
            for (int round = 0; round < 2; round++)
            {
                insect.Steering.frequencyScale = round == 0 ? 1f : 1.5f;
                yield return Frames(60);
                for (int frame = 0; frame < 120; frame++)
                {
                    yield return null;
                    powers[round] += insect.AirPower / 120f;
                    levels[round] += hum.Level * hum.Level / 120f;
                    Assert.That(hum.Frequency, Is.EqualTo(insect.Frequency).Within(1e-4).Percent);
                }
            }

            Assert.That(powers[1], Is.GreaterThan(1.5f * powers[0]));
            for (int round = 0; round < 2; round++)
                Assert.That(levels[round], Is.EqualTo(hum.Volume * hum.Volume * 1000f * powers[round] / hum.FullPower).Within(10).Percent);
        }

        [UnityTest]
        public IEnumerator Overtones_AreThoseOfTheAirsForceOverTheBeat()
        {
            InsectWings insect = Insect();
            InsectHum hum = AddHum(insect);
            var beat = new BeatSpectrum();
            for (int frame = 0; frame < 240; frame++)
            {
                yield return null;
                beat.Add(insect.Phase / 360f % 1f, insect.AirForce);
            }

            float[] overtones = new float[BeatSpectrum.Overtones];
            beat.Read(overtones);
            int rate = AudioSettings.outputSampleRate;
            float[] heard = Heard(hum, rate);
            for (int k = 0; k < 4; k++)
            {
                Assert.That(Strength(heard, (k + 1) * hum.Frequency, rate),
                    Is.EqualTo(hum.Level * overtones[k]).Within(0.05f * hum.Level), $"overtone {k + 1}");
            }

            Assert.That(overtones[0] + overtones[1], Is.GreaterThan(0.5f));
        }

        [UnityTest]
        public IEnumerator InSlowMotion_TheToneIsLower_AndWhereTimeStands_Silent()
        {
            InsectWings insect = Insect();
            InsectHum hum = AddHum(insect);
            Time.timeScale = 0.25f;
            yield return Frames(20);
            Assert.That(hum.Frequency, Is.EqualTo(0.25f * insect.Frequency).Within(1e-4).Percent);
            Assert.That(hum.Level, Is.GreaterThan(0f));
            Time.timeScale = 0f;
            yield return Frames(2);
            Assert.That(hum.Level, Is.Zero);
            Assert.That(Loudest(hum, 48000), Is.Zero);
        }

        [UnityTest]
        public IEnumerator WhatIsNotComputed_IsSilent()
        {
            InsectWings insect = Insect();
            InsectHum hum = AddHum(insect);
            yield return Frames(20);
            Assert.That(hum.Level, Is.GreaterThan(0f));
            insect.enabled = false;
            yield return Frames(2);
            Assert.That(hum.Level, Is.Zero);
            insect.enabled = true;
            yield return Frames(10);
            Assert.That(hum.Level, Is.GreaterThan(0f));
            hum.enabled = false;
            Assert.That((hum.Level, hum.Frequency), Is.EqualTo((0f, 0f)));
        }

        [UnityTest]
        public IEnumerator ASource_PlaysAClipOfOnes_AndGetsItsOwnBack()
        {
            InsectWings insect = Insect();
            AudioSource source = insect.gameObject.AddComponent<AudioSource>();
            AudioClip own = Keep(AudioClip.Create("own", 10, 1, 48000, false));
            source.clip = own;
            InsectHum hum = AddHum(insect);
            yield return null;
            float[] ones = new float[source.clip.samples];
            source.clip.GetData(ones, 0);
            Assert.That(ones, Is.Not.Empty.And.All.EqualTo(1f));
            Assert.That((source.clip.channels, source.clip.frequency), Is.EqualTo((1, AudioSettings.outputSampleRate)));
            Assert.That((source.loop, source.isPlaying), Is.EqualTo((true, true)));
            AudioClip made = source.clip;
            hum.enabled = false;
            Assert.That((source.clip, source.loop), Is.EqualTo((own, false)));
            yield return null;
            Assert.That(made == null, Is.True, "what was made is destroyed");
        }

        [UnityTest]
        public IEnumerator AnApproach_RaisesTheTone_AsDopplerSays_AndAJumpIsNoShriek()
        {
            InsectWings insect = Insect();
            InsectHum hum = AddHum(insect);
            insect.Motion.source = VelocitySource.Script;
            GameObject ear = Keep(new GameObject("ear", typeof(AudioListener)));
            Vector3 place = insect.transform.position + 100f * Vector3.forward;
            for (int frame = 0; frame < 20; frame++)
            {
                ear.transform.position = place;
                place += 20f * Time.unscaledDeltaTime * Vector3.back;
                yield return null;
            }

            Assert.That(hum.Frequency / insect.Frequency, Is.EqualTo(343f / (343f - 20f)).Within(1).Percent);
            hum.GetComponent<AudioSource>().dopplerLevel = 0f;
            ear.transform.position += 50f * Vector3.back;
            yield return null;
            Assert.That(hum.Frequency, Is.EqualTo(insect.Frequency).Within(1e-4).Percent);
            hum.GetComponent<AudioSource>().dopplerLevel = 1f;
            ear.transform.position += 50000f * Vector3.forward;
            yield return null;
            Assert.That(hum.Frequency / insect.Frequency, Is.InRange(0.8f, 1f));
        }

        [UnityTest]
        public IEnumerator AFrame_AndABufferOfSound_AllocateNothing([Values] bool hasEar, [Values(1, 2)] int channels)
        {
            InsectHum hum = AddHum(Insect());
            if (hasEar)
                Keep(new GameObject("ear", typeof(AudioListener)));
            float[] buffer = new float[1024 * channels];
            var endFrame = (Action)Delegate.CreateDelegate(typeof(Action), hum, "LateUpdate");
            for (int frame = 0; frame < 20; frame++)
            {
                hum.OnAudioFilterRead(buffer, channels);
                yield return null;
            }

            Assert.That(hum.Level, Is.GreaterThan(0f));
            Assert.That(() => { endFrame(); }, Is.Not.AllocatingGCMemory());
            Assert.That(() => { hum.OnAudioFilterRead(buffer, channels); }, Is.Not.AllocatingGCMemory());
        }

        [Test]
        public void Settings_AreKeptInTheirRanges()
        {
            InsectHum hum = Keep(new GameObject("hum")).AddComponent<InsectHum>();
            (hum.Volume, hum.FullPower) = (-1f, 0f);
            Assert.That((hum.Volume, hum.FullPower), Is.EqualTo((0f, 0.001f)));
            (hum.Volume, hum.FullPower) = (7f, 1e6f);
            Assert.That((hum.Volume, hum.FullPower), Is.EqualTo((1f, 1000f)));
            Assert.That(hum.Insect == null, Is.True);
        }

        private static InsectHum AddHum(InsectWings insect)
        {
            InsectHum hum = insect.gameObject.AddComponent<InsectHum>();
            (hum.Volume, hum.FullPower) = (0.8f, 200f);
            return hum;
        }

        private static float Loudest(InsectHum hum, int samples)
        {
            float loudest = 0f;
            foreach (float sample in Heard(hum, samples))
                loudest = Mathf.Max(loudest, Mathf.Abs(sample));
            return loudest;
        }

        // After as long a time, in which it glides to what is wanted now.
        private static float[] Heard(InsectHum hum, int samples)
        {
            float[] data = new float[samples];
            for (int round = 0; round < 2; round++)
            {
                Array.Fill(data, 1f);
                hum.OnAudioFilterRead(data, 1);
            }

            return data;
        }

        // Amplitude of one frequency, under a window of Hann.
        private static double Strength(float[] samples, double frequency, int rate)
        {
            double cosine = 0.0, sine = 0.0;
            for (int k = 0; k < samples.Length; k++)
            {
                double window = 1.0 - Math.Cos(2.0 * Math.PI * k / samples.Length), angle = 2.0 * Math.PI * frequency * k / rate;
                cosine += window * samples[k] * Math.Cos(angle);
                sine += window * samples[k] * Math.Sin(angle);
            }

            return 2.0 * Math.Sqrt(cosine * cosine + sine * sine) / samples.Length;
        }
    }
}
