using System;
using System.Globalization;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>
    /// The coupled bends of parallel chains against an independent minimisation of the energy that they are said to minimise.
    /// </summary>
    public sealed unsafe class ChainCouplingAgainstDenseTests
    {
        private const int k_Bones = 4;
        private const double k_Off = 0.2;
        private const double k_FreeSlope = 0.1, k_FreeStrain = 0.05, k_Stiffness = 100.0;

        // Chains as far apart as they come in still air. The passes end where one changes a slope by less than a tenth of the free slope.
        [TestCase(3, 0.5f, 0.01f, 0)]
        [TestCase(3, 0.5f, 0.02f, 0)]
        [TestCase(5, 0.5f, 0.005f, 0)]
        [TestCase(5, 0.5f, 0.01f, 0)]
        [TestCase(5, 1f, 0.02f, 0)]
        [TestCase(3, 0.5f, 0.005f, 1)]
        [TestCase(5, 0.5f, 0.0025f, 1)]
        public void CoupledBends_AreThoseOfTheLeastEnergy(int chains, float chord, float bend, int axis)
        {
            double error = 0.0, pull = 0.0;
            for (uint seed = 1; seed <= 12; seed++)
            {
                Solved solved = Solve(chains, chord, bend, axis, seed);
                error = Math.Max(error, solved.Error);
                pull = Math.Max(pull, solved.Pull);
            }

            TestContext.Progress.WriteLine(string.Create(
                CultureInfo.InvariantCulture,
                $"{chains} chains over {chord}, bends to {bend}, axis {axis}: "
                + $"off by {error:P2} of the largest bend, strips turn hinges by {pull:P1} of it"));
            Assert.That(pull, Is.GreaterThan(0.1), "the strips pull");
            Assert.That(error, Is.LessThan(k_Off * pull), "bends that are not coupled are off by all of the pull");
        }

        // Far apart, as in a gale, the passes end before the bends are found (they are off by up to two fifths of the largest); the tear is
        // gone all the same.
        [TestCase(3, 0.5f, 0.3f, 0)]
        [TestCase(5, 0.5f, 0.05f, 0)]
        [TestCase(5, 1f, 0.1f, 0)]
        [TestCase(3, 0.5f, 0.1f, 1)]
        [TestCase(5, 0.5f, 0.05f, 1)]
        public void FarApart_AtMostATwentiethOfTheEnergyThatStripsCanShed_IsLeft(int chains, float chord, float bend, int axis)
        {
            for (uint seed = 1; seed <= 12; seed++)
                Assert.That(Solve(chains, chord, bend, axis, seed).Left, Is.LessThan(0.05), $"seed {seed}");
        }

        /// <param name="Error">Largest error of a bend over the largest bend there was.</param>
        /// <param name="Pull">Largest change of a bend at the minimum, over the same.</param>
        /// <param name="Left">Energy above the minimum over that before.</param>
        private readonly record struct Solved(double Error, double Pull, double Left);

        private static Solved Solve(int chains, float chord, float bend, int axis, uint seed)
        {
            WingParameters parameters = Monarch.Parameters;
            parameters.jointLimit = 1.5f;
            var random = new Unity.Mathematics.Random(seed);
            using var fixture = new PackFixture(
                TestWings.Bake(TestWings.Lattice(chains, 5, 1f, chord), TestWings.Rectangle(12, 6, 1f, chord), 64), parameters);
            int count = chains * k_Bones;
            var bends = new float3[count];
            for (int chain = 0; chain < chains; chain++)
            {
                float3 root = random.NextFloat3(-bend, bend), further = random.NextFloat3(-0.3f * bend, 0.3f * bend);
                for (int bone = 0; bone < k_Bones; bone++)
                    bends[chain * k_Bones + bone] = root + bone * further;
            }

            double[] wanted = new double[count], compliance = new double[count];
            for (int k = 0; k < count; k++)
            {
                fixture.Pack.bendAngles[k] = new SoaFloat3(bends[k]);
                float share = random.NextFloat(0.2f, 0.5f) / fixture.Pack.bendStiffness[k].x;
                fixture.scratch.compliances[k] = new SoaFloat3(new float3(share, share / parameters.inPlaneFactor, 1f));
                wanted[k] = fixture.Pack.bendAngles[k][0][axis];
                compliance[k] = fixture.scratch.compliances[k][0][axis];
            }

            DenseCoupling dense = Dense(fixture, chains, chord, axis, wanted, compliance);
            double[] minimum = dense.Minimum(), found = new double[count];
            ChainCoupling.Apply(fixture.Pack, fixture.scratch, new ImplicitStep { dt = 4e-3f, length = 4e-3f, now = 1f });
            double error = 0.0, pull = 0.0;
            for (int k = 0; k < count; k++)
            {
                found[k] = fixture.Pack.bendAngles[k][0][axis];
                error = Math.Max(error, Math.Abs(found[k] - minimum[k]) / bend);
                pull = Math.Max(pull, Math.Abs(minimum[k] - wanted[k]) / bend);
            }

            double least = dense.Energy(minimum);
            return new Solved(error, pull, (dense.Energy(found) - least) / (dense.Energy(wanted) - least));
        }

        // Every joint of a chain has a strip to the joint beside it on either neighbour.
        private static DenseCoupling Dense(PackFixture fixture, int chains, float chord, int axis, double[] wanted, double[] compliance)
        {
            double width = chord / (chains - 1), factor = axis == 0 ? 1.0 : fixture.Pack.parameters->numbers.inPlaneFactor.x;
            var dense = new DenseCoupling(wanted, compliance, axis == 0 ? k_FreeSlope : k_FreeStrain);
            for (int chain = 0; chain < chains; chain++)
            {
                foreach (int other in new[] { chain - 1, chain + 1 })
                {
                    if (other < 0 || other == chains)
                        continue;
                    double mean = 0.5 * (fixture.Pack.bendStiffness[chain * k_Bones].x + fixture.Pack.bendStiffness[other * k_Bones].x);
                    for (int joint = 1; joint <= k_Bones; joint++)
                    {
                        double[] levers = new double[wanted.Length];
                        for (int bone = 0; bone < joint; bone++)
                        {
                            levers[chain * k_Bones + bone] = 0.25 * (joint - bone) / width;
                            levers[other * k_Bones + bone] = -0.25 * (joint - bone) / width;
                        }

                        dense.Add(levers, k_Stiffness * factor * mean);
                    }
                }
            }

            return dense;
        }
    }
}
