using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Insects
{
    /// <summary>
    /// The paper's Fig. 14 as numbers: a fishfly from a quarter to four times its elasticity, in substeps at which the softest has
    /// converged.
    /// </summary>
    [Explicit]
    [Category("Long")]
    public sealed class ElasticitySweepTests
    {
        private static readonly Lazy<Sweep> s_Sweep = new Lazy<Sweep>(() => Sweep.Fly(
            new SweepPlan(
                FlownParameters.Find("elasticity"), 0.25, 4, 5, new FlightPlan { Species = "fishfly", Substeps = 240 }, SweepWaves.Both),
            _ => { }));

        [Test]
        public void Values_AreAQuarterToFourTimes()
        {
            Assert.That(s_Sweep.Value.With(wave: true).Select(point => point.Value), Is.EqualTo(new[] { 0.25, 0.5, 1, 2, 4 }).Within(1e-6));
        }

        // The fore wing without the wave twists by 14° from the softest to the species' own elasticity.
        [TestCase(true, 0)]
        [TestCase(true, 1)]
        [TestCase(false, 1)]
        public void Twist_FallsAsElasticityRises(bool wave, int wing) =>
            AssertFalling(wave, point => point.Summary.Wings[wing].TwistPpDeg);

        [TestCase(true, 1)]
        [TestCase(false, 1)]
        public void CamberByTheLoads_FallsAsElasticityRises(bool wave, int wing) =>
            AssertFalling(wave, point => point.LoadCamberPct[wing]);

        // Softer than the species' own, it bends so far that its joints stiffen; its converged camber falls again there, which few substeps
        // hide.
        [Test]
        public void CamberByTheLoads_OfTheForeWing_IsLargestAtTheSpeciesOwnElasticity()
        {
            double[] values = s_Sweep.Value.With(wave: true).Select(point => point.LoadCamberPct[0]).ToArray();

            Assert.That(values[..3], Is.Ordered.Ascending, string.Join(", ", values));
            Assert.That(values[2..], Is.Ordered.Descending, string.Join(", ", values));
        }

        [Test]
        public void LagOfTheTip_FallsAsElasticityRises([Values] bool wave, [Values(0, 1)] int wing) =>
            AssertFalling(wave, point => point.Summary.Wings[wing].TipLagDeg);

        [Test]
        public void TipBend_FallsAsElasticityRises([Values] bool wave, [Values(0, 1)] int wing) =>
            AssertFalling(wave, point => point.Summary.Wings[wing].TipBendPpDeg);

        [Test]
        public void TheWave_TwistsTheWingMore_AtEveryElasticity()
        {
            List<SweepPoint> with = s_Sweep.Value.With(wave: true), without = s_Sweep.Value.With(wave: false);
            for (int k = 0; k < with.Count; k++)
            {
                // The softest twists by 68° even without the wave.
                double least = k == 0 ? 1.1 : 1.2;
                Assert.That(
                    with[k].Summary.Main.TwistPpDeg, Is.GreaterThan(least * without[k].Summary.Main.TwistPpDeg), $"{with[k].Value}");
            }
        }

        [Test]
        public void NoWing_FallsBackToItsDrivenPose()
        {
            Assert.That(s_Sweep.Value.Points.Select(point => point.Summary.Resets), Is.All.Zero);
        }

        private static void AssertFalling(bool wave, Func<SweepPoint, double> measure)
        {
            double[] values = s_Sweep.Value.With(wave).Select(measure).ToArray();
            Assert.That(values, Is.Ordered.Descending.And.Unique, string.Join(", ", values));
            Assert.That(values[values.Length - 1], Is.LessThan(0.9 * values[0]));
        }
    }
}
