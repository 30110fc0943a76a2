using System;
using System.Collections.Generic;
using System.Linq;
using MathNet.Numerics.LinearAlgebra;
using NUnit.Framework;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests
{
    public sealed unsafe class NewtonAgainstDenseTests
    {
        private const int k_Few = 8, k_Many = 200;

        /// <summary>f_ref and substep of the species' presets lie about here: 12 Hz, 24 substeps of a beat of 10 Hz.</summary>
        private const float k_BeatRate = 2f * math.PI * 12f, k_Dt = 1f / 240f;

        private delegate void Solver(in WingPack pack, in StepScratch scratch);

        [Test]
        public void AtThePresets_TheDefaultLimits_FindTheSameMinimum() => AssertDefaultLimits(0, k_Few);

        [Test]
        [Explicit]
        [Category("Long")]
        public void AtThePresets_TheDefaultLimits_FindTheSameMinimum_OfMoreSprings() => AssertDefaultLimits(k_Few, k_Many);

        [Test]
        public void Chords_FindTheSameMinimum_AtThePresets() => AssertChords(0, k_Few);

        [Test]
        [Explicit]
        [Category("Long")]
        public void Chords_FindTheSameMinimum_AtThePresets_OfMoreSprings() => AssertChords(k_Few, k_Many);

        [Test]
        public void AStepJustAboveTheTolerance_IsFollowedByAnother()
        {
            var random = new Random(763145616u);
            Assert.That(Error(ref random, random.NextFloat(0.5f, 2f), Newton(NewtonSolver.Limits.Default)), Is.LessThan(1e-4f));
        }

        [Test]
        public void AtAnyStiffness_WithoutLimits_FindsTheSameMinimum() => AssertWithoutLimits(0, k_Few);

        [Test]
        [Explicit]
        [Category("Long")]
        public void AtAnyStiffness_WithoutLimits_FindsTheSameMinimum_OfMoreSprings() => AssertWithoutLimits(k_Few, k_Many);

        private static void AssertDefaultLimits(int first, int end) => AssertNear(first, end, Newton(NewtonSolver.Limits.Default));

        private static void AssertChords(int first, int end) => AssertNear(first, end, ByChords);

        private static void AssertNear(int first, int end, Solver solver)
        {
            foreach (uint seed in Seeds.First(end).Skip(first))
            {
                var random = new Random(seed);
                float elasticity = random.NextFloat(0.5f, 2f);
                Assert.That(
                    Error(ref random, elasticity, solver), Is.LessThan(1e-4f), $"wing lengths at elasticity {elasticity}, seed {seed}");
            }
        }

        private static void AssertWithoutLimits(int first, int end)
        {
            foreach (uint seed in Seeds.First(end).Skip(first))
            {
                var random = new Random(seed);
                float elasticity = math.pow(10f, random.NextFloat(-2f, 6f));
                var limits = new NewtonSolver.Limits { newton = 100, tolerance = 1e-7f };
                Assert.That(
                    Error(ref random, elasticity, Newton(limits)), Is.LessThan(1e-4f),
                    $"wing lengths at elasticity {elasticity}, seed {seed}");
            }
        }

        private static Solver Newton(NewtonSolver.Limits limits) =>
            (in WingPack pack, in StepScratch scratch) => NewtonSolver.Minimise(pack, scratch, limits);

        private static void ByChords(in WingPack pack, in StepScratch scratch) => ChordSolver.Minimise(pack, scratch);

        // A random grid in a random pose, moved smoothly out of its plane and a little within it, as between two substeps: our solution
        // against the dense one. A monarch's joints move by up to 0.012 in the first Newton iteration of a substep. (Joints moved each on
        // its own would compress springs by several per cent; a flat grid then buckles to either side, and there is more than one minimum.)
        private static float Error(ref Random random, float elasticity, Solver solver)
        {
            int chains = random.NextInt(3, 9), perChain = random.NextInt(3, 9), joints = chains * perChain;
            var rest = new float3[joints];
            for (int k = 0; k < joints; k++)
            {
                float along = (float)(k % perChain) / (perChain - 1), across = (float)(k / perChain) / (chains - 1);
                float jitter = 0.1f / math.max(chains, perChain);
                rest[k] = new float3(along, 0f, -across * (0.3f + 0.4f * along)) + random.NextFloat3(-jitter, jitter);
            }

            List<Spring> springs = SpringFixture.Grid(chains, perChain, rest);
            float stiffness = elasticity * 10f * k_BeatRate * k_BeatRate, anchorRate = 2f * k_BeatRate * math.sqrt(elasticity);
            quaternion turn = random.NextQuaternionRotation();
            float noise = 1e-3f / math.max(chains, perChain);
            float3 bend = random.NextFloat3(-0.01f, 0.01f), shear = random.NextFloat3(-0.001f, 0.001f);
            double[] start = new double[3 * joints];
            double[] anchors = new double[3 * joints];
            double[] inertia = new double[joints];
            using (var fixture = new SpringFixture(chains, perChain, springs, stiffness))
            {
                for (int k = 0; k < joints; k++)
                {
                    bool root = k % perChain == 0;
                    float3 posed = math.rotate(turn, rest[k]);
                    float3 moved = math.rotate(turn, Motion(rest[k], bend, shear)) + random.NextFloat3(-noise, noise);
                    float3 predicted = root ? posed : posed + moved;
                    fixture.Place(k, root ? posed : predicted, predicted, posed, random.NextFloat(0.5f, 1.5f) / joints, k_Dt, anchorRate);
                    for (int axis = 0; axis < 3; axis++)
                    {
                        start[3 * k + axis] = fixture.scratch.positions[k][0][axis];
                        anchors[3 * k + axis] = fixture.scratch.anchors[k][0][axis];
                    }

                    inertia[k] = fixture.scratch.inertia[k].x;
                }

                solver(fixture.pack, fixture.scratch);
                Vector<double> wanted = new DenseReference(joints, perChain, springs, stiffness, anchors, inertia).Minimise(start);
                double worst = 0.0;
                for (int k = 0; k < 3 * joints; k++)
                {
                    double found = fixture.scratch.positions[k / 3][k % 4][k % 3];
                    worst = Math.Max(worst, Math.Abs(found - wanted[k]));
                    if (double.IsNaN(found))
                        return float.NaN;
                }

                return (float)worst;
            }
        }

        private static float3 Motion(float3 p, float3 bend, float3 shear) => new float3(
            shear.x * p.x, bend.x * p.x + bend.y * p.x * p.x + bend.z * p.x * p.z, shear.y * p.x + shear.z * p.z);
    }
}
