using System;
using Alate.Flight;
using NUnit.Framework;

namespace Alate.Tests.FreeFlights
{
    /// <summary>Derivatives of a trim whose body bobs, against trims whose bob has settled; and how fast trims close.</summary>
    public sealed class TrimSystemLaws
    {
        private static readonly FlightCondition s_Cruise = new(1f, 0f);

        // What the balance becomes when an unknown moves and the bob has settled on its new forces.
        [TestCase("monarch")]
        [TestCase("fishfly")]
        public void TheSlope_IsThatOfABobThatMovesAlong(string species)
        {
            using var insect = new FlyingInsect(species);
            using var system = new TrimSystem(insect.Model);
            TrimState trim = Settled(system, new TrimState());
            system.Linearise(trim, s_Cruise, true);
            double[] left = system.Left;
            double[,] slope = system.Slope;
            double[] steps = [0.02, 0.01, 0.015, 0.02, 0.02];
            for (int k = 0; k < steps.Length; k++)
            {
                TrimState moved = trim.Copy();
                moved.z[k] += steps[k];
                double[] after = system.Residual(Settled(system, moved), s_Cruise, out _);
                for (int q = 0; q < 3; q++)
                {
                    // A beat of another frequency has other substeps here, the same ones there.
                    double within = (k == 1 ? 0.2 : 0.1) * Largest(slope, q);
                    Assert.That((after[q] - left[q]) / steps[k], Is.EqualTo(slope[q, k]).Within(within), $"part {q} over unknown {k}");
                }
            }
        }

        // A body under the periodic forces of its beat: each harmonic of the velocity is that of the force over ikω M.
        [Test]
        public void ABobThatHasSettled_ObeysNewtonsLaw()
        {
            using var insect = new FlyingInsect("monarch");
            using var system = new TrimSystem(insect.Model);
            TrimState trim = Settled(system, new TrimState());
            using var tunnel = new FlightTunnel(insect.Model, 1);
            tunnel.Set(0, trim, s_Cruise);
            tunnel.Restart();
            double frequency = insect.Model.Frequency * trim.FrequencyScale, worst = 0, largest = 0;
            int substeps = FlightTunnel.Substeps(insect.Model, frequency);
            float h = (float)(1 / (frequency * substeps));
            double[] force = new double[3], sums = new double[6];
            for (int step = 0; step < 6 * substeps; step++)
            {
                tunnel.World.StepOnce(h);
                FlyingBody body = tunnel.World.Body(tunnel.Body(0));
                double turn = 2 * Math.PI * (step + 0.5) / substeps;
                (force[0], force[1], force[2]) = (body.force.y, body.force.z, body.moment.x);
                for (int q = 0; q < 3 && step >= 5 * substeps; q++)
                {
                    sums[2 * q] += 2.0 / substeps * force[q] * Math.Cos(turn);
                    sums[2 * q + 1] += 2.0 / substeps * force[q] * Math.Sin(turn);
                }
            }

            double omega = 2 * Math.PI * frequency;
            double[] masses = [insect.Model.Mass, insect.Model.Mass, insect.Model.Inertia.c0.x], typical = [0.3, 0.3, 15];
            for (int q = 0; q < 3; q++)
            {
                int at = 2 * TrimPoint.Harmonics * (q == 2 ? 3 : q);
                double cos = -sums[2 * q + 1] / (omega * masses[q]), sin = sums[2 * q] / (omega * masses[q]);
                worst = Math.Max(worst, Math.Max(Math.Abs(cos - trim.bob[at]), Math.Abs(sin - trim.bob[at + 1])) / typical[q]);
                largest = Math.Max(largest, Math.Max(Math.Abs(cos), Math.Abs(sin)) / typical[q]);
            }

            Assert.That(largest, Is.GreaterThan(0.3), "it bobs");
            Assert.That(worst, Is.LessThan(0.02 * largest));
        }

        // From nothing but the first guess.
        [TestCase("monarch", 0.3f)]
        [TestCase("monarch", 0f)]
        [TestCase("fishfly", 0f)]
        [TestCase("fishfly", 0.15f)]
        [TestCase("swallowtail", 0f)]
        [TestCase("painted-lichen-moth", 0f)]
        [TestCase("dragonfly", 0f)]
        public void AHover_Closes_WhereTheBodyBobsWithTheBeat(string species, float speed)
        {
            using var insect = new FlyingInsect(species);
            using var solver = new TrimSolver(insect.Model);
            TrimState trim = solver.Solve(new FlightCondition(speed, 0f), solver.Start(), out double[] residual);
            Assert.That(TrimSolver.Norm(residual), Is.LessThan(TrimSolver.Closed));
            Assert.That(trim.PitchBob, Is.GreaterThan(0.0));
        }

        private static TrimState Settled(TrimSystem system, TrimState start)
        {
            TrimState trim = start.Copy();
            for (int round = 0; round < 8; round++)
            {
                system.Linearise(trim, s_Cruise, true);
                system.Follow(trim, new double[TrimState.Unknowns]);
            }

            return trim;
        }

        private static double Largest(double[,] slope, int part)
        {
            double largest = 0;
            for (int k = 0; k < slope.GetLength(1); k++)
                largest = Math.Max(largest, Math.Abs(slope[part, k]));
            return largest;
        }
    }
}
