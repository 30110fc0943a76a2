using System.Collections;
using Alate.Sound;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>Loudness over beats, insects and listeners that come and go, and devices that change.</summary>
    public sealed class HumLaws : PlayFixture
    {
        // The manual: the square of the level follows the mean power to the air, over about two beats.
        [UnityTest]
        public IEnumerator TheSquareOfTheLevel_IsTheMeanPower_OverTwoBeats()
        {
            InsectWings insect = Insect();
            InsectHum hum = AddHum(insect.gameObject);
            yield return Frames(30);
            double mean = Squared(hum);
            for (int frame = 0; frame < 60; frame++)
            {
                double kept = System.Math.Exp(-Time.deltaTime * insect.Frequency / 2.0);
                mean = kept * mean + (1.0 - kept) * insect.AirPower;
                yield return null;
                Assert.That(Squared(hum), Is.EqualTo(mean).Within(0.5).Percent);
            }

            // Its numbers are such that the level stays below the volume, above which it would tell nothing.
            Assert.That(mean, Is.GreaterThan(0.0).And.LessThan(0.001 * hum.FullPower));
        }

        [UnityTest]
        public IEnumerator TheFirstFrame_IsAsLoudAsThePowerIsThen()
        {
            InsectWings insect = Insect();
            yield return Frames(33);
            InsectHum hum = AddHum(insect.gameObject);
            float power = insect.AirPower;
            yield return Frames(1);
            Assert.That(Squared(hum), Is.EqualTo(Mathf.Max(0f, power)).Within(0.1).Percent);
        }

        [UnityTest]
        public IEnumerator OnAChildOfAnInsect_ItIsHeard_AndWithoutOneNothing()
        {
            InsectWings insect = Insect();
            var mouth = new GameObject("mouth");
            mouth.transform.SetParent(insect.transform, false);
            InsectHum hum = AddHum(mouth);
            Assert.That(hum.Insect, Is.SameAs(insect));
            yield return Frames(10);
            Assert.That(hum.Level, Is.GreaterThan(0f));
            hum.Insect = null;
            yield return Frames(1);
            Assert.That(hum.Level, Is.Zero);
        }

        [UnityTest]
        public IEnumerator AJumpWhileItIsOff_IsNoApproach()
        {
            InsectWings insect = Insect();
            InsectHum hum = AddHum(insect.gameObject);
            GameObject ear = Keep(new GameObject("ear", typeof(AudioListener)));
            ear.transform.position = new Vector3(0f, 0f, 40f);
            yield return Frames(30);
            Assert.That(hum.Frequency, Is.EqualTo(insect.Frequency).Within(1e-4).Percent, "at rest");
            hum.enabled = false;
            ear.transform.position = new Vector3(0f, 0f, 38f);
            hum.enabled = true;
            yield return Frames(1);
            Assert.That(hum.Frequency, Is.EqualTo(insect.Frequency).Within(1e-4).Percent);
        }

        // A listener that goes away is heard lower; a fifth of the speed of sound is the most, either way.
        [UnityTest]
        public IEnumerator Receding_LowersTheTone_ByAFifthOfTheSpeedOfSoundAtMost()
        {
            InsectWings insect = Insect();
            InsectHum hum = AddHum(insect.gameObject);
            GameObject ear = Keep(new GameObject("ear", typeof(AudioListener)));
            ear.transform.position = 10000f * Vector3.right;
            yield return Frames(30);
            foreach ((float speed, float share) in new[] { (34.3f, 1f / 1.1f), (500f, 1f / 1.2f), (-500f, 1f / 0.8f), (-34.3f, 1f / 0.9f) })
            {
                ear.transform.position += speed * Time.unscaledDeltaTime * Vector3.right;
                yield return Frames(1);
                Assert.That(hum.Frequency / insect.Frequency, Is.EqualTo(share).Within(0.3).Percent, $"{speed} m/s");
            }
        }

        [UnityTest]
        public IEnumerator AChangeOfTheDevice_StartsTheOnesAnew_WhileItIsOnAlone()
        {
            InsectHum hum = AddHum(Insect().gameObject);
            AudioSource source = hum.GetComponent<AudioSource>();
            yield return Frames(1);
            AudioClip before = source.clip;
            int rate = AudioSettings.outputSampleRate;
            AudioSettings.outputSampleRate = rate == 44100 ? 48000 : 44100;
            yield return Frames(1);
            Assert.That(source.clip.frequency, Is.EqualTo(AudioSettings.outputSampleRate));
            Assert.That(source.clip != before && source.isPlaying, Is.True);
            Assert.That(before == null, Is.True, "the old ones are destroyed");
            hum.enabled = false;
            AudioSettings.outputSampleRate = rate;
            yield return Frames(1);
            Assert.That((source.clip == null, source.isPlaying), Is.EqualTo((true, false)));
        }

        [Test]
        public void ANewHum_HasTheNumbersOfTheManual_WhichStandForWhatIsNone()
        {
            InsectHum hum = Keep(new GameObject("hum")).AddComponent<InsectHum>();
            Assert.That((hum.Volume, hum.FullPower), Is.EqualTo((0.3f, 20f)));
            (hum.Volume, hum.FullPower) = (0.7f, 900f);
            Assert.That((hum.Volume, hum.FullPower), Is.EqualTo((0.7f, 900f)));
            (hum.Volume, hum.FullPower) = (float.NaN, float.NaN);
            Assert.That((hum.Volume, hum.FullPower), Is.EqualTo((0.3f, 20f)));
        }

        private static double Squared(InsectHum hum) => (double)hum.Level * hum.Level / (hum.Volume * hum.Volume) * 0.001 * hum.FullPower;

        private static InsectHum AddHum(GameObject owner)
        {
            InsectHum hum = owner.AddComponent<InsectHum>();
            (hum.Volume, hum.FullPower) = (0.8f, 1000f);
            return hum;
        }
    }
}
