using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using Alate.Cli.Flights;
using Alate.Cli.Gltf;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Cli
{
    /// <summary>What a viewer shows of the 3D file.</summary>
    public sealed class GlbPlaybackTests
    {
        private const string k_Right = "wing right", k_Left = "wing left", k_Body = "body";

        private byte[] m_Bytes;
        private GlbFile m_File;

        [OneTimeSetUp]
        public void Write()
        {
            using var stream = new MemoryStream();
            WingsGlb.Write(MonarchFlight.Level, stream);
            m_Bytes = stream.ToArray();
            m_File = new GlbFile(m_Bytes);
        }

        [Test]
        public void TheFile_StaysSmall_AndNothingInItOverlapsOrIsWasted()
        {
            int end = 0;
            foreach (JsonElement view in m_File.Root.GetProperty("bufferViews").EnumerateArray())
            {
                int offset = view.GetProperty("byteOffset").GetInt32();
                Assert.That(offset - end, Is.InRange(0, 3));
                end = offset + view.GetProperty("byteLength").GetInt32();
            }

            Assert.That(m_File.Root.GetProperty("buffers")[0].GetProperty("byteLength").GetInt32() - end, Is.InRange(0, 3));
            Assert.That(m_Bytes, Has.Length.LessThan(1_500_000));
        }

        [Test]
        public void Played_TheWingsAreWhereTheFlightHadThem([Values(0.0, 1.0 / 3.0, 0.71, 1.0)] double share)
        {
            foreach (RecordedWing wing in MonarchFlight.Level.Wings)
            {
                var flown = new float3[wing.Rest.Length];
                wing.At(share, flown, new float3[flown.Length]);

                float3[] played = Played(wing.Placement.IsLeft ? k_Left : k_Right, share);

                for (int k = 0; k < flown.Length; k++)
                    Assert.That(math.distance(played[k], flown[k] * new float3(-1f, 1f, 1f)), Is.LessThan(1e-3f * wing.Placement.Length));
            }
        }

        [Test]
        public void Played_TheWingsBeat()
        {
            float[] heights = Enumerable.Range(0, 24).Select(key => Played(k_Right, key / 24.0).Average(place => place.y)).ToArray();

            Assert.That(heights.Max() - heights.Min(), Is.GreaterThan(0.02f), "metres");
        }

        [Test]
        public void EveryKeyFrame_HasUnitNormals([Values(k_Right, k_Left)] string node)
        {
            float3[] normals = Normals(Primitive(node).GetProperty("attributes"));
            foreach (JsonElement target in Primitive(node).GetProperty("targets").EnumerateArray())
            {
                float3[] change = Normals(target);
                Assert.That(normals.Select((normal, k) => math.length(normal + change[k])), Is.All.EqualTo(1f).Within(1e-5f));
            }
        }

        [Test]
        public void OneAnimation_MovesBothWingsAndNothingElse()
        {
            JsonElement[] nodes = m_File.Root.GetProperty("nodes").EnumerateArray().ToArray();
            JsonElement beat = m_File.Root.GetProperty("animations").EnumerateArray().Single();
            IEnumerable<string> moved = beat.GetProperty("channels").EnumerateArray()
                .Select(channel => nodes[channel.GetProperty("target").GetProperty("node").GetInt32()].GetProperty("name").GetString());

            Assert.That(beat.GetProperty("name").GetString(), Is.EqualTo("beat"));
            Assert.That(moved, Is.EquivalentTo(new[] { k_Right, k_Left }));
        }

        [Test]
        public void TheInsect_IsSymmetric_LifeSize_AndLooksAhead()
        {
            float3[] right = Positions(Primitive(k_Right).GetProperty("attributes")), left = Positions(Primitive(k_Left).GetProperty("attributes"));
            float3[] body = Positions(Primitive(k_Body).GetProperty("attributes"));

            Assert.That(right.Zip(left, (one, other) => math.distance(one, other * new float3(-1f, 1f, 1f))), Is.All.LessThan(1e-6f));
            Assert.That(right.Max(place => math.length(place)), Is.InRange(0.05f, 0.075f), "a wing is 61 mm long");
            Assert.That(-body.Min(place => place.z), Is.GreaterThan(body.Max(place => place.z)), "the abdomen trails");
        }

        [Test]
        public void ThePaint_IsTheMonarchsOrange_OnAWhiteMaterialSeenFromBothSides()
        {
            JsonElement primitive = Primitive(k_Right), material = m_File.Root.GetProperty("materials")[primitive.GetProperty("material").GetInt32()];
            int colours = primitive.GetProperty("attributes").GetProperty("COLOR_0").GetInt32(), vertices = m_File.Count(colours);
            uint[] halves = m_File.Halves(colours);
            int orange = Enumerable.Range(0, vertices).Count(k => halves[4 * k] > 0x8000 && halves[4 * k + 2] < 0x1800);

            Assert.That(m_File.Accessor(colours).GetProperty("type").GetString(), Is.EqualTo("VEC4"));
            Assert.That(orange, Is.GreaterThan(vertices / 5));
            Assert.That(Enumerable.Range(0, vertices).Select(k => halves[4 * k + 3]), Is.All.EqualTo(0xFFFF), "opaque");
            Assert.That(material.GetProperty("doubleSided").GetBoolean(), Is.True);
            Assert.That(
                material.GetProperty("pbrMetallicRoughness").GetProperty("baseColorFactor").EnumerateArray().Select(part => part.GetDouble()),
                Is.All.EqualTo(1.0));
        }

        // As a viewer plays it: weights between two keys in a straight line, then shape = base + Σ weight · difference.
        private float3[] Played(string node, double share)
        {
            JsonElement sampler = m_File.Root.GetProperty("animations")[0].GetProperty("samplers")[0];
            float[] times = m_File.Floats(sampler.GetProperty("input").GetInt32()), weights = m_File.Floats(sampler.GetProperty("output").GetInt32());
            JsonElement[] targets = Primitive(node).GetProperty("targets").EnumerateArray().ToArray();
            double time = share * times[times.Length - 1];
            int after = Math.Max(1, Array.FindIndex(times, key => key >= time));
            double passed = (time - times[after - 1]) / (times[after] - times[after - 1]);
            float3[] shape = Positions(Primitive(node).GetProperty("attributes"));
            for (int target = 0; target < targets.Length; target++)
            {
                double before = weights[(after - 1) * targets.Length + target];
                float weight = (float)(before + passed * (weights[after * targets.Length + target] - before));
                if (weight == 0f)
                    continue;
                float3[] change = Positions(targets[target]);
                for (int k = 0; k < shape.Length; k++)
                    shape[k] += weight * change[k];
            }

            return shape;
        }

        private JsonElement Primitive(string name) => m_File.Root.GetProperty("meshes").EnumerateArray()
            .Single(mesh => mesh.GetProperty("name").GetString() == name).GetProperty("primitives")[0];

        private float3[] Positions(JsonElement attributes) => m_File.Vectors(attributes.GetProperty("POSITION").GetInt32());

        private float3[] Normals(JsonElement attributes) => m_File.Vectors(attributes.GetProperty("NORMAL").GetInt32());
    }
}
