using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests
{
    /// <summary>Settings of an insect: what they change of the parameters, and their ranges.</summary>
    public sealed class SettingLaws
    {
        [Test]
        public void Steering_ChangesTheParameters_InTheirUnits()
        {
            var steering = new InsectSteering { frequencyScale = 1.5f, amplitudeScale = 0.5f, meanFlap = 10f, tilt = -20f };
            WingParameters before = WingParameters.Default, after = before;
            before.tilt = after.tilt = 0.1f;
            before.amplitudeScale = after.amplitudeScale = 0.8f;
            steering.Apply(ref after);
            Assert.That(after.maxFrequency, Is.EqualTo(1.5f * before.maxFrequency).Within(1e-5f));
            Assert.That(after.amplitudeScale, Is.EqualTo(0.4f).Within(1e-6f));
            Assert.That(after.meanFlap, Is.EqualTo(before.meanFlap + math.PI / 18f).Within(1e-6f));
            Assert.That(after.tilt, Is.EqualTo(0.1f - math.PI / 9f).Within(1e-6f));
        }

        [Test]
        public void Steering_IsMovedIntoItsRanges_AndNonsenseChangesNothing()
        {
            InsectSteering least = All(float.NegativeInfinity).Clamped(), most = All(float.PositiveInfinity).Clamped();
            Assert.That(least, Is.EqualTo(Steering(0.1f, 0f, -60f, -60f, 0f)));
            Assert.That(most, Is.EqualTo(Steering(4f, 2f, 60f, 60f, 1f)));
            Assert.That(All(float.NaN).Clamped(), Is.EqualTo(InsectSteering.Default));
            InsectSteering inside = Steering(0.5f, 1.5f, -30f, 20f, 0.25f);
            Assert.That(inside.Clamped(), Is.EqualTo(inside));
        }

        [Test]
        public void Steering_IsAnother_WhereAnyNumberIs([Values(0, 1, 2, 3, 4)] int field)
        {
            float[] numbers = { 0.5f, 1.5f, -30f, 20f, 0.25f };
            InsectSteering steering = Steering(numbers[0], numbers[1], numbers[2], numbers[3], numbers[4]);
            Assert.That(steering.Equals(Steering(numbers[0], numbers[1], numbers[2], numbers[3], numbers[4])));
            numbers[field] += 0.1f;
            Assert.That(steering.Equals(Steering(numbers[0], numbers[1], numbers[2], numbers[3], numbers[4])), Is.False);
        }

        [TestCase(0f, 0f, 0f, 0f, 1f, 10f)]
        [TestCase(1e-7f, 1e9f, 1e9f, 0f, 10000f, 180f)]
        [TestCase(1e-5f, 30f, 50f, 1e-5f, 30f, 50f)]
        [TestCase(2000f, 0.5f, 5f, 1000f, 1f, 10f)]
        [TestCase(-1f, 2f, 11f, 0f, 2f, 11f)]
        [TestCase(float.PositiveInfinity, float.NaN, float.NegativeInfinity, 0f, 25f, 100f)]
        [TestCase(float.NaN, float.PositiveInfinity, float.NaN, 0f, 25f, 100f)]
        public void Motion_IsMovedIntoItsRanges(
            float metres, float distance, float angle, float wantedMetres, float wantedDistance, float wantedAngle)
        {
            InsectMotion clamped = new InsectMotion
            {
                metresPerUnit = metres,
                teleportDistance = distance,
                teleportAngle = angle,
                source = VelocitySource.Script,
                onTeleport = TeleportResponse.Reset,
            }.Clamped();
            Assert.That(new[] { clamped.metresPerUnit, clamped.teleportDistance, clamped.teleportAngle },
                Is.EqualTo(new[] { wantedMetres, wantedDistance, wantedAngle }));
            Assert.That(clamped.source, Is.EqualTo(VelocitySource.Script));
            Assert.That(clamped.onTeleport, Is.EqualTo(TeleportResponse.Reset));
        }

        [TestCase(0, 64, 0, 64)]
        [TestCase(-5, 0, 12, 24)]
        [TestCase(1, 23, 12, 24)]
        [TestCase(13, 25, 13, 25)]
        [TestCase(481, 4097, 480, 4096)]
        public void Quality_IsMovedIntoItsRanges_AndNoughtLeavesThePresetsSubsteps(
            int substeps, int patches, int wantedSubsteps, int wantedPatches)
        {
            InsectQuality quality = InsectQuality.Default;
            quality.substepsPerBeat = substeps;
            quality.patches = patches;
            quality.screenHeights.restBelow = 3f;
            InsectQuality clamped = quality.Clamped();
            Assert.That((clamped.substepsPerBeat, clamped.patches), Is.EqualTo((wantedSubsteps, wantedPatches)));
            Assert.That(clamped.screenHeights.restBelow, Is.EqualTo(1f));
        }

        [TestCase(0.5f, 30f, 0.5f, 30f)]
        [TestCase(-1f, -181f, 0f, -180f)]
        [TestCase(2.1f, 181f, 2f, 180f)]
        public void SlidersOfAWing_StayInTheirRanges(float amplitude, float lead, float wantedAmplitude, float wantedLead)
        {
            var wing = new Wing { AmplitudeScale = amplitude, PhaseLead = lead };
            Assert.That((wing.AmplitudeScale, wing.PhaseLead), Is.EqualTo((wantedAmplitude, wantedLead)));
        }

        [Test]
        public void NumbersOfAPresetWithoutASlider_AreMovedIntoTheirRanges()
        {
            PresetStiffness stiffness = default;
            (stiffness.elasticity, stiffness.strongestWind) = (float.NegativeInfinity, -1f);
            PresetStiffness clamped = stiffness.Clamped();
            Assert.That((clamped.elasticity, clamped.strongestWind),
                Is.EqualTo((WingBounds.Elasticity.Min, WingBounds.StrongestWind.Default)));
            (stiffness.elasticity, stiffness.strongestWind) = (float.PositiveInfinity, 3f);
            clamped = stiffness.Clamped();
            Assert.That((clamped.elasticity, clamped.strongestWind), Is.EqualTo((WingBounds.Elasticity.Max, 3f)));

            foreach (bool most in new[] { false, true })
            {
                float value = most ? float.MaxValue : -1f;
                PresetSize size = new PresetSize
                {
                    wingLength = value,
                    wingMass = value,
                    insectMass = value,
                    fluidDensity = 7f,
                    gravityShare = value,
                }.Clamped();
                Assert.That(size.wingLength, Is.EqualTo(most ? WingBounds.WingLength.Max : WingBounds.WingLength.Min));
                Assert.That(size.wingMass, Is.EqualTo(most ? WingBounds.WingMass.Max : WingBounds.WingMass.Min));
                Assert.That(size.insectMass, Is.EqualTo(most ? WingBounds.InsectMass.Max : WingBounds.InsectMass.Min));
                Assert.That(size.gravityShare, Is.EqualTo(most ? WingBounds.GravityShare.Max : WingBounds.GravityShare.Min));
                Assert.That(size.fluidDensity, Is.EqualTo(7f));
            }
        }

        // Each number of a preset's beat, wave and stiffness is one of the model's, degrees as radians and ranges as half of them.
        [Test]
        public void NumbersOfAPreset_AreThoseOfTheModel_InItsUnits()
        {
            WingPreset preset = WingPresetOf();
            ref PresetBeat beat = ref preset.Beat;
            (beat.maxFrequency, beat.maxSpeed, beat.frequencyFloor, beat.amplitudeFloor) = (20f, 3f, 0.3f, 0.4f);
            (beat.flapRange, beat.sweepRange, beat.featherRange) = (100f, 40f, 30f);
            (beat.flapPhase, beat.sweepPhase, beat.featherPhase) = (10f, -20f, 30f);
            (beat.meanFlap, beat.tilt, beat.phaseLead) = (5f, -15f, 25f);
            ref PresetWave wave = ref preset.Wave;
            (wave.chordDelay, wave.spanDelay, wave.rootShare, wave.inertia) = (0.11f, 0.12f, 0.13f, 0.14f);
            ref PresetStiffness stiff = ref preset.Stiffness;
            (stiff.leadingEdge, stiff.trailingEdge, stiff.decay, stiff.damping) = (0.9f, 0.5f, 0.3f, 0.2f);
            (stiff.dorsalAsymmetry, stiff.inPlaneFactor, stiff.torsionFactor, stiff.jointLimit) = (1.1f, 3f, 0.7f, 20f);
            WingParameters made = WingParameters.Default;
            beat.WriteTo(ref made);
            wave.WriteTo(ref made);
            stiff.WriteTo(ref made);
            const float degree = math.PI / 180f;
            Assert.That(new[]
            {
                made.maxFrequency, made.maxSpeed, made.frequencyFloor, made.amplitudeFloor, made.amplitude.x, made.amplitude.y,
                made.amplitude.z, made.phase.x, made.phase.y, made.phase.z, made.meanFlap, made.tilt, made.phaseLead,
                made.chordDelay, made.spanDelay, made.rootShare, made.inertia, made.stiffnessRoot, made.stiffnessTip, made.stiffnessDecay,
                made.bendDamping, made.dorsalAsymmetry, made.inPlaneFactor, made.torsionFactor, made.jointLimit,
            }, Is.EqualTo(new[]
            {
                20f, 3f, 0.3f, 0.4f, 50f * degree, 20f * degree, 15f * degree, 10f * degree, -20f * degree, 30f * degree, 5f * degree,
                -15f * degree, 25f * degree, 0.11f, 0.12f, 0.13f, 0.14f, 0.9f, 0.5f, 0.3f, 0.2f, 1.1f, 3f, 0.7f, 20f * degree,
            }).Within(1e-6f));
            Object.DestroyImmediate(preset);
        }

        private static WingPreset WingPresetOf() => ScriptableObject.CreateInstance<WingPreset>();

        [Test]
        public void AVectorThatIsRefused_IsTheLastGoodOne_AndToldOnce()
        {
            GuardedVector guarded = default;
            Assert.That(guarded.Guard(new float3(1f, -2f, 3f), 3f, "a wind", "units", null), Is.EqualTo(new float3(1f, -2f, 3f)));
            LogAssert.Expect(LogType.Warning,
                "a wind of (0, -3.5, 0) units is refused, the last good one counts: it must be at most 3 units along each axis.");
            Assert.That(guarded.Guard(new float3(0f, -3.5f, 0f), 3f, "a wind", "units", null), Is.EqualTo(new float3(1f, -2f, 3f)));
            Assert.That(guarded.Guard(new float3(0f, 0f, float.NaN), 3f, "a wind", "units", null), Is.EqualTo(new float3(1f, -2f, 3f)));
            Assert.That(guarded.Guard(default, 3f, "a wind", "units", null), Is.EqualTo(default(float3)));
            Assert.That(guarded.Guard(5f, 3f, "a wind", "units", null), Is.EqualTo(default(float3)));
            LogAssert.NoUnexpectedReceived();

            GuardedVector any = default;
            var holder = new GameObject("holder");
            LogAssert.Expect(LogType.Warning,
                "'holder': a velocity of (NaN, 0, 0) m/s is refused, the last good one counts: it must be finite.");
            Assert.That(any.Guard(new float3(float.NaN, 0f, 0f), float.MaxValue, "a velocity", "m/s", holder), Is.EqualTo(default(float3)));
            Object.DestroyImmediate(holder);
        }

        private static InsectSteering All(float value) => Steering(value, value, value, value, value);

        private static InsectSteering Steering(float frequency, float amplitude, float flap, float tilt, float fold) =>
            new InsectSteering { frequencyScale = frequency, amplitudeScale = amplitude, meanFlap = flap, tilt = tilt, fold = fold };
    }
}
