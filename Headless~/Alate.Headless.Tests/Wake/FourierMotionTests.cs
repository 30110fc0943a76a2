using System;
using System.Linq;
using Alate.Wake;
using NUnit.Framework;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests.Wake
{
    /// <summary>Motions by Fourier series, and grids on meshes.</summary>
    public sealed class FourierMotionTests
    {
        private const int k_Chains = 3, k_Joints = 4;
        private static readonly quaternion s_Turn = quaternion.AxisAngle(math.normalize(new float3(1f, 2f, -0.5f)), 0.8f);

        // [joint] Of harmonics up to six, at a time in beats.
        private static float3[] Exact(uint seed, double beats)
        {
            var random = Random.CreateFromIndex(seed);
            var joints = new float3[k_Chains * k_Joints];
            for (int joint = 0; joint < joints.Length; joint++)
            {
                joints[joint] = random.NextFloat3(-1f, 1f);
                for (int harmonic = 1; harmonic <= FourierMotion.MostHarmonics; harmonic++)
                {
                    joints[joint] += random.NextFloat3(-0.3f, 0.3f)
                        * (float)Math.Cos(2.0 * Math.PI * harmonic * beats + random.NextFloat(0f, 6f));
                }
            }

            return joints;
        }

        [Test]
        public void AMotionOfSixHarmonics_GoesThroughAllOfItsTimes([Values(13, 16, 48)] int count, [Values(0.0, 0.37)] double start)
        {
            float3[][] samples = Enumerable.Range(0, count).Select(k => Exact(5, start + (double)k / count)).ToArray();
            var motion = FourierMotion.Through(samples, k_Chains, k_Joints, start);
            float2[] places = { new(0.5f, 2f / 3f), new(1f, 1f), new(0f, 0f) };
            float3[] points = new float3[3], velocities = new float3[3];
            foreach (double beats in new[] { 0.0, 0.123, 0.9, 5.4 })
            {
                motion.Evaluate(beats, places, points, velocities);
                float3[] exact = Exact(5, beats), later = Exact(5, beats + 1e-4), earlier = Exact(5, beats - 1e-4);
                foreach ((int place, int joint) in new[] { (0, 1 * k_Joints + 2), (1, 2 * k_Joints + 3), (2, 0) })
                {
                    Assert.That(math.length(points[place] - exact[joint]), Is.LessThan(1e-5f));
                    Assert.That(math.length(velocities[place] - (later[joint] - earlier[joint]) / 2e-4f), Is.LessThan(0.02f));
                }
            }
        }

        [Test]
        public void BetweenJoints_TheSurfaceIsBilinear()
        {
            float3[][] samples = Enumerable.Range(0, 16).Select(k => Exact(9, k / 16.0)).ToArray();
            var motion = FourierMotion.Through(samples, k_Chains, k_Joints);
            float3[] points = new float3[1], velocities = new float3[1];
            motion.Evaluate(0.0, new[] { new float2(0.6f, 0.9f) }, points, velocities);
            float3[] joints = Exact(9, 0.0);
            // u = 0.6 · 2 = 1.2: a fifth of the way from chain 1 to 2; v = 0.9 · 3 = 2.7.
            float3 inner = math.lerp(joints[4 + 2], joints[4 + 3], 0.7f), outer = math.lerp(joints[8 + 2], joints[8 + 3], 0.7f);
            Assert.That(math.length(points[0] - math.lerp(inner, outer, 0.2f)), Is.LessThan(1e-5f));
        }

        [Test]
        public void MotionsWithHoles_AreRefused()
        {
            float3[][] samples = Enumerable.Range(0, 16).Select(k => Exact(1, k / 16.0)).ToArray();
            samples[3][7].y = float.NaN;
            Assert.That(Assert.Throws<ArgumentException>(() => FourierMotion.Through(samples, k_Chains, k_Joints)).Message,
                Does.StartWith("Joint 7 of sample 3"));
            samples[3] = new float3[2];
            Assert.That(Assert.Throws<ArgumentException>(() => FourierMotion.Through(samples, k_Chains, k_Joints)).Message,
                Does.StartWith("Sample 3 has 2 joints, not 12"));
            Assert.That(Assert.Throws<ArgumentException>(() => FourierMotion.Through(samples[..2], k_Chains, k_Joints)).Message,
                Does.StartWith("A beat has 2 samples"));
            Assert.That(Assert.Throws<ArgumentException>(() => FourierMotion.Through(samples, 1, k_Joints)).Message,
                Does.Contain("1 chains"));
        }

        [Test]
        public void AGridOnATriangle_SpansItFromEdgeToEdge_AndGoesWithIt()
        {
            // Right triangle: leading edge along x at z = 0, trailing edge z = −(1 − x).
            float3[] rest = { new(0f, 0f, 0f), new(1f, 0f, 0f), new(0f, 0f, -1f) };
            var grid = new SurfaceGrid(rest, new[] { 0, 1, 2 }, 3, 5);
            float3[] places = grid.Evaluate(rest);
            for (int j = 0; j < 5; j++)
            {
                float x = math.lerp(0.005f, 0.995f, j / 4f);
                for (int i = 0; i < 3; i++)
                    Assert.That(math.length(places[i * 5 + j] - new float3(x, 0f, -(1f - x) * i / 2f)), Is.LessThan(1e-5f));
            }

            float3[] moved = Array.ConvertAll(rest, p => math.rotate(s_Turn, 2f * p) + new float3(1f, 2f, 3f));
            float3[] there = grid.Evaluate(moved);
            for (int k = 0; k < places.Length; k++)
            {
                Assert.That(math.length(there[k] - math.rotate(s_Turn, 2f * places[k]) - new float3(1f, 2f, 3f)),
                    Is.LessThan(1e-5f));
            }
        }

        [Test]
        public void BetweenTwoLobes_PlacesLieOnTheNearestRim()
        {
            // Lobes from the root to z = 0.5 … 1 and −0.5 … −1 at the tip.
            float3[] rest = { default, new(1f, 0f, 1f), new(1f, 0f, 0.5f), new(1f, 0f, -0.5f), new(1f, 0f, -1f) };
            var grid = new SurfaceGrid(rest, new[] { 0, 1, 2, 0, 3, 4 }, 9, 7);
            foreach (float3 place in grid.Evaluate(rest))
                Assert.That(math.abs(place.z), Is.InRange(0.5f * place.x - 1e-5f, place.x + 1e-5f), $"{place}");
        }

        [Test]
        public void AMeshWithoutASpan_HasNoGrid()
        {
            float3[] upright = { new(1f, 0f, 0f), new(1f, 1f, 0f), new(1f, 0f, 1f) };
            Assert.That(Assert.Throws<ArgumentException>(() => _ = new SurfaceGrid(upright, new[] { 0, 1, 2 })).Message,
                Does.StartWith("The wing reaches from 1 to 1"));
        }
    }
}
