using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using Alate.Catalogue;
using Alate.Cli;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;
using Unity.StandIns;

namespace Alate.Tests.Cli
{
    public sealed class WingsGlbTests
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
        public void TheFile_SaysWhatItIs_AndStaysSmall()
        {
            JsonElement asset = m_File.Root.GetProperty("asset");

            Assert.That(asset.GetProperty("version").GetString(), Is.EqualTo("2.0"));
            Assert.That(asset.GetProperty("generator").GetString(), Does.StartWith("Alate"));
            Assert.That(m_Bytes, Has.Length.LessThan(2_000_000));
        }

        [Test]
        public void EveryAccessor_LiesInTheBuffer_AndItsBoundsAreTrue()
        {
            for (int index = 0; index < m_File.AccessorCount; index++)
            {
                double[] numbers = m_File.Read(index);
                JsonElement accessor = m_File.Accessor(index);
                Assert.That(numbers.All(number => number is >= -1e6 and <= 1e6), $"accessor {index} is finite");
                if (!accessor.TryGetProperty("min", out JsonElement min))
                    continue;
                int components = min.GetArrayLength();
                for (int c = 0; c < components; c++)
                {
                    IEnumerable<double> column = numbers.Where((_, k) => k % components == c);
                    Assert.That((double)min[c].GetSingle(), Is.EqualTo(column.Min()), $"min of accessor {index}");
                    Assert.That((double)accessor.GetProperty("max")[c].GetSingle(), Is.EqualTo(column.Max()), $"max of accessor {index}");
                }
            }
        }

        [Test]
        public void ViewsDoNotOverlap_AndFillTheBuffer()
        {
            int end = 0;
            foreach (JsonElement view in m_File.Root.GetProperty("bufferViews").EnumerateArray())
            {
                int offset = view.GetProperty("byteOffset").GetInt32();
                Assert.That(offset - end, Is.InRange(0, 3));
                end = offset + view.GetProperty("byteLength").GetInt32();
            }

            Assert.That(m_File.Root.GetProperty("buffers")[0].GetProperty("byteLength").GetInt32() - end, Is.InRange(0, 3));
        }

        [Test]
        public void ThePositions_OfShapesAndOfTheirDifferences_HaveBounds()
        {
            foreach (JsonElement attributes in Shapes(k_Right).Concat(Shapes(k_Left)).Concat(Shapes(k_Body)))
            {
                JsonElement accessor = m_File.Accessor(attributes.GetProperty("POSITION").GetInt32());
                Assert.That(accessor.GetProperty("min").GetArrayLength(), Is.EqualTo(3));
                Assert.That(accessor.GetProperty("max").GetArrayLength(), Is.EqualTo(3));
            }
        }

        [TestCase(k_Right)]
        [TestCase(k_Left)]
        [TestCase(k_Body)]
        public void AllAttributes_HaveOneEntryAVertex_AndIndicesStayWithin(string node)
        {
            JsonElement primitive = m_File.Primitive(node);
            int vertices = Positions(primitive.GetProperty("attributes")).Length;
            foreach (JsonElement shape in Shapes(node))
            {
                foreach (JsonProperty attribute in shape.EnumerateObject())
                    Assert.That(Count(attribute.Value), Is.EqualTo(vertices), attribute.Name);
            }

            Assert.That(m_File.Read(primitive.GetProperty("indices").GetInt32()), Is.All.InRange(0, vertices - 1));
            Assert.That(m_File.Accessor(primitive.GetProperty("indices").GetInt32()).GetProperty("count").GetInt32() % 3, Is.EqualTo(0));
        }

