using System;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>Groups of a preset without sliders: prescribed angles, posture at rest, and numbers computed of several.</summary>
    public sealed class PresetGroupLaws
    {
        private WingPreset m_Preset;

        [SetUp]
        public void MakeAPreset() => m_Preset = ScriptableObject.CreateInstance<WingPreset>();

        [TearDown]
        public void EndIt() => UnityEngine.Object.DestroyImmediate(m_Preset);

        [Test]
        public void EachPrescribedAngle_IsTheModels_WithAllItsHarmonics([Values(0, 1, 2, 3)] int which, [Values(0, 1, 8)] int count)
        {
            DrivenAngle[] angles = { DrivenAngle.Flap, DrivenAngle.Sweep, DrivenAngle.Feather, DrivenAngle.Tilt };
            var harmonics = new Vector2[count];
            for (int k = 0; k < count; k++)
                harmonics[k] = new Vector2(3f + k, 10f * k - 40f);
            var series = new AngleSeries(12f, harmonics);
            var given = new PresetKinematics { prescribed = true, waves = which % 2 == 0, frequency = 20f };
            Angle(ref given, which) = series;

            WingKinematics made = given.ToKinematics();

            Assert.That((made.frequency, made.waves), Is.EqualTo((20f, which % 2 == 0)));
            for (int angle = 0; angle < 4; angle++)
            {
                bool isIt = angle == which;
                Assert.That(math.degrees(made.Mean(angles[angle])), Is.EqualTo(isIt ? 12f : 0f).Within(1e-4f));
                for (int k = 1; k <= WingKinematics.Harmonics; k++)
                {
                    math.sincos(math.radians(10f * k - 50f), out float sine, out float cosine);
                    float size = isIt && k <= count ? 2f + k : 0f;
                    float2 found = math.degrees(made.Harmonic(angles[angle], k));
                    Assert.That(math.distance(found, size * new float2(cosine, -sine)), Is.LessThan(1e-4f));
                }
            }

            Angle(ref given, which) = new AngleSeries(300f);
            PresetKinematics clamped = given.Clamped();
            for (int angle = 0; angle < 4; angle++)
                Assert.That(Angle(ref clamped, angle).mean, Is.EqualTo(angle == which ? 180f : 0f));
        }

        [Test]
        public void AnotherPosture_IsAnother_WhicheverNumberDiffers()
        {
            PresetRest rest = PresetRest.Default, same = PresetRest.Default;
            Assert.That(rest.Equals(same) && rest.Equals((object)same) && rest.GetHashCode() == same.GetHashCode());
            Assert.That(rest.Equals(null) || rest.Equals("rest"), Is.False);
            var others = new PresetRest[7];
            for (int k = 0; k < others.Length; k++)
                others[k] = rest;
            others[0].flap += 1f;
            others[1].sweep += 1f;
            others[2].feather += 1f;
            others[3].tilt += 1f;
            for (int axis = 0; axis < 3; axis++)
                others[4 + axis].feet[axis] += 1e-3f;
            foreach (PresetRest other in others)
                Assert.That(rest.Equals(other) || other.Equals((object)rest), Is.False);
        }

        // f √(1 + (u / v)²) with v the tip's speed, but no less than a tenth of u.
        [TestCase(0f)]
        [TestCase(1f)]
        [TestCase(90f)]
        public void TheReferenceFrequency_CountsTheTipAtATenthOfTheSpeedAtLeast(float range)
        {
            m_Preset.Beat.flapRange = range;
            (m_Preset.Beat.maxFrequency, m_Preset.Beat.maxSpeed, m_Preset.Size.wingLength) = (20f, 3f, 0.05f);
            double tip = 2.0 * Math.PI * 20.0 * (0.5 * range * Math.PI / 180.0) * 0.05, ratio = 3.0 / Math.Max(tip, 0.3);
            Assert.That(m_Preset.ReferenceFrequency, Is.EqualTo(20.0 * Math.Sqrt(1.0 + ratio * ratio)).Within(1e-3).Percent);
        }

        [Test]
        public void DensityAndStiffness_AreOverTheWingsOwn()
        {
            var size = new PresetSize { wingLength = 0.2f, wingMass = 0.004f, fluidDensity = 3f };
            Assert.That(size.RelativeDensity, Is.EqualTo(6f).Within(1e-5f), "3 · 0.008 / 0.004");
            Assert.That(size.StiffnessUnit, Is.EqualTo(31250f).Within(0.1f), "1 / (0.004 · 0.008)");
            m_Preset.Size = size;
            WingParameters made = m_Preset.ToParameters();
            Assert.That((made.airDensity, made.stiffnessUnit), Is.EqualTo((size.RelativeDensity, size.StiffnessUnit)));
            Assert.That((m_Preset.WingLength, made.amplitudeScale), Is.EqualTo((0.2f, 1f)));
        }

        private static ref AngleSeries Angle(ref PresetKinematics kinematics, int which)
        {
            if (which == 0)
                return ref kinematics.flap;
            if (which == 1)
                return ref kinematics.sweep;
            if (which == 2)
                return ref kinematics.feather;
            return ref kinematics.tilt;
        }
    }
}
