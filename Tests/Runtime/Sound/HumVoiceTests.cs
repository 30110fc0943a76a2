using System;
using System.Linq;
using Alate.Sound;
using NUnit.Framework;

namespace Alate.Tests.Sound
{
    /// <summary>Samples of a tone, against the strength of each frequency in them.</summary>
    public sealed class HumVoiceTests
    {
        private static readonly int[] s_Rates = { 8000, 22050, 44100, 48000, 96000 };

        [Test]
        public void TheSpectrum_HasItsPeakAtTheBeat_ToOnePerCent([Values(8000, 48000)] int rate, [Values(11.3f, 28f, 230f)] float beat)
        {
            float[] samples = Play(Tone(beat, 0.3f, 1f, 0.6f, 0.2f), rate, 0.8);

            double strongest = 0.0, at = 0.0;
            foreach (double share in Enumerable.Range(-20, 41).Select(k => 1.0 + 0.005 * k).Concat(new[] { 0.5, 1.5, 2.0, 2.5, 3.0 }))
            {
                double strength = Strength(samples, share * beat, rate);
                (strongest, at) = strength > strongest ? (strength, share * beat) : (strongest, at);
            }

            Assert.That(at, Is.EqualTo(beat).Within(1).Percent);
        }

        [Test]
        public void Overtones_HaveTheirAmplitudes_AndTheSoundItsLevel([ValueSource(nameof(s_Rates))] int rate)
        {
            float[] amplitudes = { 1f, 0f, 0.8f, 0.5f, 0f, 0.3f };
            float[] samples = Play(Tone(100f, 0.25f, amplitudes), rate, 1.0);
            float whole = (float)Math.Sqrt(0.5 * amplitudes.Sum(a => a * a));

            for (int k = 0; k < amplitudes.Length; k++)
                Assert.That(Strength(samples, 100.0 * (k + 1), rate), Is.EqualTo(0.25 * amplitudes[k] / whole).Within(2e-3), $"{k + 1}");
            Assert.That(Level(samples), Is.EqualTo(0.25).Within(1).Percent);
        }

        [Test]
        public void OvertonesBeyondTheRate_AreSilent_AndNotHeardBelow()
        {
            // 3 × 1300 = 3900 of 8000 are left out; 5 × 1300 would be heard at 1500.
            float[] samples = Play(Tone(1300f, 0.3f, 1f, 0f, 1f, 0f, 1f), 8000, 1.0);
            foreach (double frequency in new[] { 3900.0, 1500.0, 2600.0 })
                Assert.That(Strength(samples, frequency, 8000), Is.LessThan(2e-3));
            Assert.That(Strength(samples, 1300.0, 8000), Is.GreaterThan(0.1));
        }

        [Test]
        public void Changes_AreHeardWithoutAClick([ValueSource(nameof(s_Rates))] int rate)
        {
            var voice = new HumVoice();
            Func<HumVoice, float[]> next = v => Buffer(v, 0.1, rate, 1);
            float[] samples =
                Say(voice, Tone(40f, 0.5f, 1f, 0.5f), next)
                .Concat(Say(voice, Tone(200f, 0.1f, 0.2f, 1f, 0f, 0.6f), next))
                .Concat(Say(voice, Tone(200f, 0f, 1f), next))
                .Concat(Say(voice, Tone(60f, 0.9f, 1f), next)).ToArray();

            // The steepest that a tone between them can be, and the start of a level of 0.9 from 0.
            double steepest = 0.5 * 1.5 * 2.0 * Math.PI * 400.0 / rate + 0.9 * 1.5 / (HumVoice.GlideSeconds * rate);
            for (int k = 1; k < samples.Length; k++)
                Assert.That(Math.Abs(samples[k] - samples[k - 1]), Is.LessThan(2.0 * steepest), $"sample {k}");
        }

        [Test]
        public void AToneThatIsNoLonger_FadesToNothing_AndComesBack([ValueSource(nameof(s_Rates))] int rate)
        {
            var voice = new HumVoice();
            Say(voice, Tone(50f, 0.5f, 1f), v => Buffer(v, 0.2, rate, 1));
            float[] fading = Say(voice, Tone(50f, 0f, 1f), v => Buffer(v, 0.3, rate, 1));
            Assert.That(fading.Skip(fading.Length * 5 / 6), Is.All.Zero);
            Assert.That(Level(Say(voice, Tone(50f, 0.5f, 1f), v => Buffer(v, 0.5, rate, 1)).Skip(rate / 10).ToArray()),
                Is.EqualTo(0.5).Within(2).Percent);
        }