        [TestCase(k_Right)]
        [TestCase(k_Left)]
        [TestCase(k_Body)]
        public void Triangles_TurnTheSideToTheViewerThatTheirNormalsPointTo(string node)
        {
            JsonElement primitive = m_File.Primitive(node);
            float3[] positions = Positions(primitive.GetProperty("attributes")), normals = Normals(primitive.GetProperty("attributes"));
            int[] corners = Array.ConvertAll(m_File.Read(primitive.GetProperty("indices").GetInt32()), index => (int)index);
            int agreeing = 0;
            for (int k = 0; k < corners.Length; k += 3)
            {
                float3 origin = positions[corners[k]];
                float3 face = math.cross(positions[corners[k + 1]] - origin, positions[corners[k + 2]] - origin);
                agreeing += math.dot(face, normals[corners[k]] + normals[corners[k + 1]] + normals[corners[k + 2]]) > 0f ? 1 : 0;
            }

            // Hairs have partly the normals of the skin they lie on; their feet and undersides turn away from it.
            Assert.That(agreeing, Is.GreaterThan((node == k_Body ? 0.93 : 0.99) * corners.Length / 3));
        }

        [TestCase(k_Right)]
        [TestCase(k_Left)]
        public void EveryShape_HasUnitNormals(string node)
        {
            JsonElement primitive = m_File.Primitive(node);
            float3[] normals = Normals(primitive.GetProperty("attributes"));
            Assert.That(normals.Select(normal => math.length(normal)), Is.All.EqualTo(1f).Within(1e-5f));
            foreach (JsonElement target in primitive.GetProperty("targets").EnumerateArray())
                Assert.That(Normals(target).Select((change, k) => math.length(normals[k] + change)), Is.All.EqualTo(1f).Within(1e-5f));
        }

        [Test]
        public void TheAbdomen_SwingsOnceABeat_AboutTheAxisAcross()
        {
            JsonElement animation = m_File.Root.GetProperty("animations")[0];
            int node = m_File.Root.GetProperty("nodes").EnumerateArray().ToList()
                .FindIndex(candidate => candidate.GetProperty("name").GetString() == "abdomen");
            JsonElement channel = animation.GetProperty("channels").EnumerateArray()
                .Single(candidate => candidate.GetProperty("target").GetProperty("node").GetInt32() == node);
            JsonElement sampler = animation.GetProperty("samplers")[channel.GetProperty("sampler").GetInt32()];
            double[] times = m_File.Read(sampler.GetProperty("input").GetInt32()),
                turns = m_File.Read(sampler.GetProperty("output").GetInt32());
            BodyEllipsoid abdomen = InsectCatalogue.Find("monarch").Abdomen;

            Assert.That(channel.GetProperty("target").GetProperty("path").GetString(), Is.EqualTo("rotation"));
            Assert.That(turns, Has.Length.EqualTo(4 * times.Length));
            for (int key = 0; key < times.Length; key++)
            {
                // The tail, behind, goes up as Y turns towards Z.
                double up = -abdomen.swing * Math.Cos(2 * Math.PI * times[key] / times[^1] - abdomen.lowestPhase * Math.PI / 180);
                Assert.That(360 / Math.PI * Math.Atan2(turns[4 * key], turns[4 * key + 3]), Is.EqualTo(up).Within(0.01), $"key {key}");
                Assert.That((turns[4 * key + 1], turns[4 * key + 2]), Is.EqualTo((0.0, 0.0)));
            }
        }

        [Test]
        public void TheInsect_FacesAhead_WithItsRightWingOnItsRight_InMetres()
        {
            float3 right = Mean(Positions(m_File.Primitive(k_Right).GetProperty("attributes")));
            float3 left = Mean(Positions(m_File.Primitive(k_Left).GetProperty("attributes")));
            float3[] body = Positions(m_File.Primitive(k_Body).GetProperty("attributes")), tail = Positions(
                m_File.Primitive("abdomen").GetProperty("attributes"));
            float[] hinge = m_File.Node("abdomen").GetProperty("translation").EnumerateArray().Select(value => value.GetSingle()).ToArray();
            body = [.. body, .. tail.Select(place => place + new float3(hinge[0], hinge[1], hinge[2]))];

            // glTF is right-handed and faces +Z, so the right hand lies at −X.
            Assert.That(right.x, Is.InRange(-0.06f, -0.005f));
            Assert.That(math.distance(right, MirrorX(left)), Is.LessThan(1e-6f));
            Assert.That(body.Max(place => place.z) - body.Min(place => place.z), Is.InRange(0.02f, 0.05f), "a monarch is about 3 cm long");
            Assert.That(-body.Min(place => place.z), Is.GreaterThan(body.Max(place => place.z)), "the abdomen trails");
        }

