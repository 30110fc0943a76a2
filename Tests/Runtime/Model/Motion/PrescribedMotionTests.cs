using System;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>Wings whose motion is prescribed follow the series, against its closed form in double precision.</summary>
    public sealed unsafe class PrescribedMotionTests
    {
        private static readonly double[] s_Means = { 3, 8, 10, 50 };
        private static readonly double[][] s_Amplitudes = { new[] { 36.0, 4 }, new[] { 2.0 }, new[] { 54.0, 2, 7, 1 }, new[] { 6.0 } };
        private static readonly double[][] s_Phases = { new[] { 0.0, 70 }, new[] { -30.0 }, new[] { 89.0, -88, 52, -7 }, new[] { 20.0 } };

        [Test]
        public void Angles_AreTheSeries_AtEveryBone([Values(false, true)] bool waves)
        {
            using (PackFixture fixture = Fixture(waves))
            {
                for (double phase = 0.1; phase < 6.2; phase += 0.7)
                {
                    Evaluate(fixture, phase);
                    int bones = fixture.rig.JointsPerChain - 1;
                    for (int bone = 0; bone < fixture.rig.BoneCount; bone++)
                    {
                        double along = phase - (waves ? math.PI_DBL * 0.1 * (bone % bones) / bones : 0.0);
                        double delayed = along - (waves ? fixture.Pack.chainDelays[bone / bones][0] : 0.0);
                        float3 angle = fixture.scratch.angle[bone][0];
                        Assert.That(angle.x, Is.EqualTo(Series(0, delayed)).Within(2e-6), $"flap of {bone} at {phase}");
                        Assert.That(angle.y, Is.EqualTo(Series(1, along)).Within(2e-6), $"sweep of {bone} at {phase}");
                        Assert.That(angle.z, Is.EqualTo(Series(2, delayed)).Within(2e-6), $"feather of {bone} at {phase}");
                    }

                    Assert.That(fixture.scratch.means->tiltSin[0], Is.EqualTo(-Math.Sin(Series(3, phase))).Within(2e-6));
                    Assert.That(fixture.scratch.means->tiltHalfCos[0], Is.EqualTo(Math.Cos(0.5 * Series(3, phase))).Within(2e-6));
                }
            }
        }

        [Test]
        public void RatesAndCurvatures_AreTheDerivativesOfTheSeries()
        {
            using (PackFixture fixture = Fixture(false))
            {
                const double h = 1e-4;
                for (double phase = 0.3; phase < 6.2; phase += 0.9)
                {
                    Evaluate(fixture, phase);
                    for (int k = 0; k < 3; k++)
                    {
                        double before = Series(k, phase - h), now = Series(k, phase), after = Series(k, phase + h);
                        Assert.That(Component(fixture.scratch.angleRate[5][0], k), Is.EqualTo((after - before) / (2 * h)).Within(1e-4),
                            $"rate of {k} at {phase}");
                        Assert.That(Component(fixture.scratch.angleCurvature[5][0], k),
                            Is.EqualTo((after - 2 * now + before) / (h * h)).Within(1e-3), $"curvature of {k} at {phase}");
                    }

                    Assert.That(fixture.scratch.means->tiltRate[0],
                        Is.EqualTo(-(Series(3, phase + h) - Series(3, phase - h)) / (2 * h)).Within(1e-4));
                }
            }
        }

        [Test]
        public void Velocities_AreTheRatesOfThePositions()
        {
            using (PackFixture fixture = Fixture(false))
            {
                const double h = 2e-4;
                for (double phase = 0.5; phase < 6; phase += 0.9)
                {
                    float3[] before = Positions(fixture, phase - h), after = Positions(fixture, phase + h);
                    Evaluate(fixture, phase);
                    for (int joint = 0; joint < before.Length; joint++)
                    {
                        float3 expected = (after[joint] - before[joint]) * (float)(fixture.Pack.beat->rate.x / (2 * h));
                        Assert.That(math.distance(fixture.scratch.drivenVelocities[joint][0], expected), Is.LessThan(0.3f),
                            $"joint {joint} at {phase}");
                    }
                }
            }
        }

        [Test]
        public void Frequency_IsThePrescribedOne_AtAnySpeed()
        {
            WingParameters parameters = WingParameters.Default;
            parameters.kinematics = Kinematics(false);
            foreach (float speed in new[] { 0f, 1f, 5f })
            {
                using (var fixture = new PackFixture(Monarch.Rig(), parameters, new WingSurroundings { speed = speed }))
                    Assert.That(fixture.Pack.beat->frequency[0], Is.EqualTo(26.5f));
            }
        }

        [Test]
        public void AWing_FliesTheSame_BesideOneWhoseMotionIsPrescribed()
        {
            using (var world = new WingWorld())
            {
                WingRig rig = Monarch.Rig();
                WingParameters usual = WingParameters.Default, prescribed = usual;
                prescribed.kinematics = Kinematics(true);
                prescribed.kinematics.frequency = 10.0852f;
                WingHandle alone = world.Add(rig, usual, Monarch.Flying());
                using (var other = new WingWorld())
                {
                    WingHandle beside = other.Add(rig, usual, Monarch.Flying());
                    other.Add(rig, prescribed, Monarch.Flying());
                    for (int k = 0; k < 20; k++)
                    {
                        world.Step(1f / 200f);
                        other.Step(1f / 200f);
                    }

                    WingReading a = world.Read(alone), b = other.Read(beside);
                    Assert.That(b.JointPosition(4, 4), Is.EqualTo(a.JointPosition(4, 4)), "bit by bit");
                    Assert.That(b.AirForce, Is.EqualTo(a.AirForce));
                }

                rig.Release();
            }
        }

        [TestCase(0.05f, 0f, "kinematics.frequency is 0.05 hertz; it must be between 0.1 and 1000.")]
        [TestCase(float.NaN, 0f, "kinematics.frequency is NaN hertz; it must be between 0.1 and 1000.")]
        [TestCase(20f, 40f, "kinematics.Flap has a term of 40 radians; it must be between -π and π.")]
        public void AWorld_RefusesAMotionOutOfRange(float frequency, float flap, string message)
        {
            WingParameters parameters = WingParameters.Default;
            parameters.kinematics.frequency = frequency;
            parameters.kinematics.SetMean(DrivenAngle.Flap, flap);

            Assert.That(parameters.FindProblem(), Is.EqualTo(message));
            Assert.That(parameters.Clamped().kinematics.IsSet, Is.False);
        }

        [Test]
        public void AHarmonic_IsReadAsItWasSet_OrRefused()
        {
            WingKinematics kinematics = Kinematics(false);

            float2 third = kinematics.Harmonic(DrivenAngle.Feather, 3);
            Assert.That(math.degrees(math.length(third)), Is.EqualTo(7f).Within(1e-4f));
            Assert.That(math.degrees(math.atan2(-third.y, third.x)), Is.EqualTo(52f).Within(1e-3f));
            Assert.That(math.degrees(kinematics.Mean(DrivenAngle.Sweep)), Is.EqualTo(8f).Within(1e-4f));
            Assert.That(() => kinematics.SetHarmonic(DrivenAngle.Flap, 9, 1f, 0f), Throws.TypeOf<ArgumentOutOfRangeException>());
        }

        private static PackFixture Fixture(bool waves)
        {
            WingParameters parameters = WingParameters.Default;
            parameters.kinematics = Kinematics(waves);
            return new PackFixture(Monarch.Rig(), parameters, Monarch.Flying());
        }

        private static WingKinematics Kinematics(bool waves)
        {
            var kinematics = new WingKinematics { frequency = 26.5f, waves = waves };
            for (int angle = 0; angle < 4; angle++)
            {
                kinematics.SetMean((DrivenAngle)angle, math.radians((float)s_Means[angle]));
                for (int k = 0; k < s_Amplitudes[angle].Length; k++)
                {
                    kinematics.SetHarmonic(
                        (DrivenAngle)angle, k + 1, math.radians((float)s_Amplitudes[angle][k]), math.radians((float)s_Phases[angle][k]));
                }
            }

            return kinematics;
        }

        private static double Series(int angle, double phase)
        {
            double degrees = s_Means[angle];
            for (int k = 0; k < s_Amplitudes[angle].Length; k++)
                degrees += s_Amplitudes[angle][k] * Math.Cos((k + 1) * phase + s_Phases[angle][k] * Math.PI / 180);
            return degrees * Math.PI / 180;
        }

        private static void Evaluate(PackFixture fixture, double phase)
        {
            fixture.Pack.beat->phase = (float)phase;
            DelayedWaves.Evaluate(fixture.Pack, fixture.scratch);
            DrivenPose.Evaluate(fixture.Pack, fixture.scratch);
        }

        private static float3[] Positions(PackFixture fixture, double phase)
        {
            Evaluate(fixture, phase);
            var positions = new float3[fixture.rig.JointCount];
            for (int joint = 0; joint < positions.Length; joint++)
                positions[joint] = fixture.scratch.drivenPositions[joint][0];
            return positions;
        }

        private static double Component(float3 v, int k) => k == 0 ? v.x : k == 1 ? v.y : v.z;
    }
}
