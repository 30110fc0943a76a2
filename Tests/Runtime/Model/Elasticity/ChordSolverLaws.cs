using System.Collections.Generic;
using NUnit.Framework;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests
{
    public sealed unsafe class ChordSolverLaws
    {
        private const int k_Chains = 5, k_PerChain = 5, k_Joints = k_Chains * k_PerChain;
        private const float k_AnchorRate = 44f * math.PI, k_Dt = 1f / 240f, k_Stiffness = 4e4f;

        [Test]
        public void GradientAlone_IsThatOfTheLinearisation([Values(0f, 3e4f)] float hold)
        {
            foreach (uint seed in Seeds.Usual)
            {
                using (SpringFixture grid = Grid(seed, new float4(0f, 0.002f, 0.02f, 0.1f)))
                {
                    grid.pack.parameters->foldStiffness = hold;
                    SpringEnergy.Linearise(grid.pack, grid.scratch, grid.scratch.positions, false);
                    var linearised = new SoaFloat3[k_Joints];
                    float4 size = default;
                    for (int joint = 0; joint < k_Joints; joint++)
                    {
                        linearised[joint] = grid.scratch.gradient[joint];
                        size = math.max(size, SoaFloat3.LengthSquared(linearised[joint]));
                    }

                    SpringEnergy.Gradient(grid.pack, grid.scratch, grid.scratch.positions);
                    for (int joint = 0; joint < k_Joints; joint++)
                    {
                        SoaFloat3 difference = grid.scratch.gradient[joint] - linearised[joint];
                        Assert.That(
                            math.all(SoaFloat3.LengthSquared(difference) <= 1e-11f * size), $"joint {joint}, seed {seed}: {difference}");
                    }
                }
            }
        }

        [Test]
        public void NearTheMinimum_OneFactorisationIsEnough_FarFromItNewtonGoesOn()
        {
            foreach (uint seed in Seeds.Usual)
            {
                using (SpringFixture grid = Grid(seed, new float4(1e-5f, 1e-3f, 4e-3f, 0.3f)))
                {
                    float4 factorisations = ChordSolver.Minimise(grid.pack, grid.scratch);
                    Assert.That(factorisations.xyz, Is.EqualTo(new float3(1f)), $"seed {seed}");
                    Assert.That(factorisations.w, Is.GreaterThan(1f), $"seed {seed}");
                }
            }
        }

        [Test]
        public void AWing_GoesWhereItGoesAlone_WhateverTheOthersOfItsPackDo([Values(0.3f, float.NaN)] float other)
        {
            foreach (uint seed in Seeds.Usual)
            {
                var near = new float4(2e-3f, 1e-2f, 5e-4f, 5e-2f);
                using (SpringFixture alone = Grid(seed, near), beside = Grid(seed, new float4(near.xyz, other)))
                {
                    float4 first = ChordSolver.Minimise(alone.pack, alone.scratch);
                    float4 second = ChordSolver.Minimise(beside.pack, beside.scratch);
                    Assert.That(second.xyz, Is.EqualTo(first.xyz));
                    for (int joint = 0; joint < k_Joints; joint++)
                    {
                        for (int lane = 0; lane < 3; lane++)
                        {
                            Assert.That(beside.scratch.positions[joint][lane], Is.EqualTo(alone.scratch.positions[joint][lane]),
                                $"joint {joint}, lane {lane}, seed {seed}");
                        }
                    }
                }
            }
        }

        [Test]
        public void TheEnergy_IsNoHigherThanAtTheStart()
        {
            foreach (uint seed in Seeds.Usual)
            {
                using (SpringFixture grid = Grid(seed, new float4(1e-3f, 1e-2f, 0.1f, 0.5f)))
                {
                    float4 before = SpringEnergy.Value(grid.pack, grid.scratch, grid.scratch.positions);
                    ChordSolver.Minimise(grid.pack, grid.scratch);
                    float4 after = SpringEnergy.Value(grid.pack, grid.scratch, grid.scratch.positions);
                    Assert.That(math.all(after <= before * 1.00001f), $"seed {seed}: {before} to {after}");
                }
            }
        }

        [Test]
        public void OneFactorisation_LeadsToTheMinimum()
        {
            var limits = new NewtonSolver.Limits { newton = 100, tolerance = 1e-7f };
            foreach (uint seed in Seeds.Usual)
            {
                var distances = new float4(5e-4f, 1e-3f, 1.5e-3f, 2e-3f);
                using (SpringFixture grid = Grid(seed, distances), least = Grid(seed, distances))
                {
                    float4 factorisations = ChordSolver.Minimise(grid.pack, grid.scratch);
                    NewtonSolver.Minimise(least.pack, least.scratch, limits);
                    Assert.That(factorisations, Is.EqualTo(new float4(1f)), $"seed {seed}");
                    Assert.That(math.cmax(LargestDistance(grid, least)), Is.LessThan(1e-4f), $"seed {seed}");
                }
            }
        }

        [Test]
        public void MixedSteps_ComeNearerThanPlainOnes()
        {
            var distances = new float4(2e-3f, 3e-3f, 4e-3f, 6e-3f);
            var limits = new NewtonSolver.Limits { newton = 100, tolerance = 1e-7f };
            float mixed = 0f, plain = 0f;
            foreach (uint seed in Seeds.Usual)
            {
                using (SpringFixture grid = Grid(seed, distances), steps = Grid(seed, distances), least = Grid(seed, distances))
                {
                    bool4 isOne = ChordSolver.Minimise(grid.pack, grid.scratch) == 1f;
                    SpringEnergy.Linearise(steps.pack, steps.scratch, steps.scratch.positions, true);
                    BlockCholesky.Factorise(steps.pack, steps.scratch);
                    for (int step = 0; step < 5; step++)
                    {
                        if (step > 0)
                            SpringEnergy.Gradient(steps.pack, steps.scratch, steps.scratch.positions);
                        BlockCholesky.Solve(steps.pack, steps.scratch);
                        for (int joint = 0; joint < k_Joints; joint++)
                            steps.scratch.positions[joint] += steps.scratch.step[joint];
                    }

                    NewtonSolver.Minimise(least.pack, least.scratch, limits);
                    mixed += math.csum(math.select(0f, LargestDistance(grid, least), isOne));
                    plain += math.csum(math.select(0f, LargestDistance(steps, least), isOne));
                }
            }

            Assert.That(mixed, Is.LessThan(0.5f * plain));
        }

        // Away from rest a spring that is too short pushes aside: kept convex, its Hessian is not the gradient's slope.
        [Test]
        public void TheHessian_IsTheSlopeOfTheGradient_UnlessItIsKeptConvex([Values] bool isConvex)
        {
            foreach (uint seed in Seeds.Usual)
            {
                using (SpringFixture grid = Grid(seed, new float4(8e-4f, 1e-3f, 1.5e-3f, 2e-3f)))
                {
                    SpringEnergy.Linearise(grid.pack, grid.scratch, grid.scratch.positions, isConvex);
                    var gradient = new SoaFloat3[k_Joints];
                    for (int joint = 0; joint < k_Joints; joint++)
                        gradient[joint] = grid.scratch.gradient[joint];
                    bool4 failed = BlockCholesky.Factorise(grid.pack, grid.scratch);
                    BlockCholesky.Solve(grid.pack, grid.scratch);
                    float4 part = math.min(0.05f, 1e-4f / math.sqrt(NewtonSolver.LargestMove(grid.pack, grid.scratch)));
                    SoaFloat3[] ahead = GradientAlong(grid, part), behind = GradientAlong(grid, -part);
                    float4 off = default, size = default;
                    for (int joint = 0; joint < k_Joints; joint++)
                    {
                        if (joint % k_PerChain == 0)
                            continue;
                        SoaFloat3 slope = (ahead[joint] - behind[joint]) * (0.5f / part);
                        off += SoaFloat3.LengthSquared(slope + gradient[joint]);
                        size += SoaFloat3.LengthSquared(grid.scratch.step[joint] * grid.scratch.inertia[joint]);
                    }

                    float4 share = math.sqrt(off / size);
                    Assert.That(math.all((isConvex ? share > 0.06f : share < 0.06f) | failed), $"seed {seed}: {share}, {failed}");
                }
            }
        }

        [Test]
        public void NothingIsLeft_OfTheSolveBefore()
        {
            foreach (uint seed in Seeds.Usual)
            {
                var distances = new float4(2e-3f, 3e-3f, 1e-2f, 5e-3f);
                using (SpringFixture used = Grid(seed + 1000, 2f * distances), fresh = Grid(seed, distances), start = Grid(seed, distances))
                {
                    ChordSolver.Minimise(used.pack, used.scratch);
                    for (int joint = 0; joint < k_Joints; joint++)
                    {
                        used.scratch.positions[joint] = start.scratch.positions[joint];
                        used.scratch.anchors[joint] = start.scratch.anchors[joint];
                        used.scratch.inertia[joint] = start.scratch.inertia[joint];
                        used.scratch.targets[joint] = start.scratch.targets[joint];
                    }

                    ChordSolver.Minimise(used.pack, used.scratch);
                    ChordSolver.Minimise(fresh.pack, fresh.scratch);
                    Assert.That(LargestDistance(used, fresh), Is.EqualTo(float4.zero), $"seed {seed}");
                }
            }
        }

        private static SoaFloat3[] GradientAlong(SpringFixture grid, float4 share)
        {
            SoaFloat3* positions = stackalloc SoaFloat3[k_Joints];
            for (int joint = 0; joint < k_Joints; joint++)
                positions[joint] = grid.scratch.positions[joint] + grid.scratch.step[joint] * share;
            SpringEnergy.Gradient(grid.pack, grid.scratch, positions);
            var gradient = new SoaFloat3[k_Joints];
            for (int joint = 0; joint < k_Joints; joint++)
                gradient[joint] = grid.scratch.gradient[joint];
            return gradient;
        }

        private static float4 LargestDistance(SpringFixture one, SpringFixture other)
        {
            float4 square = default;
            for (int joint = 0; joint < k_Joints; joint++)
                square = math.max(square, SoaFloat3.LengthSquared(one.scratch.positions[joint] - other.scratch.positions[joint]));
            return math.sqrt(square);
        }

        // A flat grid posed as it rests; every lane starts with its joints off by up to a distance of its own, roots apart.
        private static SpringFixture Grid(uint seed, float4 distances)
        {
            var random = new Random(seed);
            var rest = new float3[k_Joints];
            for (int joint = 0; joint < k_Joints; joint++)
            {
                float along = (float)(joint % k_PerChain) / (k_PerChain - 1), across = (float)(joint / k_PerChain) / (k_Chains - 1);
                rest[joint] = new float3(along, 0f, -0.5f * across);
            }

            List<Spring> springs = SpringFixture.Grid(k_Chains, k_PerChain, rest);
            var fixture = new SpringFixture(k_Chains, k_PerChain, springs, k_Stiffness);
            for (int joint = 0; joint < k_Joints; joint++)
            {
                fixture.Place(joint, rest[joint], rest[joint], rest[joint], random.NextFloat(0.5f, 1.5f) / k_Joints, k_Dt, k_AnchorRate);
                fixture.scratch.targets[joint] = new SoaFloat3(rest[joint]);
                float3 direction = random.NextFloat3(-1f, 1f);
                if (joint % k_PerChain != 0)
                {
                    fixture.scratch.positions[joint] += new SoaFloat3(
                        direction.x * distances, direction.y * distances, direction.z * distances);
                }
            }

            return fixture;
        }
    }
}
