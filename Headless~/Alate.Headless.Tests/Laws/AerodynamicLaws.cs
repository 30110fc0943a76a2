using System;
using FsCheck;
using FsCheck.Fluent;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    public sealed unsafe class AerodynamicLaws
    {
        [Test]
        public void ForcesOnTheJoints_AddUpToThoseOnThePatches()
        {
            Prop.ForAll(RandomFlight.Seeds, seed =>
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
                    return (joints.DistanceTo(patches) <= 1e-5 * patches.absolute).Label($"seed {seed}: {joints.DistanceTo(patches)} of {patches.absolute}");
                }
            }).QuickCheckThrowOnFailure();
        }

        [Test]
        public void InStillAir_NoPatchGainsPower()
        {
            Prop.ForAll(RandomFlight.Seeds, seed =>
            {
                var random = new Unity.Mathematics.Random((uint)seed);
                ModelOptions options = ModelOptions.Physical;
                options.coefficients = (CoefficientSet)random.NextInt(0, 3);
                float3 velocity = random.NextFloat3Direction() * math.pow(10f, random.NextFloat(-3f, 3f));
                PatchLoad load = PatchAir.Load(
                    options, new SoaFloat3(-velocity), new SoaFloat3(random.NextFloat3Direction()), 0f, random.NextFloat(1e-5f, 1f));
                double power = math.dot(load.force[0], velocity);
                return (power <= 0.0 && load.damping.x >= 0f).Label($"seed {seed}: power {power}, damping {load.damping.x}");
            }).QuickCheckThrowOnFailure();
        }

        [Test]
        public void Force_TurnsWithTheWholeScene()
        {
            Prop.ForAll(RandomFlight.Seeds, seed =>
            {
                var random = new Unity.Mathematics.Random((uint)seed);
                float3 wind = random.NextFloat3(-10f, 10f), normal = random.NextFloat3Direction();
                quaternion turn = random.NextQuaternionRotation();
                float3 force = Force(wind, normal), turned = Force(math.rotate(turn, wind), math.rotate(turn, normal));
                float error = math.distance(math.rotate(turn, force), turned);

                // Near right angles the tangential speed is a small difference of large squares: single precision holds it to about 1e-4.
                return (error <= 2e-4f * (1f + math.length(force))).Label($"seed {seed}: {error} of {math.length(force)}");
            }).QuickCheckThrowOnFailure();
        }

        [Test]
        public void TheSideOfTheNormal_DoesNotMatter()
        {
            Prop.ForAll(RandomFlight.Seeds, seed =>
            {
                var random = new Unity.Mathematics.Random((uint)seed);
                float3 wind = random.NextFloat3(-10f, 10f), normal = random.NextFloat3Direction();
                float error = math.distance(Force(wind, normal), Force(wind, -normal));
                return (error <= 1e-5f * (1f + math.length(Force(wind, normal)))).Label($"seed {seed}: {error}");
            }).QuickCheckThrowOnFailure();
        }

        private static float3 Force(float3 wind, float3 normal) =>
            PatchAir.Load(ModelOptions.Physical, new SoaFloat3(wind), new SoaFloat3(normal), 0f, 0.1f).force[0];

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
