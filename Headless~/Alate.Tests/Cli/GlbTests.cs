using System;
using System.IO;
using System.Linq;
using System.Text.Json;
using Alate.Cli.Flights;
using Alate.Cli.Gltf;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Cli
{
    /// <summary>The 3D file of a flight.</summary>
    public sealed class GlbTests
    {
        private FlightRecord m_Flight;
        private byte[] m_Bytes;
        private GlbFile m_Glb;

        [OneTimeSetUp]
        public void FlyAMonarch()
        {
            var plan = new FlightPlan { Species = "monarch", Seconds = 0.2 };
            using (var flight = new Flight(plan, Insect.Of(plan)))
                m_Flight = flight.Run(_ => { });
            var stream = new MemoryStream();
            WingsGlb.Write(m_Flight, stream);
            m_Bytes = stream.ToArray();
            m_Glb = new GlbFile(m_Bytes);
        }

        [Test]
        public void File_IsValid() => m_Glb.AssertValid();

        [Test]
        public void Animation_LastsOneBeat()
        {
            JsonElement sampler = m_Glb.Root.GetProperty("animations")[0].GetProperty("samplers")[0];

            float[] times = m_Glb.Floats(sampler.GetProperty("input").GetInt32());

            Assert.That(times.Last(), Is.EqualTo(1f / m_Flight.Wings[0].Frequency).Within(1e-6f));
        }

        [Test]
        public void KeyFrames_AreTheRecordedShapes_InARightHandedSpace([Values("wing right", "wing left")] string name)
        {
            JsonElement mesh = Mesh(name), primitive = mesh.GetProperty("primitives")[0];
            RecordedWing wing = m_Flight.Wings.Single(w => w.Placement.IsLeft == name.EndsWith("left"));
            float3[] shape = m_Glb.Vectors(primitive.GetProperty("attributes").GetProperty("POSITION").GetInt32());
            int keys = primitive.GetProperty("targets").GetArrayLength() + 1;
            var expected = new float3[shape.Length];
            for (int key = 0; key < keys; key++)
            {
                wing.At((double)key / keys, expected, new float3[shape.Length]);
                float3[] moved = key == 0 ? new float3[shape.Length] : m_Glb.Vectors(primitive.GetProperty("targets")[key - 1].GetProperty("POSITION").GetInt32());
                for (int k = 0; k < shape.Length; k++)
                    Assert.That(math.distance(shape[k] + moved[k], expected[k] * new float3(-1f, 1f, 1f)), Is.LessThan(1e-7f));
            }

            Assert.That(keys, Is.EqualTo(24));
        }

        [Test]
        public void Triangles_FaceWhereTheirNormalsPoint([Values("wing right", "wing left", "body")] string name)
        {
            JsonElement primitive = Mesh(name).GetProperty("primitives")[0], attributes = primitive.GetProperty("attributes");
            float3[] positions = m_Glb.Vectors(attributes.GetProperty("POSITION").GetInt32());
            float3[] normals = m_Glb.Vectors(attributes.GetProperty("NORMAL").GetInt32());
            uint[] indices = m_Glb.Indices(primitive.GetProperty("indices").GetInt32());

            for (int k = 0; k < indices.Length; k += 3)
            {
                float3 a = positions[indices[k]], b = positions[indices[k + 1]], c = positions[indices[k + 2]];
                float3 doubledArea = math.cross(b - a, c - a);
                if (math.length(doubledArea) > 1e-12f)
                    Assert.That(math.dot(doubledArea, normals[indices[k]] + normals[indices[k + 1]] + normals[indices[k + 2]]), Is.GreaterThan(0f));
            }
        }

        [Test]
        public void RightWing_LiesOnTheRightOfAnInsectThatFacesAhead()
        {
            JsonElement primitive = Mesh("wing right").GetProperty("primitives")[0];

            float3[] positions = m_Glb.Vectors(primitive.GetProperty("attributes").GetProperty("POSITION").GetInt32());

            Assert.That(positions.Average(position => position.x), Is.LessThan(0f), "in a right-handed space the right of +Z is −X");
        }

        [Test]
        public void StrictReader_SeesPlantedFaults()
        {
            AssertSeen(bytes => bytes[8]++, "the length");
            AssertSeen(bytes => bytes[4] = 1, "the version");
            AssertSeen(bytes => Array.Copy(BitConverter.GetBytes(1e6f), 0, bytes, 28 + BitConverter.ToInt32(bytes, 12), 4), "a position beyond its bounds");
            AssertSeen(bytes => Replace(bytes, "\"path\":\"weights\"", "\"path\":\"scaling\""), "an unknown path");
        }

        private static void Replace(byte[] bytes, string old, string fresh)
        {
            int at = Enumerable.Range(0, bytes.Length).First(k => old.Select((c, i) => bytes[k + i] == c).All(same => same));
            for (int k = 0; k < fresh.Length; k++)
                bytes[at + k] = (byte)fresh[k];
        }

        private void AssertSeen(Action<byte[]> fault, string what)
        {
            var bytes = (byte[])m_Bytes.Clone();
            fault(bytes);
            using (new NUnit.Framework.Internal.TestExecutionContext.IsolatedContext())
                Assert.That(() => new GlbFile(bytes).AssertValid(), Throws.InstanceOf<AssertionException>(), what);
        }

        private JsonElement Mesh(string name) =>
            m_Glb.Root.GetProperty("meshes").EnumerateArray().Single(mesh => mesh.GetProperty("name").GetString() == name);
    }
}
