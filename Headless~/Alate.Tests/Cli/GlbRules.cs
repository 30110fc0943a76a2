using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Cli
{
    /// <summary>Rules of glTF 2.0 for nodes, meshes and animations.</summary>
    internal static class GlbRules
    {
        private const int k_ArrayBuffer = 34962, k_ElementArrayBuffer = 34963;

        /// <summary>The nodes are a tree under the scene, and refer to meshes that there are.</summary>
        public static void AssertNodes(GlbFile glb)
        {
            JsonElement nodes = glb.Root.GetProperty("nodes");
            var reached = new List<int>();
            foreach (JsonElement node in glb.Root.GetProperty("scenes")[glb.Root.GetProperty("scene").GetInt32()].GetProperty("nodes").EnumerateArray())
                Reach(nodes, node.GetInt32(), reached);
            Assert.That(reached, Is.EquivalentTo(Enumerable.Range(0, nodes.GetArrayLength())), "each node has one parent");
            int[] meshes = nodes.EnumerateArray().Where(node => node.TryGetProperty("mesh", out _)).Select(node => node.GetProperty("mesh").GetInt32()).ToArray();
            Assert.That(meshes, Is.EquivalentTo(Enumerable.Range(0, glb.Root.GetProperty("meshes").GetArrayLength())), "each mesh is used");
        }

        /// <summary>Attributes, targets, indices and winding of a mesh.</summary>
        public static void AssertMesh(GlbFile glb, JsonElement mesh)
        {
            JsonElement primitive = mesh.GetProperty("primitives")[0], attributes = primitive.GetProperty("attributes");
            int position = attributes.GetProperty("POSITION").GetInt32(), vertices = glb.Count(position);
            foreach (JsonProperty attribute in attributes.EnumerateObject())
                AssertAttribute(glb, attribute.Value.GetInt32(), vertices);
            AssertUnit(glb.Vectors(attributes.GetProperty("NORMAL").GetInt32()));
            AssertIndices(glb, primitive.GetProperty("indices").GetInt32(), vertices);
            Assert.That(primitive.GetProperty("mode").GetInt32(), Is.EqualTo(4), "triangles");
            Assert.That(primitive.GetProperty("material").GetInt32(), Is.LessThan(glb.Root.GetProperty("materials").GetArrayLength()));
            if (attributes.TryGetProperty("COLOR_0", out JsonElement colour))
                Assert.That(glb.Accessor(colour.GetInt32()).GetProperty("normalized").GetBoolean(), Is.True);
            if (!primitive.TryGetProperty("targets", out JsonElement targets))
                return;
            Assert.That(mesh.GetProperty("weights").GetArrayLength(), Is.EqualTo(targets.GetArrayLength()));
            foreach (JsonElement target in targets.EnumerateArray())
            {
                Assert.That(target.EnumerateObject().Select(attribute => attribute.Name), Is.EquivalentTo(new[] { "POSITION", "NORMAL" }));
                AssertAttribute(glb, target.GetProperty("POSITION").GetInt32(), vertices);
                AssertAttribute(glb, target.GetProperty("NORMAL").GetInt32(), vertices);
            }
        }

        /// <summary>Times that rise from nought, weights for each target, a channel for each animated mesh, and an end like the beginning.</summary>
        public static void AssertAnimation(GlbFile glb, JsonElement animation)
        {
            foreach (JsonElement channel in animation.GetProperty("channels").EnumerateArray())
            {
                JsonElement sampler = animation.GetProperty("samplers")[channel.GetProperty("sampler").GetInt32()];
                JsonElement target = channel.GetProperty("target");
                Assert.That(target.GetProperty("path").GetString(), Is.EqualTo("weights"));
                Assert.That(sampler.GetProperty("interpolation").GetString(), Is.EqualTo("LINEAR").Or.EqualTo("STEP"));
                int targets = Targets(glb, target.GetProperty("node").GetInt32());
                float[] times = glb.Floats(sampler.GetProperty("input").GetInt32()), weights = glb.Floats(sampler.GetProperty("output").GetInt32());
                Assert.That(times[0], Is.Zero);
                Assert.That(times, Is.Ordered.Ascending);
                Assert.That(times, Is.Unique);
                Assert.That(weights, Has.Length.EqualTo(times.Length * targets));
                Assert.That(weights.Skip(weights.Length - targets), Is.EqualTo(weights.Take(targets)), "the loop has no seam");
            }
        }

        private static int Targets(GlbFile glb, int node)
        {
            int mesh = glb.Root.GetProperty("nodes")[node].GetProperty("mesh").GetInt32();
            return glb.Root.GetProperty("meshes")[mesh].GetProperty("primitives")[0].GetProperty("targets").GetArrayLength();
        }

        private static void Reach(JsonElement nodes, int node, List<int> reached)
        {
            reached.Add(node);
            if (!nodes[node].TryGetProperty("children", out JsonElement children))
                return;
            foreach (JsonElement child in children.EnumerateArray())
                Reach(nodes, child.GetInt32(), reached);
        }

        private static void AssertAttribute(GlbFile glb, int accessor, int vertices)
        {
            Assert.That(glb.Count(accessor), Is.EqualTo(vertices));
            Assert.That(glb.View(accessor).GetProperty("target").GetInt32(), Is.EqualTo(k_ArrayBuffer));
        }

        private static void AssertUnit(float3[] normals) => Assert.That(normals.Max(normal => math.abs(math.length(normal) - 1f)), Is.LessThan(1e-5f));

        private static void AssertIndices(GlbFile glb, int accessor, int vertices)
        {
            uint[] indices = glb.Indices(accessor);
            Assert.That(indices.Length % 3, Is.Zero);
            Assert.That(indices.Max(), Is.LessThan((uint)vertices));
            Assert.That(indices.Max(), Is.LessThan(glb.ComponentSize(accessor) == 2 ? ushort.MaxValue : uint.MaxValue), "the largest is reserved");
            Assert.That(glb.View(accessor).GetProperty("target").GetInt32(), Is.EqualTo(k_ElementArrayBuffer));
        }
    }
}
