using System;
using System.Collections.Generic;
using System.Reflection;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>Numbers that wings are told: each in its place, named where it is none, and derived ones by their laws.</summary>
    public sealed unsafe class StateLaws
    {
        private static IEnumerable<FieldInfo> SurroundingFields => typeof(WingSurroundings).GetFields();

        private static IEnumerable<FieldInfo> OptionFields => typeof(ModelOptions).GetFields();

        [Test]
        public void SurroundingsThatAreNoNumber_AreNamed([ValueSource(nameof(SurroundingFields))] FieldInfo field)
        {
            foreach (float bad in new[] { float.NaN, float.PositiveInfinity, float.NegativeInfinity })
            {
                object air = default(WingSurroundings);
                Assert.That(((WingSurroundings)air).FindProblem(), Is.Null);
                field.SetValue(air, field.FieldType == typeof(float3) ? (object)new float3(1f, 2f, bad) : bad);

                Assert.That(((WingSurroundings)air).IsFinite, Is.False);
                Assert.That(
                    ((WingSurroundings)air).FindProblem(), Does.StartWith($"{field.Name} is ").And.EndsWith("; it must be finite."));
            }
        }

        [Test]
        public void EveryOption_CountsForEquality_AndOneThatIsNoneIsNamedAndPutBack([ValueSource(nameof(OptionFields))] FieldInfo field)
        {
            object options = ModelOptions.Physical, other = ModelOptions.Physical;
            bool isFlag = field.FieldType == typeof(bool);
            field.SetValue(other, isFlag ? (object)!(bool)field.GetValue(options) : Enum.ToObject(field.FieldType, 1));
            Assert.That(options.Equals(other), Is.False);
            Assert.That(((ModelOptions)other).FindProblem(), Is.Null);
            Assert.That(((ModelOptions)other).Defined(), Is.EqualTo(other));
            if (isFlag)
                return;
            field.SetValue(other, Enum.ToObject(field.FieldType, 77));
            Assert.That(((ModelOptions)other).FindProblem(), Does.StartWith($"options.{field.Name} is 77; it must be one of "));
            field.SetValue(options, Enum.ToObject(field.FieldType, 0));
            Assert.That(((ModelOptions)other).Defined(), Is.EqualTo(options));
        }

        [Test]
        public void ADrive_IsValid_UpToItsBounds()
        {
            var drive = new WingDrive { frequency = 10f, amplitude = 1f };
            Assert.That(drive.IsValid, Is.True);
            foreach ((float value, bool isValid) in new[] { (0.1f, true), (0.09f, false), (1e3f, true), (1e4f, false), (float.NaN, false) })
            {
                WingDrive changed = drive;
                changed.frequency = value;
                Assert.That(changed.IsValid, Is.EqualTo(isValid), $"{value} Hz");
            }

            foreach ((float value, bool isValid) in new[] { (0f, true), (-0.001f, false), (2f, true), (2.001f, false), (float.NaN, false) })
            {
                WingDrive changed = drive;
                changed.amplitude = value;
                Assert.That(changed.IsValid, Is.EqualTo(isValid), $"amplitude {value}");
            }

            foreach (string name in new[] { "meanFlap", "meanSweep", "meanFeather", "tilt" })
            {
                foreach ((float value, bool isValid) in new[] { (math.PI, true), (-math.PI, true), (3.15f, false), (-3.15f, false) })
                {
                    object changed = drive;
                    typeof(WingDrive).GetField(name).SetValue(changed, value);
                    Assert.That(((WingDrive)changed).IsValid, Is.EqualTo(isValid), $"{name} {value}");
                }
            }
        }

        [Test]
        public void ACommand_IsReadAsItWasWritten_InItsLane()
        {
            LaneDrive lanes = default;
            var drive = new WingDrive { frequency = 1f, amplitude = 2f, meanFlap = 3f, meanSweep = 4f, meanFeather = 5f, tilt = 6f };
            lanes.Set(2, drive, true);
            Assert.That(lanes.Of(2), Is.EqualTo(drive));
            Assert.That(lanes.Of(1), Is.EqualTo(default(WingDrive)));
            Assert.That(lanes.commanded, Is.EqualTo(new float4(0f, 0f, 1f, 0f)));
            lanes.Set(2, drive, false);
            Assert.That(lanes.commanded, Is.EqualTo(float4.zero));
        }

        [TestCase(1f, 2f, 1.5f, 1.5f)]
        [TestCase(1f, 2f, 0.9f, 1f)]
        [TestCase(1f, 2f, 2.1f, 2f)]
        [TestCase(1f, 2f, float.NaN, 7f)]
        [TestCase(1f, 2f, float.NegativeInfinity, 1f)]
        public void ANumber_IsClamped_AndWhatIsNoneIsReplaced(float least, float most, float value, float clamped) =>
            Assert.That(NumberRange.Clamp(value, least, most, 7f), Is.EqualTo(clamped));

        [Test]
        public void OuterBounds_HoldEachComponent()
        {
            for (int axis = 0; axis < 3; axis++)
            {
                foreach ((float value, bool holds) in new[] { (5f, true), (-5f, true), (5.1f, false), (-5.1f, false), (float.NaN, false) })
                {
                    float3 v = 1f;
                    v[axis] = value;
                    Assert.That(OuterBounds.Hold(v, 5f), Is.EqualTo(holds), $"axis {axis}: {value}");
                }
            }
        }

        [Test]
        public void AHarmonic_IsACosineWaveWithItsPhase_OfItsAngleAlone()
        {
            foreach (DrivenAngle angle in Enum.GetValues(typeof(DrivenAngle)))
            {
                for (int harmonic = 1; harmonic <= WingKinematics.Harmonics; harmonic++)
                {
                    WingKinematics kinematics = default;
                    kinematics.frequency = 9f;
                    kinematics.SetMean(angle, 0.2f);
                    kinematics.SetHarmonic(angle, harmonic, 0.5f, 0.7f);
                    float2 terms = kinematics.Harmonic(angle, harmonic);
                    for (float p = 0f; p < 6.3f; p += 0.5f)
                    {
                        float wave = terms.x * Mathf.Cos(harmonic * p) + terms.y * Mathf.Sin(harmonic * p);
                        Assert.That(wave, Is.EqualTo(0.5f * Mathf.Cos(harmonic * p + 0.7f)).Within(1e-6f));
                    }

                    int others = 0;
                    for (int k = 0; k < WingKinematics.Count; k++)
                        others += kinematics.At(k) != 0f ? 1 : 0;
                    Assert.That(others, Is.EqualTo(3), "a mean, a cosine and a sine");
                    Assert.That(kinematics.Mean(angle), Is.EqualTo(0.2f));
                    WingKinematics less = kinematics;
                    less.SetHarmonic(angle, harmonic, 0.5f, 0.71f);
                    Assert.That((kinematics.Equals(kinematics), kinematics.Equals(less)), Is.EqualTo((true, false)));
                }
            }
        }

        [Test]
        public void Kinematics_NameWhatIsOutOfRange()
        {
            WingKinematics none = default, kinematics = new WingKinematics { frequency = 9f }, waves = kinematics;
            none.SetMean(DrivenAngle.Flap, 9f);
            waves.waves = true;
            Assert.That((none.IsSet, none.FindProblem(), kinematics.IsSet, kinematics.FindProblem()), Is.EqualTo((false, (string)null, true,
                (string)null)));
            Assert.That(kinematics.Equals(waves), Is.False);
            Assert.That(new WingKinematics { frequency = 0.1f }.FindProblem(), Is.Null);
            Assert.That(new WingKinematics { frequency = 1000f }.FindProblem(), Is.Null);
            Assert.That(new WingKinematics { frequency = 0.09f }.FindProblem(),
                Is.EqualTo("kinematics.frequency is 0.09 hertz; it must be between 0.1 and 1000."));
            Assert.That(new WingKinematics { frequency = 1001f }.FindProblem(), Does.StartWith("kinematics.frequency is 1001 hertz"));
            foreach (DrivenAngle angle in Enum.GetValues(typeof(DrivenAngle)))
            {
                WingKinematics changed = kinematics;
                changed.SetMean(angle, -math.PI);
                Assert.That(changed.FindProblem(), Is.Null);
                changed.SetMean(angle, -3.15f);
                Assert.That(
                    changed.FindProblem(), Is.EqualTo($"kinematics.{angle} has a term of -3.15 radians; it must be between -π and π."));
                changed = kinematics;
                changed.SetHarmonic(angle, WingKinematics.Harmonics, 3.15f, -0.5f * math.PI);
                Assert.That(changed.FindProblem(), Does.StartWith($"kinematics.{angle} has a term of 3.15 radians"));
            }

            Assert.That(() => kinematics.Harmonic(DrivenAngle.Flap, 0),
                Throws.TypeOf<ArgumentOutOfRangeException>().With.Message.Contains("1 to 8"));
            Assert.That(() => kinematics.SetHarmonic(DrivenAngle.Flap, 9, 1f, 0f), Throws.TypeOf<ArgumentOutOfRangeException>());
        }

        // What leads by a phase comes late by the rest of the beat.
        [TestCase(0f, 0f)]
        [TestCase(0.3f, -0.3f)]
        [TestCase(-0.4f, 0.4f)]
        [TestCase(-6f, 6f)]
        public void APhaseLead_IsADelayWithinOneBeat(float lead, float delay)
        {
            WingParameters parameters = WingParameters.Default;
            parameters.phaseLead = lead;
            float found = Lanes.Parameters(parameters).wingDelay.y;
            Assert.That(found, Is.InRange(0f, 2f * math.PI));
            Assert.That(found, Is.EqualTo(delay < 0f ? delay + 2f * math.PI : delay).Within(1e-5f));
        }

        [Test]
        public void StiffnessOfTheMembrane_GrowsWithElasticityAndTheSquareOfTheBeat_ButDoesNotFallBelowThatOfTwo()
        {
            WingParameters parameters = WingParameters.Default;
            LaneParameters Of(float elasticity, float frequency = 10f)
            {
                parameters.elasticity = elasticity;
                parameters.referenceFrequency = frequency;
                return Lanes.Parameters(parameters);
            }

            float rate = 2f * math.PI * 10f;
            Assert.That(Of(4f).springStiffness.x, Is.EqualTo(4f * parameters.springScale * rate * rate).Within(1e-3).Percent);
            Assert.That(Of(4f, 30f).springStiffness.x, Is.EqualTo(9f * Of(4f).springStiffness.x).Within(1e-3).Percent);
            Assert.That(Of(0.3f).springStiffness.x, Is.EqualTo(0.5f * Of(4f).springStiffness.x).Within(1e-3).Percent);
            Assert.That(Of(4f).foldStiffness.x, Is.EqualTo(0.01f * Of(4f).springStiffness.x).Within(1e-3).Percent, "a hundredth");
            Assert.That(Of(0.2f).foldStiffness.x, Is.EqualTo(0.125f * Of(4f).foldStiffness.x).Within(1e-3).Percent, "as of a half");
            Assert.That(Of(4f).bendScale.x, Is.EqualTo(4f * rate * rate).Within(1e-3).Percent);
            Assert.That(Of(4f).anchorRate.x, Is.EqualTo(parameters.anchor * 2f * rate).Within(1e-3).Percent);
            parameters.options.coupling = MembraneCoupling.OneWay;
            Assert.That(Of(0.3f).springStiffness.x, Is.EqualTo(0.3f * parameters.springScale * rate * rate).Within(1e-3).Percent);
            Assert.That(Of(0.3f).foldStiffness.x, Is.Zero);
            parameters.options.springUnits = SpringUnits.Printed;
            Assert.That(Of(0.3f).springStiffness.x, Is.EqualTo(0.3f), "k_e alone");
        }

        [Test]
        public void TheStrongestWind_IsAShareOfTheTipsSpeed_OfAFlapOfATenthAtLeast()
        {
            WingParameters parameters = WingParameters.Default;
            parameters.strongestWind = 0.7f;
            parameters.referenceFrequency = 12f;
            parameters.amplitude = new float3(0.9f, 0.3f, 0.2f);
            parameters.amplitudeScale = 0.5f;
            LaneParameters lanes = Lanes.Parameters(parameters);
            Assert.That(lanes.strongestWind.x, Is.EqualTo(0.7f * 0.9f * 2f * math.PI * 12f).Within(1e-3).Percent);
            Assert.That(lanes.amplitude[1], Is.EqualTo(new float3(0.45f, 0.15f, 0.1f)));
            Assert.That(lanes.wholeFlap.z, Is.EqualTo(0.9f), "delays go by the whole flap");
            parameters.amplitude.x = 0f;
            Assert.That(Lanes.Parameters(parameters).strongestWind.x, Is.EqualTo(0.7f * 0.1f * 2f * math.PI * 12f).Within(1e-3).Percent);
            parameters.dorsalAsymmetry = 4f;
            parameters.inPlaneFactor = 9f;
            parameters.torsionFactor = 16f;
            lanes = Lanes.Parameters(parameters);
            Assert.That((lanes.dorsalDamping.x, lanes.inPlaneDamping.x, lanes.torsionDamping.x), Is.EqualTo((2f, 3f, 4f)));
        }

        [Test]
        public void OnlyWingsWithAClockOfTheirOwn_ArePackedByTheirOwner()
        {
            foreach (WingUpdateMode clock in Enum.GetValues(typeof(WingUpdateMode)))
            {
                PackKey one = new PackKey(clock, 3, WingDetail.Full), other = new PackKey(clock, 4, WingDetail.Full);
                Assert.That(one.Equals(other), Is.EqualTo(clock != WingUpdateMode.Manual), $"{clock}");
                Assert.That(one.Equals(new PackKey(clock, 3, WingDetail.CoarsePatches)), Is.False);
                Assert.That(one.Equals((object)new PackKey(clock, 3, WingDetail.Full)), Is.True);
            }

            Assert.That(new PackKey(WingUpdateMode.Update, 0, WingDetail.Full)
                .Equals(new PackKey(WingUpdateMode.FixedUpdate, 0, WingDetail.Full)), Is.False);
        }

        [TestCase(1, 64)]
        [TestCase(16, 64)]
        [TestCase(17, 128)]
        public void APieceOfABlock_EndsOnAWholeLine(int floats, int bytes)
        {
            byte* block = stackalloc byte[512];
            BlockCarver carver = new BlockCarver(block), dry = new BlockCarver(null);
            Assert.That((long)carver.Carve<float>(floats), Is.EqualTo((long)block));
            Assert.That((long)carver.Carve<float4>(1), Is.EqualTo((long)block + bytes));
            Assert.That(carver.Size, Is.EqualTo(bytes + 64));
            dry.Carve<float>(floats);
            Assert.That((long)dry.Carve<float4>(1), Is.Zero, "measured alone");
            Assert.That(dry.Size, Is.EqualTo(bytes + 64));
        }
    }
}
