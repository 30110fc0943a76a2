using System;
using System.Linq;
using Alate.Cli;
using Alate.Wake;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Cli
{
    /// <summary>Motion of the hovering fruit fly by its published numbers, and its loads.</summary>
    public sealed class HoveringFlyTests
    {
        private const double k_Attack = 37 * Math.PI / 180, k_Length = 3e-3, k_Frequency = 240;

        private static (float3[] Points, float3[] Velocities) At(double beats, params float2[] places)
        {
            var points = new float3[places.Length];
            var velocities = new float3[places.Length];
            new HoveringFly(k_Attack).Evaluate(beats, places, points, velocities);
            return (points, velocities);
        }

        [Test]
        public void TheVelocity_IsTheRateOfThePlace(
            [Values(0.01, 0.1, 0.18, 0.25, 0.33, 0.45, 0.5, 0.62, 0.75, 0.9, 0.99, 1.3)] double beats)
        {
            const double k_Step = 1e-3;
            float2[] places = [new(0f, 0.3f), new(1f, 0.5f), new(0.4f, 0.95f)];
            (float3[] _, float3[] velocities) = At(beats, places);
            float3[] before = At(beats - k_Step, places).Points, after = At(beats + k_Step, places).Points;
            for (int k = 0; k < places.Length; k++)
                Assert.That(math.length((after[k] - before[k]) / (float)(2 * k_Step) - velocities[k]), Is.LessThan(2e-3f));
        }

        // 2 Φ n r₂ = 2.19 m/s, by which the published coefficients and the Reynolds number of 147 are made.
        [Test]
        public void TheMeanSpeed_IsThePublishedOne()
        {
            const int k_Samples = 400;
            double mean = Enumerable.Range(0, k_Samples).Average(
                k => (double)math.length(At((k + 0.5) / k_Samples, new float2(0.25f, 0.58f)).Velocities[0])) * k_Length * k_Frequency;
            Assert.That(mean, Is.EqualTo(2.19).Within(0.01));
        }

        [Test]
        public void TheAngle_IsTheSameInBothHalfStrokes_AndTheLeadingEdgeIsUpAtTheirEnds()
        {
            double Attack(double beats)
            {
                (float3[] points, float3[] velocities) = At(beats, new float2(0f, 0.6f), new float2(1f, 0.6f), new float2(0.25f, 0.6f));
                float3 chord = math.normalize(points[0] - points[1]);
                return Math.Asin(chord.y) * 180 / Math.PI * Math.Sign(math.dot(chord, velocities[2]));
            }

            Assert.That(new[] { Attack(0.2), Attack(0.25), Attack(0.75), Attack(0.81) }, Is.All.EqualTo(37).Within(1e-3));
            foreach (double end in new[] { 0.0, 0.5 })
            {
                float3[] points = At(end, new float2(0f, 0.6f), new float2(1f, 0.6f)).Points;
                Assert.That(math.normalize(points[0] - points[1]).y, Is.EqualTo(1f).Within(1e-5f));
            }
        }

        [Test]
        public void ThePlanform_HasTheMeasuredAreaAndMoment()
        {
            const int k_Strips = 5000;
            double[] shares = [.. Enumerable.Range(0, k_Strips).Select(k => (k + 0.5) / k_Strips)];
            double area = shares.Average(share => FlyPlanform.Chord(share, 1.0));
            Assert.That(area, Is.EqualTo(1).Within(0.1).Percent);
            double moment = shares.Average(share => share * share * FlyPlanform.Chord(share, 1.0));
            Assert.That(moment, Is.EqualTo(FlyPlanform.Moment).Within(0.5).Percent);
        }

        // Whatever the flips take, the downwash that is taken out of the coefficients is what lifts a hovering fly too much.
        [Test]
        public void WithoutTheMeasuredDownwash_TheFlyLiftsLess()
        {
            (double taken, double _) = HoveringFly.Fly(37, new WakeSettings());
            (double left, double _) = HoveringFly.Fly(37, new WakeSettings(), downwash: MeasuredDownwash.None);
            Assert.That(taken, Is.GreaterThan(1.2 * left));
            (double brief, double _) = HoveringFly.Fly(37, new WakeSettings(), flip: 0.1, downwash: MeasuredDownwash.None);
            Assert.That(brief, Is.EqualTo(left).Within(6).Percent);
        }
    }
}
