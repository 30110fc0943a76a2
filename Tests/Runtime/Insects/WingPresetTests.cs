using System;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    public sealed class WingPresetTests
    {
        private WingPreset m_Preset;

        [SetUp]
        public void CreatePreset() => m_Preset = ScriptableObject.CreateInstance<WingPreset>();

        [TearDown]
        public void DestroySpecies() => UnityEngine.Object.DestroyImmediate(m_Preset);

        [Test]
        public void ANewSpecies_IsAMonarch_InTheUnitsOfTheModel()
        {
            WingParameters parameters = m_Preset.ToParameters();

            Assert.That(parameters.maxFrequency, Is.EqualTo(11f));
            Assert.That(parameters.maxSpeed, Is.EqualTo(2f));
            Assert.That(parameters.amplitude.x, Is.EqualTo(Math.PI / 3).Within(1e-6), "Table 1's 120° from end to end is 60° to each side");
            Assert.That(parameters.amplitude.y, Is.EqualTo(Math.PI / 10).Within(1e-6), "sweep");
            Assert.That(parameters.amplitude.z, Is.EqualTo(Math.PI / 15).Within(1e-6), "feather");
            Assert.That(parameters.phase.x, Is.EqualTo(0f));
            Assert.That(parameters.phase.y, Is.EqualTo(-Math.PI / 2).Within(1e-6));
            Assert.That(parameters.phase.z, Is.EqualTo(-Math.PI / 2).Within(1e-6));
            Assert.That(parameters.meanFlap, Is.EqualTo(Math.PI / 18).Within(1e-6));
            Assert.That(parameters.jointLimit, Is.EqualTo(Math.PI / 6).Within(1e-6));
            Assert.That(parameters.airDensity, Is.EqualTo(11.1f).Within(0.05f), "1.225 kg/m³ (0.061 m)³ / 25.1 mg");
            Assert.That(parameters.options, Is.EqualTo(ModelOptions.Physical));
        }

        [Test]
        public void ANewSpecies_GivesTheDefaultsOfTheModel()
        {
            WingParameters made = m_Preset.ToParameters();
            WingParameters expected = WingParameters.Default;

            foreach (WingParameterRange range in WingParameterRange.All)
            {
                Assert.That(range.Of(ref made), Is.EqualTo(range.Of(ref expected)).Within(0.3).Percent, range.Name);
            }

            Assert.That(made.substepsPerBeat, Is.EqualTo(expected.substepsPerBeat));
        }

        [Test]
        public void ReferenceFrequency_GrowsWithTheSpeedOfFlight()
        {
            m_Preset.Beat.maxSpeed = 0.01f;
            Assert.That(m_Preset.ReferenceFrequency, Is.EqualTo(11f).Within(1e-3f));

            m_Preset.Beat.maxSpeed = 2f;
            double tipSpeed = 2 * Math.PI * 11 * (Math.PI / 3) * 0.061;
            Assert.That(m_Preset.ReferenceFrequency, Is.EqualTo(11 * Math.Sqrt(1 + 4 / (tipSpeed * tipSpeed))).Within(1e-4));
        }

        [Test]
        public void AWingThatDoesNotFlap_HasAFiniteStiffness()
        {
            m_Preset.Beat.flapRange = 0f;

            Assert.That(m_Preset.ReferenceFrequency, Is.GreaterThan(11f).And.LessThan(120f));
        }

        [Test]
        public void PaperPreset_IsThePrint_AndKeepsTheInsect()
        {
            m_Preset.Stiffness.elasticity = 0.5f;

            m_Preset.ApplyReading(ModelReading.Paper);

            WingParameters parameters = m_Preset.ToParameters();
            Assert.That(parameters.chordDelay, Is.EqualTo(1f));
            Assert.That(parameters.spanDelay, Is.EqualTo(0f));
            Assert.That(parameters.inertia, Is.EqualTo(2f));
            Assert.That(parameters.frequencyFloor, Is.EqualTo(0f));
            Assert.That(parameters.amplitudeFloor, Is.EqualTo(0f));
            Assert.That(parameters.phase.x, Is.EqualTo(0f));
            Assert.That(parameters.phase.y, Is.EqualTo(0f));
            Assert.That(parameters.phase.z, Is.EqualTo(0f));
            Assert.That(parameters.options, Is.EqualTo(ModelOptions.Paper));
            Assert.That(parameters.amplitude.x, Is.EqualTo(Math.PI / 3).Within(1e-6));
            Assert.That(parameters.elasticity, Is.EqualTo(0.5f));
        }

        [Test]
        public void PhysicalPreset_UndoesThePaperPreset()
        {
            WingParameters before = m_Preset.ToParameters();

            m_Preset.ApplyReading(ModelReading.Paper);
            m_Preset.ApplyReading(ModelReading.Physical);

            Assert.That(m_Preset.ToParameters(), Is.EqualTo(before));
        }

        [Test]
        public void NonsenseInTheAsset_StillGivesParametersInRange()
        {
            m_Preset.Size.wingMass = 0f;
            m_Preset.Size.wingLength = float.NaN;
            m_Preset.Beat.maxFrequency = -3f;
            m_Preset.Stiffness.elasticity = float.PositiveInfinity;
            m_Preset.SubstepsPerBeat = -5;

            Assert.That(m_Preset.ToParameters().FindProblem(), Is.Null);
        }
    }
}
