using System;
using System.Linq;
using Alate.Cli;
using Alate.Wake;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Cli
{
    /// <summary>The stiff wing of an ornithopter beside its measured lift.</summary>
    public sealed class FlappingPlateTests
    {
        [Test]
        public void Velocities_AreTheRatesOfItsPoints()
        {
            var plate = new FlappingPlate();
            float2[] places = [new(0f, 0.1f), new(1f, 0.5f), new(0.5f, 0.9f), new(0f, 1f)];
            float3[] points = new float3[places.Length], before = new float3[places.Length], after = new float3[places.Length],
                velocities = new float3[places.Length], unread = new float3[places.Length];
            foreach (double beats in new[] { 0.0, 0.13, 0.4, 0.77 })
            {
                const double k_Little = 1e-3;
                plate.Evaluate(beats, places, points, velocities);
                plate.Evaluate(beats - k_Little, places, before, unread);
                plate.Evaluate(beats + k_Little, places, after, unread);
                for (int k = 0; k < places.Length; k++)
                {
                    float3 rate = (after[k] - before[k]) / (float)(2 * k_Little);
                    Assert.That(math.distance(rate, velocities[k]), Is.LessThan(2e-3f), $"{places[k]} at {beats}");
                }
            }
        }

        // 12,308 mm² in the digitised drawing; the extremes of the series of the flap in double precision.
        [Test]
        public void AreaAndStroke_AreThoseThatWereRead()
        {
            var plate = new FlappingPlate();
            float2[] places =
                [.. Enumerable.Range(0, 1001).SelectMany(k => new[] { new float2(0f, k / 1000f), new float2(1f, k / 1000f) })];
            float3[] points = new float3[places.Length], velocities = new float3[places.Length];
            plate.Evaluate(0.0, places, points, velocities);
            double area = Enumerable.Range(0, 1001).Average(k => points[2 * k].z - points[2 * k + 1].z);
            Assert.That(area * 213 * 213, Is.EqualTo(12308).Within(1).Percent);

            double[] flaps = [.. Enumerable.Range(0, 1000).Select(k =>
            {
                plate.Evaluate(k / 1000.0, places, points, velocities);
                return Math.Atan2(points[^1].y, points[^1].x) * 180 / Math.PI;
            })];
            Assert.That((flaps[0], flaps.Max(), flaps.Min()), Is.EqualTo((0.21, 25.83, -18.03)).Using<(double, double, double)>(
                (a, b) => Math.Abs(a.Item1 - b.Item1) < 0.1 && Math.Abs(a.Item2 - b.Item2) < 0.1 && Math.Abs(a.Item3 - b.Item3) < 0.1));
        }

        // The mean error that Urban 2020 published of a lattice of the same kind.
        [Test]
        [Explicit]
        [Category("Long")]
        [Category("Faults")]
        public void ALatticeOfAttachedFlow_IsAsNearToTheMeasuredLift_AsAnotherOne()
        {
            (double rms, double error) = FlappingPlate.Fly(WakeMethod.Panels, attached: true, 24);

            Assert.That(FlappingPlate.MeasuredRms, Is.EqualTo(71.7).Within(0.5), "as Urban has it");
            Assert.That(error, Is.LessThan(29.1));
            Assert.That(rms, Is.InRange(FlappingPlate.MeasuredRms, 1.4 * FlappingPlate.MeasuredRms), "it knows no separation");
        }
    }
}
