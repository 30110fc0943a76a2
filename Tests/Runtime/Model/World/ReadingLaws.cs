using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>Numbers that are read of wings, against the joints and the commands that they are told of.</summary>
    public sealed unsafe class ReadingLaws
    {
        [Test]
        public void StretchAndElasticEnergy_AreThoseOfTheSprings()
        {
            WingRig rig = Monarch.Rig();
            using (var world = new WingWorld())
            {
                WingHandle wing = world.Add(rig, Monarch.Parameters, Monarch.Flying());
                float perSquare = 0f;
                for (int step = 0; step < 60; step++)
                {
                    world.Step(0.005f);
                    WingReading reading = world.Read(wing);
                    RigView view = rig.ViewAt(false);
                    float largest = 0f, squares = 0f;
                    for (int k = 0; k < view.springCount; k++)
                    {
                        Spring spring = view.springs[k];
                        int joints = reading.JointsPerChain;
                        float length = math.distance(reading.JointPosition(spring.a / joints, spring.a % joints),
                            reading.JointPosition(spring.b / joints, spring.b % joints));
                        largest = math.max(largest, math.abs(length / spring.length - 1f));
                        squares += (length - spring.length) * (length - spring.length);
                    }

                    if (step < 20)
                        continue;
                    Assert.That(largest, Is.GreaterThan(1e-4f));
                    Assert.That(reading.Stretch, Is.EqualTo(largest).Within(1e-5f), $"step {step}");
                    perSquare = perSquare == 0f ? reading.SpringEnergy / squares : perSquare;
                    Assert.That(reading.SpringEnergy / squares, Is.EqualTo(perSquare).Within(1).Percent, $"step {step}");
                }
            }

            rig.Release();
        }

        [Test]
        public void EachOfFourWings_HasTheCommandThatItWasGiven_UntilItIsReleased()
        {
            using (var world = new WingWorld())
            {
                WingRig rig = Monarch.Rig();
                var wings = new WingHandle[4];
                var drives = new WingDrive[4];
                for (int k = 0; k < 4; k++)
                {
                    wings[k] = world.Add(rig, Monarch.Parameters);
                    drives[k] = new WingDrive
                    {
                        frequency = 8f + k,
                        amplitude = 0.5f + 0.1f * k,
                        meanFlap = 0.01f + k,
                        tilt = 0.02f + 0.1f * k,
                        meanSweep = 0.03f + 0.1f * k,
                        meanFeather = 0.04f + 0.1f * k,
                    };
                }

                rig.Release();
                for (int k = 0; k < 4; k++)
                    world.SetDrive(wings[k], drives[k]);
                for (int k = 0; k < 4; k++)
                    Assert.That(world.Drive(wings[k]), Is.EqualTo(drives[k]), $"wing {k}");
                world.ReleaseDrive(wings[1]);
                for (int step = 0; step < 60; step++)
                    world.Step(0.01f);
                for (int k = 0; k < 4; k++)
                {
                    float frequency = k == 1 ? Monarch.Parameters.maxFrequency : drives[k].frequency;
                    Assert.That(world.Read(wings[k]).Frequency, k == 1 ? Is.Not.EqualTo(drives[k].frequency) : Is.EqualTo(frequency));
                }
            }
        }

        // A wing whose state is no number is put back, and that is counted, for it alone.
        [Test]
        public void Recoveries_AreCounted_LaneByLane()
        {
            using (var fixture = new PackFixture(Monarch.Rig(), Monarch.Parameters, Monarch.Flying()))
            {
                for (int times = 1; times <= 3; times++)
                {
                    SoaFloat3 position = fixture.Pack.pose[7].position;
                    position[2] = new float3(0f, float.NaN, 0f);
                    fixture.Pack.pose[7].position = position;
                    PackStep.Run(ref fixture.Pack, fixture.scratch, fixture.Substep);
                    Assert.That(fixture.Pack.readings->resets, Is.EqualTo(new float4(0f, 0f, times, 0f)));
                    Assert.That(math.all(math.isfinite(fixture.Pack.pose[7].position[2])));
                }
            }
        }
    }
}
