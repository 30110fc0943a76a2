using System;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests
{
    /// <summary>Normals and tangents as signed bytes, as living meshes have them, against the floats that they stand for.</summary>
    public sealed class PackedVertexTests
    {
        /// <summary>Half a step of each of three components of 1 / 127, degrees: 0.39.</summary>
        private static readonly double s_MostDegrees = Math.Asin(0.5 * Math.Sqrt(3.0) / 127.0) * 180.0 / Math.PI;

        [Test]
        public void RandomDirections_TurnByLessThanHalfAStep()
        {
            var random = new Random(73);
            double worst = 0.0;
            for (int k = 0; k < 20000; k++)
            {
                float3 direction = random.NextFloat3Direction();
                float4 packed = SignedBytes.Unpack(SignedBytes.Pack(new SoaFloat3(direction), -1f).y);
                Assert.That(packed.w, Is.EqualTo(-1f));
                worst = Math.Max(worst, Degrees(packed.xyz, direction));
            }

            Assert.That(worst, Is.LessThanOrEqualTo(s_MostDegrees));
        }

        [Test]
        public void EveryByte_IsItsShareOf127_AndTheLowestNoLessThanMinusOne()
        {
            for (int k = -128; k < 128; k++)
            {
                int packed = (k & 255) | (-k & 255) << 8 | (k & 255) << 16 | (-k & 255) << 24;
                float4 unpacked = SignedBytes.Unpack(packed);
                float at = math.max(k / 127f, -1f), opposite = math.max((sbyte)-k / 127f, -1f);
                Assert.That(unpacked, Is.EqualTo(new float4(at, opposite, at, opposite)));
                if (k > -128)
                    Assert.That(SignedBytes.Pack(new SoaFloat3(unpacked.xyz), unpacked.w).x, Is.EqualTo(packed), "and back");
            }
        }

        [Test]
        public void TheAxes_ArePackedExactly()
        {
            var axes = new SoaFloat3(new float4(1f, -1f, 0f, 0f), new float4(0f, 0f, -1f, 1f), new float4(0f, 0f, 0f, 0f));
            int4 packed = SignedBytes.Pack(axes, new float4(0f, 1f, -1f, 0f));
            Assert.That(SignedBytes.Unpack(packed.x), Is.EqualTo(new float4(1f, 0f, 0f, 0f)));
            Assert.That(SignedBytes.Unpack(packed.y), Is.EqualTo(new float4(-1f, 0f, 0f, 1f)));
            Assert.That(SignedBytes.Unpack(packed.z), Is.EqualTo(new float4(0f, -1f, 0f, -1f)));
            Assert.That(SignedBytes.Unpack(packed.w), Is.EqualTo(new float4(0f, 1f, 0f, 0f)));
            Assert.That(SignedBytes.Pack(axes), Is.EqualTo(SignedBytes.Pack(axes, 0f)));
        }

        [Test]
        public void APackedWing_IsTheUnpackedOne_NormalsAndTangentsWithinHalfADegree([Values(1f, 3f)] float normalLength)
        {
            SurfaceMesh surface = TestWings.Ellipse();
            surface.normals = Array.ConvertAll(surface.normals, normal => normal * normalLength);
            surface.tangents = Array.ConvertAll(surface.positions, _ => new Vector4(2f, 0f, 0f, -1f));
            WingRig rig = TestWings.Bake(TestWings.Fan(), surface);
            using (var world = new WingWorld())
            {
                WingHandle plain = world.Add(rig, WingParameters.Default);
                WingHandle packed = world.Add(rig, WingParameters.Default, default, default, VertexPacking.NormalsAndTangents);
                rig.Release();
                world.Step(0.31f / world.Read(plain).Frequency);
                world.Skin();
                NativeArray<SkinnedVertex> floats = world.Vertices(plain);
                NativeArray<PackedVertex> bytes = world.PackedVertices(packed);
                double worst = 0.0;
                for (int v = 0; v < floats.Length; v++)
                {
                    float4 tangent = world.Tangents(plain)[v], short4 = SignedBytes.Unpack(world.PackedTangents(packed)[v]);
                    Assert.That(bytes[v].position, Is.EqualTo(floats[v].position));
                    Assert.That(math.length(floats[v].normal), Is.EqualTo(1f).Within(1e-3f));
                    Assert.That(math.length(tangent.xyz), Is.EqualTo(2f).Within(1e-3f));
                    Assert.That(math.dot(floats[v].normal, tangent.xyz), Is.EqualTo(0f).Within(1e-2f));
                    Assert.That(short4.w, Is.EqualTo(-1f));
                    worst = Math.Max(worst, Degrees(SignedBytes.Unpack(bytes[v].normal).xyz, floats[v].normal));
                    worst = Math.Max(worst, Degrees(short4.xyz, tangent.xyz));
                }

                Assert.That(worst, Is.LessThanOrEqualTo(0.5).And.GreaterThan(0.0));
                Assert.That(Degrees(floats[floats.Length - 1].normal, Vector3.up), Is.GreaterThan(3.0), "the wing has turned");
                Assert.That(world.Bounds(packed), Is.EqualTo(world.Bounds(plain)));
            }
        }

        [Test]
        public void ATangentOfNoLength_IsPackedAsNone_AndASmallOneByItsDirection()
        {
            SurfaceMesh surface = TestWings.Ellipse();
            surface.tangents = new Vector4[surface.positions.Length];
            for (int v = 1; v < surface.tangents.Length; v += 2)
                surface.tangents[v] = new Vector4(1e-10f, 0f, 0f, 1f);
            WingRig rig = TestWings.Bake(TestWings.Fan(), surface);
            using (var world = new WingWorld())
            {
                WingHandle wing = world.Add(rig, WingParameters.Default, default, default, VertexPacking.NormalsAndTangents);
                rig.Release();
                world.Skin();
                for (int v = 0; v < surface.tangents.Length; v++)
                {
                    float4 tangent = SignedBytes.Unpack(world.PackedTangents(wing)[v]);
                    Assert.That(math.length(tangent.xyz), Is.EqualTo(v % 2).Within(0.01f), $"vertex {v}");
                    Assert.That(tangent.w, Is.EqualTo((float)(v % 2)), $"vertex {v}");
                }
            }
        }

        [Test]
        public void WhatIsNotWanted_IsNotComputed([Values(0, 1, 2)] int chosen)
        {
            var packing = (VertexPacking)chosen;
            SurfaceMesh surface = TestWings.Ellipse();
            surface.tangents = Array.ConvertAll(surface.positions, _ => new Vector4(1f, 0f, 0f, -1f));
            WingRig rig = TestWings.Bake(TestWings.Fan(), surface);
            using (var world = new WingWorld())
            {
                WingHandle wing = world.Add(rig, WingParameters.Default, default, default, packing);
                rig.Release();
                world.Skin();
                Assert.That(world.Vertices(wing).IsCreated, Is.EqualTo(packing == VertexPacking.None));
                Assert.That(world.Tangents(wing).IsCreated, Is.EqualTo(packing == VertexPacking.None));
                Assert.That(world.PackedVertices(wing).IsCreated, Is.EqualTo(packing != VertexPacking.None));
                Assert.That(world.PackedTangents(wing).IsCreated, Is.EqualTo(packing == VertexPacking.NormalsAndTangents));
            }
        }

        private static double Degrees(float3 a, float3 b)
        {
            double x = (double)a.y * b.z - (double)a.z * b.y, y = (double)a.z * b.x - (double)a.x * b.z,
                z = (double)a.x * b.y - (double)a.y * b.x;
            double cosine = (double)a.x * b.x + (double)a.y * b.y + (double)a.z * b.z;
            return Math.Atan2(Math.Sqrt(x * x + y * y + z * z), cosine) * 180.0 / Math.PI;
        }
    }
}
