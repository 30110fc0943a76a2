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

        [Test]
        public void ATable_OfTwoValues_OrWithAHole_IsRefused()
        {
            Assert.That(() => AngleSeries.FromTable(new[] { 1f, 2f }),
                Throws.ArgumentException.With.Message.Contains("at least three values; it has 2"));
            Assert.That(() => AngleSeries.FromTable(new[] { 1f, float.NaN, 2f }),
                Throws.ArgumentException.With.Message.Contains("Value 1 of the table is NaN"));
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