        [Test]
        public void Played_TheWingsAreWhereTheFlightHadThem()
        {
            foreach (RecordedWing wing in MonarchFlight.Level.Wings)
            {
                JsonElement primitive = m_File.Primitive(wing.Placement.IsLeft ? k_Left : k_Right);
                double[] times = Times;
                foreach (double share in new[] { 0.0, 1.0 / 3.0, 0.71, 1.0 })
                {
                    float3[] flown = wing.At(share).Positions;
                    float3[] played = Played(primitive, share * times[times.Length - 1]);
                    for (int k = 0; k < flown.Length; k++)
                        Assert.That(math.distance(played[k], MirrorX(flown[k])), Is.LessThan(6e-5f), $"metres, at {share} of the beat");
                }
            }
        }

        [Test]
        public void TheBeat_LoopsInItsOwnTime()
        {
            JsonElement animation = m_File.Root.GetProperty("animations").EnumerateArray().Single();
            double[] times = Times, weights = Weights;
            int targets = m_File.Primitive(k_Right).GetProperty("targets").GetArrayLength();

            Assert.That(animation.GetProperty("name").GetString(), Is.EqualTo("beat"));
            Assert.That(Sampler.GetProperty("interpolation").GetString(), Is.EqualTo("LINEAR"));
            Assert.That(targets, Is.InRange(11, 48));
            Assert.That(times[0], Is.EqualTo(0.0));
            Assert.That(times, Is.Ordered.Ascending.And.Unique);
            Assert.That(times[times.Length - 1], Is.EqualTo(1.0 / MonarchFlight.Level.Wings[0].Frequency).Within(1e-6));
            Assert.That(weights, Has.Length.EqualTo(times.Length * targets));
            Assert.That(weights, Is.All.InRange(0.0, 1.0));
            Assert.That(weights.Skip(weights.Length - targets), Is.EqualTo(weights.Take(targets)), "the last key is the first one again");
        }

        [Test]
        public void OneAnimation_MovesBothWings()
        {
            JsonElement[] nodes = m_File.Root.GetProperty("nodes").EnumerateArray().ToArray();
            IEnumerable<string> moved = m_File.Root.GetProperty("animations")[0].GetProperty("channels").EnumerateArray()
                .Select(channel => channel.GetProperty("target"))
                .Where(target => target.GetProperty("path").GetString() == "weights")
                .Select(target => nodes[target.GetProperty("node").GetInt32()].GetProperty("name").GetString());

            Assert.That(moved, Is.EquivalentTo(new[] { k_Right, k_Left }));
            foreach (JsonElement mesh in m_File.Root.GetProperty("meshes").EnumerateArray())
            {
                int targets = mesh.GetProperty("primitives")[0].TryGetProperty("targets", out JsonElement list) ? list.GetArrayLength() : 0;
                Assert.That(mesh.TryGetProperty("weights", out JsonElement weights) ? weights.GetArrayLength() : 0, Is.EqualTo(targets));
            }
        }

        [Test]
        public void TheSceneHoldsEveryNodeOnce()
        {
            JsonElement[] nodes = m_File.Root.GetProperty("nodes").EnumerateArray().ToArray();
            var seen = new List<int>();
            JsonElement scene = m_File.Root.GetProperty("scenes")[m_File.Root.GetProperty("scene").GetInt32()];
            var waiting = new Stack<int>(scene.GetProperty("nodes").EnumerateArray().Select(node => node.GetInt32()));
            while (waiting.Count > 0)
            {
                int node = waiting.Pop();
                seen.Add(node);
                if (!nodes[node].TryGetProperty("children", out JsonElement children))
                    continue;
                foreach (JsonElement child in children.EnumerateArray())
                    waiting.Push(child.GetInt32());
            }

            Assert.That(seen, Is.EquivalentTo(Enumerable.Range(0, nodes.Length)));
        }

