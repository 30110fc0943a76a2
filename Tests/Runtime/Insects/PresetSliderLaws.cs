using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>Sliders of a preset: the model takes every number up to both ends of its slider, and none beyond them.</summary>
    public sealed class PresetSliderLaws
    {
        // The model wraps phases: it takes more than their sliders have.
        private static readonly string[] s_Wrapped = { "flapPhase", "sweepPhase", "featherPhase", "phaseLead" };

        private WingPreset m_Preset;

        private static IEnumerable<string> Sliders =>
            new[] { typeof(PresetBeat), typeof(PresetWave), typeof(PresetStiffness) }.SelectMany(group => group.GetFields())
            .Where(field => Ends(field).y > 0f).Select(field => field.Name).Except(s_Wrapped);

        [SetUp]
        public void MakeAPreset() => m_Preset = ScriptableObject.CreateInstance<WingPreset>();

        [TearDown]
        public void EndIt() => Object.DestroyImmediate(m_Preset);

        [TestCaseSource(nameof(Sliders))]
        public void TheModel_TakesWhatItsSliderHas_AndNoMore(string name)
        {
            float2 ends = Ends(Field(name));
            float span = ends.y - ends.x;
            for (int end = 0; end < 2; end++)
            {
                float at = ends[end], outwards = end == 0 ? -1f : 1f;
                float some = outwards * (at == 0f ? 0.02f * span : 0.05f * math.abs(at));
                float[] atEnd = Numbers(name, at), before = Numbers(name, at - some);
                Assert.That(before, Is.Not.EqualTo(atEnd), $"{name} is limited before {at}");
                Assert.That(Numbers(name, at + some), Is.EqualTo(atEnd), $"{name} is not limited at {at}");
                Assert.That(atEnd.Zip(before, (a, b) => a != b).Count(isOther => isOther), Is.EqualTo(1), $"{name} is one number");
            }
        }

        [TestCase(-361f, -360f)]
        [TestCase(-350f, -350f)]
        [TestCase(350f, 350f)]
        [TestCase(361f, 360f)]
        public void PhasesAndLeads_AreTakenUpToAWholeBeat(float degrees, float wanted)
        {
            WingParameters parameters = WingParameters.Default;
            parameters.phase = math.radians(degrees);
            parameters.phaseLead = math.radians(degrees);
            parameters.amplitudeScale = degrees / 180f;
            WingParameters clamped = parameters.Clamped();
            float4 apart = math.abs(math.degrees(new float4(clamped.phase, clamped.phaseLead)) - wanted);
            Assert.That(math.cmax(apart), Is.LessThan(1e-3f));
            Assert.That(clamped.amplitudeScale, Is.EqualTo(math.clamp(degrees / 180f, 0f, 2f)).Within(1e-6f));
        }

        [TestCase(11, 12)]
        [TestCase(12, 12)]
        [TestCase(480, 480)]
        [TestCase(481, 480)]
        public void SubstepsOfABeat_AreThoseOfTheSlider(int substeps, int wanted)
        {
            m_Preset.SubstepsPerBeat = substeps;
            Assert.That(m_Preset.ToParameters().substepsPerBeat, Is.EqualTo(wanted));
        }

        // What is computed of several numbers is left out: it has no slider.
        private float[] Numbers(string name, float value)
        {
            FieldInfo field = Field(name);
            object beat = PresetBeat.Default, wave = PresetWave.Default, stiffness = PresetStiffness.Default;
            field.SetValue(field.DeclaringType == typeof(PresetBeat) ? beat : field.DeclaringType == typeof(PresetWave) ? wave : stiffness,
                value);
            m_Preset.Beat = (PresetBeat)beat;
            m_Preset.Wave = (PresetWave)wave;
            m_Preset.Stiffness = (PresetStiffness)stiffness;
            WingParameters made = m_Preset.ToParameters();
            made.referenceFrequency = WingParameters.Default.referenceFrequency;
            return WingParameterRange.All.Select(range => range.Of(ref made)).ToArray();
        }

        private static FieldInfo Field(string name) =>
            typeof(PresetBeat).GetField(name) ?? typeof(PresetWave).GetField(name) ?? typeof(PresetStiffness).GetField(name);

        private static float2 Ends(FieldInfo field)
        {
            UnityEngine.RangeAttribute slider = field.GetCustomAttribute<UnityEngine.RangeAttribute>();
            UnitAttribute bounds = field.GetCustomAttribute<UnitAttribute>();
            return slider != null ? new float2(slider.min, slider.max) : new float2(bounds.Min, bounds.Max);
        }
    }
}
