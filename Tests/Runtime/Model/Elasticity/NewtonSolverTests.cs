using System.Collections.Generic;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    public sealed unsafe class NewtonSolverTests
    {
        private const double k_AnchorRate = 44.0 * System.Math.PI, k_Dt = 0.005;

        [TestCase(1)]
        [TestCase(30)]
        public void TwoSprings_GoWhereTheyGoInDoublePrecision(int newton)
        {
            double[] expected = TwoSpringsInDouble(newton);
            using (SpringFixture springs = TwoSprings())
            {
                NewtonSolver.Minimise(springs.pack, springs.scratch, new NewtonSolver.Limits { newton = newton, tolerance = 1e-7f });
                float3 joint = springs.scratch.positions[1][0];
                for (int axis = 0; axis < 3; axis++)
                    Assert.That(joint[axis], Is.EqualTo(expected[axis]).Within(0.01 * expected[axis]), $"axis {axis}");
            }
        }

        [Test]
        public void Gradient_IsTheSlopeOfTheEnergy()
        {
            using (SpringFixture springs = TwoSprings())
            {
                SoaFloat3* x = springs.scratch.positions;
                SpringEnergy.Linearise(springs.pack, springs.scratch, x, false);
                float3 gradient1 = springs.scratch.gradient[1][0], gradient2 = springs.scratch.gradient[2][0];
                const float h = 2e-3f;
                for (int joint = 1; joint <= 2; joint++)
                {
                    for (int axis = 0; axis < 3; axis++)
                    {
                        double slope = (EnergyMoved(springs, joint, axis, h) - EnergyMoved(springs, joint, axis, -h)) / (2.0 * h);
                        float analytic = joint == 1 ? gradient1[axis] : gradient2[axis];
                        Assert.That(analytic, Is.EqualTo(slope).Within(1.5), $"joint {joint}, axis {axis}");
                    }
                }
            }
        }

        [Test]
        public void Step_TakesAwayTheGradient()
        {
            using (SpringFixture springs = TwoSprings())
            {
                SpringEnergy.Linearise(springs.pack, springs.scratch, springs.scratch.positions, false);
                Assert.That(math.any(BlockCholesky.Factorise(springs.pack, springs.scratch)), Is.False);
                BlockCholesky.Solve(springs.pack, springs.scratch);
                float3[] step = new[] { springs.scratch.step[0][0], springs.scratch.step[1][0], springs.scratch.step[2][0] };
                float3 gradient1 = springs.scratch.gradient[1][0], gradient2 = springs.scratch.gradient[2][0];

                const float h = 0.05f;
                float3[] ahead = GradientMoved(springs, step, h), behind = GradientMoved(springs, step, -h);
                Assert.That(step[0], Is.EqualTo(float3.zero));
                Assert.That(math.distance(-gradient1, (ahead[1] - behind[1]) / (2f * h)), Is.LessThan(0.002f * math.length(gradient1)));
                Assert.That(math.distance(-gradient2, (ahead[2] - behind[2]) / (2f * h)), Is.LessThan(0.002f * math.length(gradient2)));
            }
        }

        [Test]
        public void CompressedSpring_MeetsNegativeCurvature_AndStillConverges()
        {
            var spring = new List<Spring> { new Spring { a = 0, b = 1, length = 1f } };
            using (var springs = new SpringFixture(1, 2, spring, 1e5f))
            {
                // Pushed to a tenth of its length, a little off axis: the transversal curvature is far below what mass holds.
                springs.Place(0, float3.zero, float3.zero, float3.zero, 0.1f, 0.01f, 10f);
                springs.Place(1, new float3(0.1f, 0.001f, 0f), new float3(0.1f, 0.001f, 0f), new float3(1f, 0f, 0f), 0.1f, 0.01f, 10f);
                float4 before = SpringEnergy.Value(springs.pack, springs.scratch, springs.scratch.positions);
                NewtonSolver.Minimise(springs.pack, springs.scratch, new NewtonSolver.Limits { newton = 60, tolerance = 1e-6f });
                float4 after = SpringEnergy.Value(springs.pack, springs.scratch, springs.scratch.positions);
                SpringEnergy.Linearise(springs.pack, springs.scratch, springs.scratch.positions, false);
                Assert.That(after.x, Is.LessThan(before.x));
                Assert.That(math.length(springs.scratch.positions[1][0]), Is.EqualTo(1f).Within(0.02f));
                Assert.That(math.length(springs.scratch.gradient[1][0]), Is.LessThan(5f));
            }
        }

        private static SpringFixture TwoSprings()
        {
            var springs = new List<Spring> { new Spring { a = 0, b = 1, length = 0.5f }, new Spring { a = 1, b = 2, length = 0.5f } };
            var fixture = new SpringFixture(1, 3, springs, 4000f);
            float anchorRate = 44f * math.PI;
            var first = new float3(0.52f, 0.05f, 0f);
            var second = new float3(1.05f, 0.2f, 0.02f);
            fixture.Place(0, float3.zero, float3.zero, float3.zero, 1f, 0.005f, anchorRate);
            fixture.Place(1, first, first, new float3(0.5f, 0f, 0f), 0.3f, 0.005f, anchorRate);
            fixture.Place(2, second, second, new float3(1f, 0f, 0f), 0.2f, 0.005f, anchorRate);
            return fixture;
        }

        // F of Eq. 15: inertia m/dt² pulls to where a joint starts, an anchor mΩ² to where it is posed.
        private static double[] TwoSpringsInDouble(int newton)
        {
            double[] start = { 0.52, 0.05, 0.0, 1.05, 0.2, 0.02 }, posed = { 0.5, 0.0, 0.0, 1.0, 0.0, 0.0 }, masses = { 0.3, 0.2 };
            double inertia = 1.0 / (k_Dt * k_Dt), anchor = k_AnchorRate * k_AnchorRate;
            double[] anchors = new double[6];
            for (int k = 0; k < 6; k++)
                anchors[k] = (inertia * start[k] + anchor * posed[k]) / (inertia + anchor);
            double[] stiffnesses = { masses[0] * (inertia + anchor), masses[1] * (inertia + anchor) };
            return new SpringsInDouble(4000.0, 0.5, stiffnesses, anchors).Minimise(start, newton);
        }

        private static double EnergyMoved(SpringFixture springs, int joint, int axis, float h)
        {
            SoaFloat3 kept = springs.scratch.positions[joint];
            float3 moved = kept[0];
            moved[axis] += h;
            springs.scratch.positions[joint] = new SoaFloat3(moved);
            float4 energy = SpringEnergy.Value(springs.pack, springs.scratch, springs.scratch.positions);
            springs.scratch.positions[joint] = kept;
            return energy.x;
        }

        private static float3[] GradientMoved(SpringFixture springs, float3[] v, float h)
        {
            var gradient = new float3[v.Length];
            for (int joint = 0; joint < v.Length; joint++)
                springs.scratch.candidate[joint] = springs.scratch.positions[joint] + new SoaFloat3(v[joint] * h);
            SpringEnergy.Linearise(springs.pack, springs.scratch, springs.scratch.candidate, false);
            for (int joint = 0; joint < v.Length; joint++)
                gradient[joint] = springs.scratch.gradient[joint][0];
            return gradient;
        }
    }
}