        [Test]
        public void AToneThatChanges_NearsTheNewOneExponentially_FrequencyLevelAndOvertones([ValueSource(nameof(s_Rates))] int rate)
        {
            const double before = 100.0, after = 160.0;
            var voice = new HumVoice();
            int played = Say(voice, Tone((float)before, 0.3f, 1f), v => Buffer(v, 0.3, rate, 1)).Length;
            float[] samples = Say(voice, Tone((float)after, 0.2f, 0f, 1f), v => Buffer(v, 0.1, rate, 1));

            // What is left of the old tone is exp(−t / glide); turns are the integral of the frequency.
            for (int k = 0; k < samples.Length; k++)
            {
                double seconds = (double)k / rate, left = Math.Exp(-seconds / HumVoice.GlideSeconds);
                double turns = before * played / rate + after * seconds + (before - after) * HumVoice.GlideSeconds * (1.0 - left);
                double wanted = (0.2 + 0.1 * left) * Math.Sqrt(2.0)
                    * (left * Math.Sin(2.0 * Math.PI * turns) + (1.0 - left) * Math.Sin(4.0 * Math.PI * turns));
                Assert.That(samples[k], Is.EqualTo(wanted).Within(2e-3 + 100.0 / rate), $"after {seconds:0.0000} s");
            }
        }

        [Test]
        public void AToneThatComesOutOfSilence_SoundsAsFromAFreshVoice([ValueSource(nameof(s_Rates))] int rate)
        {
            HumTone wanted = Tone(73f, 0.4f, 0.3f, 1f);
            var used = new HumVoice();
            Say(used, Tone(51f, 0.5f, 1f, 0f, 0.5f), v => Buffer(v, 0.2, rate, 1));
            Say(used, Tone(51f, 0f, 1f), v => Buffer(v, 0.31, rate, 1));

            Assert.That(Say(used, wanted, v => Buffer(v, 0.05, rate, 1)), Is.EqualTo(Buffer(Spoken(wanted), 0.05, rate, 1)));
        }

        [Test]
        public void TheTone_MultipliesWhatIsThere_OnEachChannel()
        {
            HumVoice left = Spoken(Tone(80f, 0.4f, 1f)), both = Spoken(Tone(80f, 0.4f, 1f));
            float[] one = Buffer(left, 0.05, 48000, 1);
            float[] two = Enumerable.Range(0, 2 * one.Length).Select(k => k % 2 == 0 ? 0.5f : -0.25f).ToArray();
            both.Multiply(two, 2, 48000);

            for (int k = 0; k < one.Length; k++)
                Assert.That((two[2 * k], two[2 * k + 1]), Is.EqualTo((0.5f * one[k], -0.25f * one[k])));
        }

        [Test]
        public void ALevelBeyondWhatASampleHolds_IsCutOff()
        {
            float[] samples = Play(Tone(100f, 1f, 1f, 1f, 1f, 1f), 48000, 0.5);
            Assert.That(samples.Max(Math.Abs), Is.EqualTo(1f));
        }

        private static float[] Play(HumTone tone, int rate, double seconds)
        {
            HumVoice voice = Spoken(tone);
            Buffer(voice, 0.3, rate, 1);
            return Buffer(voice, seconds, rate, 1);
        }

        private static HumVoice Spoken(HumTone tone)
        {
            var voice = new HumVoice();
            Say(voice, tone, _ => null);
            return voice;
        }

        private static float[] Say(HumVoice voice, HumTone tone, Func<HumVoice, float[]> then)
        {
            (voice.Wanted.frequency, voice.Wanted.level) = (tone.frequency, tone.level);
            tone.amplitudes.CopyTo(voice.Wanted.amplitudes, 0);
            voice.Say();
            return then(voice);
        }

        private static float[] Buffer(HumVoice voice, double seconds, int rate, int channels)
        {
            float[] data = Enumerable.Repeat(1f, (int)(seconds * rate) * channels).ToArray();
            voice.Multiply(data, channels, rate);
            return data;
        }

        private static HumTone Tone(float frequency, float level, params float[] amplitudes)
        {
            var tone = new HumTone { frequency = frequency, level = level };
            double whole = Math.Sqrt(0.5 * amplitudes.Sum(a => a * a));
            for (int k = 0; k < amplitudes.Length; k++)
                tone.amplitudes[k] = (float)(amplitudes[k] / whole);
            return tone;
        }

        private static double Level(float[] samples) => Math.Sqrt(samples.Average(sample => (double)sample * sample));

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
