using System;
using NUnit.Framework;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests
{
    /// <summary>Laws of the air's force over random patches and flights.</summary>
    public sealed unsafe class AerodynamicLaws
    {
        [Test]
        public void ForcesOnTheJoints_AddUpToThoseOnThePatches()
        {
            foreach (uint seed in Seeds.Usual)
            {
                using (PackFixture fixture = new RandomFlight(seed).Fly())
                {
                    for (int joint = 0; joint < fixture.rig.JointCount; joint++)
                        fixture.scratch.forces[joint] = default;
                    Aerodynamics.Apply(fixture.Pack, fixture.scratch);
                    Sum patches = default, joints = default;
                    for (int patch = 0; patch < fixture.rig.PatchCount; patch++)
                        patches.Add(fixture.scratch.loads[patch].force[0]);
                    for (int joint = 0; joint < fixture.rig.JointCount; joint++)
                        joints.Add(fixture.scratch.forces[joint][0]);
                    Assert.That(joints.DistanceTo(patches), Is.LessThanOrEqualTo(1e-5 * patches.absolute), $"seed {seed}");
                }
            }
        }

        [Test]
        public void InStillAir_NoPatchGainsPower()
        {
            foreach (uint seed in Seeds.Usual)
            {
                var random = new Random(seed);
                ModelOptions options = ModelOptions.Physical;
                options.coefficients = (CoefficientSet)random.NextInt(0, 4);
                float3 velocity = random.NextFloat3Direction() * math.pow(10f, random.NextFloat(-3f, 3f));
                PatchLoad load = PatchLoads.Of(
                    options, new SoaFloat3(-velocity), new SoaFloat3(random.NextFloat3Direction()), 0f, random.NextFloat(1e-5f, 1f));
                Assert.That(math.dot(load.force[0], velocity), Is.LessThanOrEqualTo(0f), $"power, seed {seed}");
                Assert.That(load.damping.x, Is.GreaterThanOrEqualTo(0f), $"damping, seed {seed}");
            }
        }

        [Test]
        public void Force_TurnsWithTheWholeScene()
        {
            foreach (uint seed in Seeds.Usual)
            {
                var random = new Random(seed);
                float3 wind = random.NextFloat3(-10f, 10f), normal = random.NextFloat3Direction();
                quaternion turn = random.NextQuaternionRotation();
                float3 force = Force(wind, normal), turned = Force(math.rotate(turn, wind), math.rotate(turn, normal));

                // Near right angles the tangential speed is a small difference of large squares: single precision holds it to about 1e-4.
                Assert.That(math.distance(math.rotate(turn, force), turned), Is.LessThanOrEqualTo(2e-4f * (1f + math.length(force))),
                    $"seed {seed}");
            }
        }

        [Test]
        public void TheSideOfTheNormal_DoesNotMatter()
        {
            foreach (uint seed in Seeds.Usual)
            {
                var random = new Random(seed);
                float3 wind = random.NextFloat3(-10f, 10f), normal = random.NextFloat3Direction(), force = Force(wind, normal);
                Assert.That(
                    math.distance(force, Force(wind, -normal)), Is.LessThanOrEqualTo(1e-5f * (1f + math.length(force))), $"seed {seed}");
            }
        }

        private static float3 Force(float3 wind, float3 normal) =>
            PatchLoads.Of(ModelOptions.Physical, new SoaFloat3(wind), new SoaFloat3(normal), 0f, 0.1f).force[0];

        /// <summary>A sum in double precision, with the sum of the lengths.</summary>
        private struct Sum
        {
            public double x, y, z, absolute;

            public void Add(float3 v)
            {
                x += v.x;
                y += v.y;
                z += v.z;
                absolute += math.length(v);
            }

            public double DistanceTo(Sum o) => Math.Sqrt((x - o.x) * (x - o.x) + (y - o.y) * (y - o.y) + (z - o.z) * (z - o.z));
        }
    }
}
