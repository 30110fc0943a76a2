using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    public sealed unsafe class DrivenPoseTests
    {
        [Test]
        public void DrivenRotation_IsFlapAfterSweepAfterFeather()
        {
            using (var fixture = new PackFixture(Monarch.Rig(), WingParameters.Default))
            {
                fixture.Pack.rig.leadingEdge = new float3(1f, 0f, 0f);
                for (int bone = 0; bone < fixture.rig.BoneCount; bone++)
                    fixture.scratch.angle[bone] = Lanes.All(math.radians(30f), math.radians(5f), math.radians(10f));
                DrivenPose.Evaluate(fixture.Pack, fixture.scratch);
                float4 q = fixture.scratch.drivenRotations[0][0].value;
                Rotation expected = Rotation.About(0, 0, 1, 30) * Rotation.About(0, -1, 0, 5) * Rotation.About(1, 0, 0, 10);
                Assert.That(q.w, Is.EqualTo(expected.w).Within(Lanes.CheckTolerance));
                Assert.That(q.x, Is.EqualTo(expected.x).Within(Lanes.CheckTolerance));
                Assert.That(q.y, Is.EqualTo(expected.y).Within(Lanes.CheckTolerance));
                Assert.That(q.z, Is.EqualTo(expected.z).Within(Lanes.CheckTolerance));
            }
        }

        [Test]
        public void Velocities_AreTheRatesOfThePositions()
        {
            WingParameters parameters = WingParameters.Default;
            parameters.tilt = 0.3f;
            using (var fixture = new PackFixture(Monarch.Rig(), parameters, Monarch.Flying()))
            {
                const float h = 2e-4f;
                fixture.Pack.beat->cycles = 5f;
                int joints = fixture.rig.JointCount;
                for (float phase = 0.5f; phase < 6f; phase += 0.9f)
                {
                    float3[] before = Positions(fixture, phase - h), after = Positions(fixture, phase + h);
                    Positions(fixture, phase);
                    float rate = fixture.Pack.beat->rate.x;
                    for (int joint = 0; joint < joints; joint++)
                    {
                        float3 expected = (after[joint] - before[joint]) * (rate / (2f * h));
                        float3 velocity = fixture.scratch.drivenVelocities[joint][0];
                        Assert.That(math.distance(velocity, expected), Is.LessThan(0.15f), $"joint {joint} at {phase}");
                    }
                }
            }
        }

        private static float3[] Positions(PackFixture fixture, float phase)
        {
            fixture.Pack.beat->phase = phase;
            DelayedWaves.Evaluate(fixture.Pack, fixture.scratch);
            DrivenPose.Evaluate(fixture.Pack, fixture.scratch);
            var positions = new float3[fixture.rig.JointCount];
            for (int joint = 0; joint < positions.Length; joint++)
                positions[joint] = fixture.scratch.drivenPositions[joint][0];
            return positions;
        }
    }
}
