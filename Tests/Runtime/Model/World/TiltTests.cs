using System;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>A stroke plane that is tilted nose up lifts more in forward flight, one tilted nose down less.</summary>
    public sealed class TiltTests
    {
        private const int k_Steps = 24, k_Beats = 8;

        [TestCase(25.4f, 1.35)]
        [TestCase(0f, 0.67)]
        [TestCase(-25.4f, -0.22)]
        public void LiftOverWeight_IsThatOfTheReference_WithTheNoseUp(float tilt, double expected)
        {
            double lift = LiftOverWeight(tilt);
            TestContext.Progress.WriteLine(FormattableString.Invariant($"tilt {tilt}: {lift:F3}"));

            // Of what tilting up by as much is worth, where the lift itself is small.
            Assert.That(lift, Is.EqualTo(expected).Within(0.15 * Math.Max(Math.Abs(expected), 0.67)));
        }

        [Test]
        public void TiltedNoseUp_AWingLiftsMore_NoseDown_Less()
        {
            double down = LiftOverWeight(-10f), none = LiftOverWeight(0f), up = LiftOverWeight(10f);

            Assert.That(up, Is.GreaterThan(none + 0.1));
            Assert.That(none, Is.GreaterThan(down + 0.1));
        }

        [Test]
        public void TheDownstrokeOfAWingThatIsTiltedNoseUp_GoesForward()
        {
            // As that of a raised body would: +X turns Z to −Y, so the stroke plane's lower end lies ahead.
            WingParameters parameters = Monarch.Parameters;
            parameters.tilt = math.radians(30f);
            parameters.amplitude.y = parameters.amplitude.z = 0f;
            WingRig rig = Monarch.Rig(16);
            using (var world = new WingWorld())
            {
                WingHandle wing = world.Add(rig, parameters);
                rig.Release();
                float3 top = world.Read(wing).JointPosition(0, 4);
                world.Step(0.5f / world.Read(wing).Frequency);
                float3 bottom = world.Read(wing).JointPosition(0, 4);

                Assert.That(top.y, Is.GreaterThan(bottom.y + 0.5f));
                Assert.That(bottom.z, Is.GreaterThan(top.z + 0.3f));
            }
        }

        private static double LiftOverWeight(float tilt)
        {
            const float wingMass = 25.1e-6f, insectMass = 0.428e-3f, pitchDegrees = 18.6f;
            float pitch = math.radians(pitchDegrees);
            WingParameters parameters = Monarch.Parameters;
            parameters.tilt = math.radians(tilt);
            WingRig rig = Monarch.Rig(64);
            using (var world = new WingWorld())
            {
                WingHandle wing = world.Add(rig, parameters, Monarch.Flying(1.3f, pitch));
                rig.Release();
                float dt = 1f / (k_Steps * world.Read(wing).Frequency);
                float3 force = float3.zero;
                for (int k = 0; k < k_Beats * k_Steps; k++)
                {
                    world.Step(dt);
                    if (k >= (k_Beats - 1) * k_Steps)
                        force += world.Read(wing).AirForce / k_Steps;
                }

                return 2.0 * math.rotate(quaternion.RotateX(-pitch), force).y * wingMass * Monarch.Length / (insectMass * 9.81);
            }
        }
    }
}
