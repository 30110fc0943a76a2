using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    public sealed class AngleSeriesTests
    {
        private readonly AngleSeries m_Series = new AngleSeries(10f, new Vector2(54f, 89f), new Vector2(2f, -88f), new Vector2(7f, 52f));

        [TestCase(8)]
        [TestCase(9)]
        [TestCase(50)]
        public void ATable_GivesTheSeriesItWasMadeFrom(int count)
        {
            var read = AngleSeries.FromTable(Enumerable.Range(0, count).Select(n => m_Series.At((float)n / count)).ToList());

            for (float turns = 0f; turns < 1f; turns += 0.03f)
                Assert.That(read.At(turns), Is.EqualTo(m_Series.At(turns)).Within(1e-3f), $"at {turns}");
        }

        // As many harmonics as a table of its length can tell; of an even one the last has only its cosine.
        [Test]
        public void ATable_IsMetAtAllItsPlaces()
        {
            var random = new System.Random(3);
            for (int count = 3; count <= 17; count++)
            {
                float[] table = Enumerable.Range(0, count).Select(_ => 90f * (float)random.NextDouble() - 40f).ToArray();
                var read = AngleSeries.FromTable(table);
                Assert.That(read.harmonics, Has.Length.EqualTo(count / 2));
                Assert.That(read.mean, Is.EqualTo(table.Average()).Within(1e-4f));
                for (int n = 0; n < count; n++)
                    Assert.That(read.At((float)n / count), Is.EqualTo(table[n]).Within(1e-3f), $"{n} of {count}");
            }

            Assert.That(AngleSeries.FromTable(new float[60]).harmonics, Has.Length.EqualTo(8));
        }

        [Test]
        public void ATable_OfTwoValues_OrWithAHole_IsRefused()
        {
            Assert.That(() => AngleSeries.FromTable(new[] { 1f, 2f }),
                Throws.ArgumentException.With.Message.Contains("at least three values; it has 2"));
            Assert.That(() => AngleSeries.FromTable(new[] { 1f, float.NaN, 2f }),
                Throws.ArgumentException.With.Message.Contains("Value 1 of the table is NaN"));
        }

        [Test]
        public void OutOfRange_EachNumberIsTheNearest_AndWhatIsNoNumberIsNought()
        {
            var wild = new AngleSeries(-400f, new Vector2(300f, 720f), new Vector2(float.NaN, float.PositiveInfinity));
            AngleSeries clamped = wild.Clamped(), many = new AngleSeries(1f, new Vector2[11]).Clamped();

            Assert.That((clamped.mean, clamped.harmonics[0], clamped.harmonics[1]),
                Is.EqualTo((-180f, new Vector2(180f, 720f), Vector2.zero)), "a phase may be any number");
            Assert.That(new AngleSeries(float.NegativeInfinity).Clamped().mean, Is.Zero);
            Assert.That(many.harmonics, Has.Length.EqualTo(WingKinematics.Harmonics));
            Assert.That(default(AngleSeries).Clamped().harmonics, Is.Null);
        }

        [TestCase(-1f, 0.1f)]
        [TestCase(float.NaN, 0.1f)]
        [TestCase(0.05f, 0.1f)]
        [TestCase(26f, 26f)]
        [TestCase(5000f, 1000f)]
        public void ThePrescribedFrequency_IsKeptInItsRange(float asked, float given)
        {
            var kinematics = new PresetKinematics { prescribed = true, waves = true, frequency = asked, sweep = m_Series };

            Assert.That((kinematics.Clamped().frequency, kinematics.Clamped().waves), Is.EqualTo((given, true)));
            Assert.That(kinematics.Clamped().sweep.harmonics, Is.EqualTo(m_Series.harmonics));
            kinematics.prescribed = false;
            Assert.That(kinematics.Clamped().frequency, Is.EqualTo(asked), "nobody reads it");
        }

        [Test]
        public void APreset_GivesItsMotionInRadians_AndOnlyWherePrescribed()
        {
            WingPreset preset = ScriptableObject.CreateInstance<WingPreset>();
            preset.Kinematics.frequency = 26.5f;
            preset.Kinematics.feather = m_Series;
            Assert.That(preset.ToParameters().kinematics.IsSet, Is.False);

            preset.Kinematics.prescribed = true;
            WingKinematics kinematics = preset.ToParameters().kinematics;
            Assert.That(kinematics.frequency, Is.EqualTo(26.5f));
            Assert.That(kinematics.Mean(DrivenAngle.Feather), Is.EqualTo(10 * Math.PI / 180).Within(1e-6));
            Assert.That(
                kinematics.Harmonic(DrivenAngle.Feather, 1).x, Is.EqualTo(54 * Math.PI / 180 * Math.Cos(89 * Math.PI / 180)).Within(1e-6));
            UnityEngine.Object.DestroyImmediate(preset);
        }
    }
}
