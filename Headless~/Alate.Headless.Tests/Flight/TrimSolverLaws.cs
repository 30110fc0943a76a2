using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.FreeFlights
{
    /// <summary>Trims that a solver prefers, how it weighs departures, and how it names what is missing.</summary>
    public sealed class TrimSolverLaws
    {
        // A slow insect stands steep with a tilted stroke; pitch and tilt fall with the speed, ahead or back.
        [TestCase(0f, 50f, 30f)]
        [TestCase(0.14f, 50f, 30f)]
        [TestCase(0.16f, 48f, 20f)]
        [TestCase(-0.49f, 48f, 20f)]
        [TestCase(0.51f, 42f, 8f)]
        [TestCase(0.89f, 42f, 8f)]
        [TestCase(0.91f, 32f, 0f)]
        [TestCase(1.19f, 32f, 0f)]
        [TestCase(1.21f, 25f, 0f)]
        public void APreferredTrim_CostsNothing_AndADepartureItsScaledSquare(float speed, float pitch, float tilt)
        {
            using var insect = new FlyingInsect("monarch");
            using var solver = new TrimSolver(insect.Model);
            var condition = new FlightCondition(speed, 0.1f);
            var state = new TrimState();
            double[] preferred = [math.radians(pitch), 1, 1, math.radians(tilt), 0], scales = [15, 0.08, 0.10, 15, 10];
            for (int k = 0; k < 5; k++)
                state.z[k] = preferred[k];
            Assert.That(solver.Cost(state, condition), Is.Zero.Within(1e-9));
            for (int k = 0; k < 5; k++)
            {
                double unit = k is 1 or 2 ? 1 : math.PI_DBL / 180;
                state.z[k] = preferred[k] - 2 * scales[k] * unit;
                Assert.That(solver.Cost(state, condition), Is.EqualTo(4).Within(1e-4), $"unknown {k}");
                state.z[k] = preferred[k];
            }

            solver.Near = TrimState.Tilted();
            Assert.That(solver.Cost(TrimState.Tilted(), condition), Is.Zero);
            Assert.That(solver.Cost(state, condition), Is.Positive);
        }

        [Test]
        public void WhatFloats_PrefersALevelBody_AndBeginsWithIt()
        {
            using var fish = new FlyingInsect("snailfish");
            using var solver = new TrimSolver(fish.Model);
            var state = new TrimState();
            (state.z[0], state.z[1], state.z[2], state.z[3], state.z[4]) = (0, 1, 1, 0, 0);
            Assert.That(solver.Cost(state, new FlightCondition(0.1f, 0f)), Is.Zero);
            Assert.That(solver.Start().Pitch, Is.Zero);
            using var monarch = new FlyingInsect("monarch");
            using var other = new TrimSolver(monarch.Model);
            Assert.That(other.Start().Pitch, Is.EqualTo(new TrimState().Pitch).And.Positive);
        }

        [Test]
        public void WhatIsMissing_IsNamed_InItsUnits()
        {
            using var monarch = new FlyingInsect("monarch");
            using var solver = new TrimSolver(monarch.Model);
            var condition = new FlightCondition(0.5f, -0.25f);
            Assert.That(solver.Missing(condition, [-0.25, 0.5, 0.125]), Is.EqualTo(
                "0.5 m/s ahead, -0.25 m/s up: does not close; lift is 0.75 of the weight, thrust 0.50, "
                + "pitching moment 0.125 of weight times wing length."));
            Assert.That(solver.Missing(condition, null), Is.EqualTo("0.5 m/s ahead, -0.25 m/s up: the trim does not settle."));
            using var fish = new FlyingInsect("snailfish");
            using var swimmer = new TrimSolver(fish.Model);
            Assert.That(swimmer.Missing(condition, [-0.25, 0.5, 0.125]), Is.EqualTo(
                "0.5 m/s ahead, -0.25 m/s up: does not close; what is left is lift -0.25, thrust 0.50 of the drag, "
                + "pitching moment 0.125 of the drag times the fin's length."));
        }

        [Test]
        public void TheNormOfAResidual_IsItsLargestPart()
        {
            Assert.That(TrimSolver.Norm(null), Is.EqualTo(double.PositiveInfinity));
            Assert.That(TrimSolver.Norm([0.1, -0.3, 0.2]), Is.EqualTo(0.3));
            Assert.That(TrimSolver.Norm([-0.4, -0.3, 0.2]), Is.EqualTo(0.4));
            Assert.That(TrimSolver.Norm([0.1, 0.2, -0.5]), Is.EqualTo(0.5));
        }

        // From another trim's neighbourhood the solution is the nearest to it that balances.
        [Test]
        public void ASolution_Balances_AndIsTheNearestToWhereItStays()
        {
            using var insect = new FlyingInsect("monarch");
            using var solver = new TrimSolver(insect.Model);
            int level = insect.Table.LevelClimb;
            var near = TrimState.Read(insect.Table.Point(insect.Table.Speeds.Length - 1, level), insect.Model.Frequency);
            var condition = new FlightCondition(insect.Table.TopSpeed, insect.Table.ClimbRates[level]);
            solver.Near = near;
            TrimState found = solver.Solve(condition, near, out double[] residual);
            Assert.That(TrimSolver.Norm(residual), Is.LessThan(TrimSolver.Closed));
            Assert.That(TrimSolver.Norm(solver.Residual(found, condition, out _)), Is.LessThan(TrimSolver.Closed));
            Assert.That(solver.Cost(found, condition), Is.LessThan(0.2), "the table's own trim is hardly left");
            for (int k = 0; k < TrimState.Unknowns; k++)
                Assert.That(found.z[k], Is.InRange(TrimState.Least(k), TrimState.Most(k)));
        }
    }
}