        [Test]
        public void ThePaint_IsTheMonarchsOrange_OnAWhiteMaterialSeenFromBothSides()
        {
            JsonElement primitive = m_File.Primitive(k_Right);
            double[] places = m_File.Read(primitive.GetProperty("attributes").GetProperty("TEXCOORD_0").GetInt32());
            int vertices = Positions(primitive.GetProperty("attributes")).Length;
            JsonElement material = m_File.Root.GetProperty("materials")[primitive.GetProperty("material").GetInt32()];
            JsonElement light = material.GetProperty("pbrMetallicRoughness");
            PngFile picture = Picture(light.GetProperty("baseColorTexture").GetProperty("index").GetInt32());
            int orange = Enumerable.Range(0, vertices)
                .Select(k => picture.Pixels[(int)(places[2 * k + 1] * (picture.Height - 1)) * picture.Width
                    + (int)(places[2 * k] * (picture.Width - 1))])
                .Count(colour => colour.r > 190 && colour.b < 90);

            Assert.That(orange, Is.GreaterThan(vertices / 5));
            Assert.That(material.GetProperty("doubleSided").GetBoolean(), Is.True);
            Assert.That(light.GetProperty("metallicFactor").GetDouble(), Is.EqualTo(0.0));
            Assert.That(
                light.GetProperty("baseColorFactor").EnumerateArray().Select(part => part.GetDouble()),
                Is.All.EqualTo(1.0));
        }

        private PngFile Picture(int texture)
        {
            JsonElement image = m_File.Root.GetProperty("images")[m_File.Root.GetProperty("textures")[texture]
                .GetProperty("source").GetInt32()];
            JsonElement view = m_File.Root.GetProperty("bufferViews")[image.GetProperty("bufferView").GetInt32()];
            Assert.That(image.GetProperty("mimeType").GetString(), Is.EqualTo("image/png"));
            int json = BitConverter.ToInt32(m_Bytes, 12), binary = 12 + 8 + json + 8;
            return PngFile.Read(
                m_Bytes.AsMemory(binary + view.GetProperty("byteOffset").GetInt32(), view.GetProperty("byteLength").GetInt32()));
        }

        private double[] Times => m_File.Read(Sampler.GetProperty("input").GetInt32());

        private double[] Weights => m_File.Read(Sampler.GetProperty("output").GetInt32());

        private JsonElement Sampler => m_File.Root.GetProperty("animations")[0].GetProperty("samplers")[0];

        private IEnumerable<JsonElement> Shapes(string node)
        {
            JsonElement primitive = m_File.Primitive(node);
            var shapes = new List<JsonElement> { primitive.GetProperty("attributes") };
            if (primitive.TryGetProperty("targets", out JsonElement targets))
                shapes.AddRange(targets.EnumerateArray());
            return shapes;
        }

        // As a viewer plays it: weights between two keys in a straight line, then shape = base + Σ weight · difference.
        private float3[] Played(JsonElement primitive, double time)
        {
            double[] times = Times, weights = Weights;
            JsonElement[] targets = primitive.GetProperty("targets").EnumerateArray().ToArray();
            int after = Math.Max(1, Array.FindIndex(times, key => key >= time));
            double share = (time - times[after - 1]) / (times[after] - times[after - 1]);
            float3[] shape = Positions(primitive.GetProperty("attributes"));
            for (int target = 0; target < targets.Length; target++)
            {
                double before = weights[(after - 1) * targets.Length + target];
                float weight = (float)(before + share * (weights[after * targets.Length + target] - before));
                if (weight == 0f)
                    continue;
                float3[] change = Positions(targets[target]);
                for (int k = 0; k < shape.Length; k++)
                    shape[k] += weight * change[k];
            }

            return shape;
        }

        private float3[] Positions(JsonElement attributes) => m_File.ReadVectors(attributes.GetProperty("POSITION").GetInt32());

        private float3[] Normals(JsonElement attributes) => m_File.ReadVectors(attributes.GetProperty("NORMAL").GetInt32());

        private int Count(JsonElement accessor) => m_File.Accessor(accessor.GetInt32()).GetProperty("count").GetInt32();

        private static float3 MirrorX(float3 place) => new float3(-place.x, place.y, place.z);

        private static float3 Mean(float3[] places) =>
            new float3(places.Average(place => place.x), places.Average(place => place.y), places.Average(place => place.z));
    }
}
