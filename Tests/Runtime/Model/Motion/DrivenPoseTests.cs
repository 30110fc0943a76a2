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

        // Chains sweep together where the membrane holds them, and each by its own angle where it does not.
        [Test]
        public void EveryBone_TurnsByItsOwnAngles_AndByTheSweepOfItsChain([Values] MembraneCoupling coupling)
        {
            var random = new Random(7);
            using (var fixture = new PackFixture(Monarch.Rig(), WingParameters.Default))
            {
                fixture.Pack.options.coupling = coupling;
                fixture.Pack.rig.leadingEdge = new float3(1f, 0f, 0f);
                int bones = fixture.rig.BoneCount, perChain = fixture.Pack.rig.jointsPerChain - 1;
                var degrees = new float3[bones];
                for (int bone = 0; bone < bones; bone++)
                {
                    degrees[bone] = random.NextFloat3(-60f, 60f);
                    if (coupling == MembraneCoupling.TwoWay)
                        degrees[bone].y = degrees[bone % perChain].y;
                    float3 angle = math.radians(degrees[bone]);
                    fixture.scratch.angle[bone] = Lanes.All(angle.x, angle.y, angle.z);
                }

                DrivenPose.Evaluate(fixture.Pack, fixture.scratch);
                for (int bone = 0; bone < bones; bone++)
                {
                    float3 angle = degrees[bone];
                    Rotation expected = Rotation.About(0, 0, 1, angle.x) * Rotation.About(0, -1, 0, angle.y)
                        * Rotation.About(1, 0, 0, angle.z);
                    float4 q = fixture.scratch.drivenRotations[bone][2].value;
                    var wanted = new float4((float)expected.x, (float)expected.y, (float)expected.z, (float)expected.w);
                    Assert.That(math.distance(q, wanted), Is.LessThan(1e-5f), $"bone {bone}");
                }
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
