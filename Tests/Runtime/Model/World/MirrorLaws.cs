using System;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>Mirrored wings with random parameters in random air fly the mirror image.</summary>
    public sealed class MirrorLaws
    {
        private const int k_Wings = 20;
        private const float k_Near = 1e-3f;

        private static readonly float3 s_Across = new float3(-1f, 1f, 1f);

        [Test]
        public void ALeftWing_FliesTheMirrorImageOfTheRight()
        {
            WingRig right = TestWings.Bake(TestWings.Fan(), TestWings.Ellipse(), 64), left = Mirrored();
            Assert.That(left.Frame.mirrored, Is.True);
            foreach (uint seed in Seeds.First(k_Wings))
            {
                var flight = new RandomFlight(seed);
                using (var world = new WingWorld())
                {
                    WingHandle one = world.Add(right, flight.Parameters, flight.Surroundings);
                    WingHandle other = world.Add(left, flight.Parameters, flight.Surroundings);
                    float dt = 1f / (24f * world.Read(one).Frequency);
                    for (int k = 0; k < flight.Substeps; k++)
                        world.Step(dt);
                    world.Skin();
                    NativeArray<SkinnedVertex> a = world.Vertices(one), b = world.Vertices(other);
                    double worst = 0.0, turned = 0.0, moved = 0.0;
                    Vector3[] rest = TestWings.Ellipse().positions;
                    for (int k = 0; k < a.Length; k++)
                    {
                        moved = Math.Max(moved, math.distance(a[k].position, rest[k]));
                        worst = Math.Max(worst, math.distance(s_Across * (float3)a[k].position, b[k].position));
                        turned = Math.Max(turned, math.distance(s_Across * (float3)a[k].normal, b[k].normal));
                    }

                    Assert.That(moved, Is.GreaterThan(0.05), $"the wing flies, seed {seed}");
                    Assert.That(worst, Is.LessThan(k_Near), $"wing lengths, seed {seed}");
                    Assert.That(turned, Is.LessThan(10f * k_Near), $"normals, seed {seed}");
                }
            }

            right.Release();
            left.Release();
        }

        private static WingRig Mirrored()
        {
            WingSkeleton skeleton = TestWings.Fan();
            SurfaceMesh surface = TestWings.Ellipse();
            for (int k = 0; k < surface.positions.Length; k++)
                surface.positions[k] = s_Across * surface.positions[k];
            for (int k = 0; k < surface.triangles.Length; k += 3)
                (surface.triangles[k], surface.triangles[k + 1]) = (surface.triangles[k + 1], surface.triangles[k]);
            foreach (JointChain chain in skeleton.Chains)
            {
                for (int j = 0; j < chain.Length; j++)
                    chain.joints[j] = s_Across * chain.joints[j];
            }

            skeleton.Hinge = s_Across * skeleton.Hinge;
            skeleton.SpanAxis = s_Across * skeleton.SpanAxis;
            return TestWings.Bake(skeleton, surface, 64);
        }
    }
}
