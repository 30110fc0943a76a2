using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Wake;
using NUnit.Framework;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests.Wake
{
    /// <summary>Velocities induced by vortex segments, against closed forms and double precision.</summary>
    public sealed class BiotSavartTests
    {
        private static readonly MirrorImages s_Open = new(false, false, new float3(0f, 1f, 0f), 0f);

        private static float3[] Induce(float3[] chain, float circulation, float coreSquare, float3[] points, MirrorImages images)
        {
            using var field = new VortexField(chain.Length, points.Length, images);
            field.Begin(chain[0]);
            for (int k = 1; k < chain.Length; k++)
                field.Add(chain[k], circulation, coreSquare);
            field.SetPointCount(points.Length);
            for (int k = 0; k < points.Length; k++)
                field.SetPoint(k, points[k]);
            field.Induce();
            return Enumerable.Range(0, points.Length).Select(field.Velocity).ToArray();
        }

        [Test]
        public void ALongSegment_IsAVortexInTheSectionAcrossIt()
        {
            float3[] velocity = Induce(
                new[] { new float3(-1e4f, 0f, 0f), new float3(1e4f, 0f, 0f) }, 3f, 0f, new[] { new float3(0f, 0f, -0.5f) }, s_Open);
            // Γ/2πr, about the segment's direction.
            Assert.That(math.length(velocity[0] - new float3(0f, 3f / (2f * math.PI * 0.5f), 0f)), Is.LessThan(1e-5f));
        }

        [Test]
        public void ARing_DrivesTheAirThroughItsMiddle()
        {
            const int k_Sides = 200;
            float3[] ring = Enumerable.Range(0, k_Sides + 1)
                .Select(k => 2f * new float3(math.cos(2f * math.PI * k / k_Sides), 0f, math.sin(2f * math.PI * k / k_Sides))).ToArray();
            float3[] velocity = Induce(ring, 5f, 0f, new[] { default, new float3(0f, 1.5f, 0f) }, s_Open);
            // Γ/2R in the middle, Γ R²/2(R² + h²)^1.5 on the axis.
            Assert.That(math.abs(velocity[0].y), Is.EqualTo(5f / 4f).Within(1e-3f));
            Assert.That(math.abs(velocity[1].y), Is.EqualTo(5f * 4f / (2f * math.pow(4f + 2.25f, 1.5f))).Within(1e-3f));
        }

        [Test]
        public void ACore_BoundsTheVelocity_AndIsNotFeltFarAway()
        {
            const float k_Core = 0.1f;
            float3[] line = { new(-1e3f, 0f, 0f), new(1e3f, 0f, 0f) };
            float3[] points = { new(0f, 0f, 0f), new(0f, 0f, 1e-3f), new(0f, 0f, k_Core), new(0f, 0f, 3f) };
            float3[] velocity = Induce(line, 2f * math.PI, k_Core * k_Core, points, s_Open);
            Assert.That(math.length(velocity[0]), Is.EqualTo(0f));
            // Vatistas: r/√(rc⁴ + r⁴).
            Assert.That(math.length(velocity[1]), Is.EqualTo(1e-3f / (k_Core * k_Core)).Within(1e-4f));
            Assert.That(math.length(velocity[2]), Is.EqualTo(1f / (math.sqrt(2f) * k_Core)).Within(1e-3f));
            Assert.That(math.length(velocity[3]), Is.EqualTo(1f / 3f).Within(1e-4f));
        }

        [Test]
        public void Chains_AgreeWithDoublePrecision([Range(1, 8)] int seed)
        {
            var random = Random.CreateFromIndex((uint)seed);
            float3[] chain = Enumerable.Range(0, 40).Select(_ => random.NextFloat3(-1f, 1f)).ToArray();
            float3[] points = Enumerable.Range(0, 21).Select(_ => random.NextFloat3(-1f, 1f)).ToArray();
            float3[] ours = Induce(chain, 0.7f, 0.02f, points, s_Open);
            double[][] exact = Array.ConvertAll(points, point => Exact(chain, 0.7, 0.02, point));
            double largest = exact.Max(v => Math.Sqrt(v.Sum(x => x * x)));
            for (int k = 0; k < points.Length; k++)
            {
                for (int axis = 0; axis < 3; axis++)
                    Assert.That(ours[k][axis], Is.EqualTo(exact[k][axis]).Within(2e-5 * largest));
            }
        }

        [Test]
        public void NoAirCrossesThePlanes_OfMirrorImages([Range(1, 6)] int seed)
        {
            var random = Random.CreateFromIndex((uint)seed);
            float3 up = math.normalize(new float3(0f, random.NextFloat(0.2f, 1f), random.NextFloat(-1f, 1f)));
            const float k_Height = 1.3f;
            var images = new MirrorImages(true, true, up, k_Height);
            float3[] chain = Enumerable.Range(0, 6).Select(_ => random.NextFloat3(-1f, 1f)).ToArray();
            float3 place = random.NextFloat3(-2f, 2f);
            float3 ground = place - (math.dot(place, up) + k_Height) * up, middle = place * new float3(0f, 1f, 1f);
            float3[] velocity = Induce(chain, 1f, 0.01f, new[] { ground, middle }, images);
            Assert.That(math.dot(velocity[0], up), Is.EqualTo(0f).Within(1e-5f));
            Assert.That(velocity[1].x, Is.EqualTo(0f).Within(1e-5f));
            Assert.That(math.length(velocity[0]), Is.GreaterThan(1e-3f));
        }

        [Test]
        public void MirrorImages_NeedPlanesAtRightAngles()
        {
            ArgumentException problem = Assert.Throws<ArgumentException>(
                () => _ = new MirrorImages(true, true, math.normalize(new float3(1f, 1f, 0f)), 1f));
            Assert.That(problem.Message, Does.Contain("without x"));
            Assert.DoesNotThrow(() => _ = new MirrorImages(false, true, math.normalize(new float3(1f, 1f, 0f)), 1f));
        }

        private static double[] Exact(IReadOnlyList<float3> chain, double circulation, double coreSquare, float3 point)
        {
            double[] sum = new double[3];
            for (int k = 1; k < chain.Count; k++)
            {
                double[] r1 = Difference(point, chain[k - 1]), r2 = Difference(point, chain[k]), r0 = Difference(chain[k], chain[k - 1]);
                double[] c =
                {
                    r1[1] * r2[2] - r1[2] * r2[1], r1[2] * r2[0] - r1[0] * r2[2], r1[0] * r2[1] - r1[1] * r2[0],
                };
                double square = Dot(c, c), d = Dot(r0, r1) / Math.Sqrt(Dot(r1, r1)) - Dot(r0, r2) / Math.Sqrt(Dot(r2, r2));
                double factor = circulation / (4.0 * Math.PI) * d
                    / Math.Sqrt(square * square + coreSquare * coreSquare * Dot(r0, r0) * Dot(r0, r0));
                for (int axis = 0; axis < 3; axis++)
                    sum[axis] += factor * c[axis];
            }

            return sum;
        }

        private static double[] Difference(float3 a, float3 b) => new double[] { (double)a.x - b.x, (double)a.y - b.y, (double)a.z - b.z };

        private static double Dot(double[] a, double[] b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }
}
