using System;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>Wings of which the first vertices alone are deformed.</summary>
    public sealed unsafe class SmallerSkinLaws : RigFixture
    {
        private const int k_First = 90;

        [Test]
        public void TheFirstVertices_AreWhereTheyWouldBe_AndTheOthersStay(
            [Values(nameof(VertexPacking.None), nameof(VertexPacking.Normals), nameof(VertexPacking.NormalsAndTangents))] string kind)
        {
            var packing = (VertexPacking)Enum.Parse(typeof(VertexPacking), kind);
            WingRig rig = Rig(k_First);
            using (var world = new WingWorld())
            {
                WingHandle whole = world.Add(rig, WingParameters.Default, default, default, packing, true);
                WingHandle smaller = world.Add(rig, WingParameters.Default, default, default, packing, true);
                world.SetSmaller(smaller, true);
                for (int picture = 0; picture < 3; picture++)
                {
                    Advance(world, whole, smaller);
                    for (int v = 0; v < k_First; v++)
                        Assert.That(Vertex(world, smaller, v, packing), Is.EqualTo(Vertex(world, whole, v, packing)));
                }

                int left = 0;
                for (int v = k_First; v < rig.VertexCount; v++)
                    left += Vertex(world, smaller, v, packing).position.Equals(float3.zero) ? 1 : 0;
                Assert.That(left, Is.GreaterThanOrEqualTo(rig.VertexCount - k_First - 3 * rig.CellCount), "all but the last in a quad");

                world.SetSmaller(smaller, false);
                Advance(world, whole, smaller);
                for (int v = 0; v < rig.VertexCount; v++)
                {
                    Assert.That(Vertex(world, smaller, v, packing), Is.EqualTo(Vertex(world, whole, v, packing)));
                    Assert.That(world.Displacements(smaller)[v], Is.EqualTo(default(VertexDisplacement)), "no last place");
                }
            }
        }

        // Quads and cells that hold other vertices alone are left out.
        [Test]
        public void FewQuadsHoldTheFirstVertices([Values(1, 7, k_First, 324, 325)] int first)
        {
            RigView view = Rig(first).View;
            int quads = 0;
            bool[] held = new bool[view.vertexCount];
            for (int cell = 0; cell < view.cellCount; cell++)
            {
                SkinCell run = view.skinCells[cell];
                Assert.That(run.smallerQuads, Is.LessThanOrEqualTo(run.quadCount));
                quads += run.smallerQuads;
                for (int quad = run.firstQuad; quad < run.firstQuad + run.smallerQuads; quad++)
                {
                    for (int lane = 0; lane < 4; lane++)
                        held[view.skinQuads[quad].target[lane]] = true;
                }
            }

            Assert.That(Array.TrueForAll(held[..first], one => one), "each of the first");
            Assert.That(quads, Is.LessThanOrEqualTo(first / 4 + view.cellCount));
            Assert.That(quads, Is.LessThanOrEqualTo(first));
        }

        [Test]
        public void WithoutASmallerMesh_AllAreHeld()
        {
            RigView view = Rig(0).View;
            for (int cell = 0; cell < view.cellCount; cell++)
                Assert.That(view.skinCells[cell].smallerQuads, Is.EqualTo(view.skinCells[cell].quadCount));
        }

        private WingRig Rig(int first)
        {
            SurfaceMesh surface = TestWings.Ellipse(24, 12);
            surface.tangents = Array.ConvertAll(surface.positions, _ => new Vector4(1f, 0f, 0f, -1f));
            return Keep(WingRig.Bake(TestWings.Fan(), surface, new WingRigSettings { patchCount = 64, smallerVertices = first }));
        }

        private static void Advance(WingWorld world, WingHandle whole, WingHandle smaller)
        {
            world.Step(0.02f);
            world.Skin();
            Bounds all = world.Bounds(whole), some = world.Bounds(smaller);
            all.Expand(1e-5f);
            Assert.That(all.Contains(some.min) && all.Contains(some.max));
            Assert.That(some.size.magnitude, Is.GreaterThan(0.1f).And.LessThan(1.5f));
        }

        private static (float3 position, float4 rest) Vertex(WingWorld world, WingHandle wing, int v, VertexPacking packing)
        {
            switch (packing)
            {
                case VertexPacking.None:
                    SkinnedVertex vertex = world.Vertices(wing)[v];
                    return (vertex.position, new float4(vertex.normal, math.csum(world.Tangents(wing)[v])));
                case VertexPacking.Normals:
                    return (world.PackedVertices(wing)[v].position, world.PackedVertices(wing)[v].normal);
                default:
                    return (world.PackedVertices(wing)[v].position, new float4(
                        world.PackedVertices(wing)[v].normal, world.PackedTangents(wing)[v], 0f, 0f));
            }
        }
    }
}
