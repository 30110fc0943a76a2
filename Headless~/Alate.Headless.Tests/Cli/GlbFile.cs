using System;
using System.IO;
using System.Linq;
using System.Text.Json;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Cli
{
    /// <summary>
    /// A strict reader of binary glTF 2.0, written from the specification alone: it fails the test on anything that a lenient
    /// viewer would pass over.
    /// </summary>
    internal sealed class GlbFile
    {
        private readonly byte[] m_Binary;

        public GlbFile(byte[] file)
        {
            using var reader = new BinaryReader(new MemoryStream(file));
            Assert.That(reader.ReadUInt32(), Is.EqualTo(0x46546C67u), "the magic word, 'glTF'");
            Assert.That(reader.ReadUInt32(), Is.EqualTo(2u), "the version");
            Assert.That(reader.ReadUInt32(), Is.EqualTo((uint)file.Length), "the length in the header");
            byte[] json = Chunk(reader, 0x4E4F534A);
            Assert.That(json[0], Is.EqualTo((byte)'{'), "no byte order mark");
            Root = JsonDocument.Parse(json).RootElement;
            m_Binary = Chunk(reader, 0x004E4942);
            Assert.That(reader.BaseStream.Position, Is.EqualTo(file.Length), "nothing behind the two chunks");

            int declared = Root.GetProperty("buffers")[0].GetProperty("byteLength").GetInt32();
            Assert.That(Root.GetProperty("buffers").GetArrayLength(), Is.EqualTo(1));
            Assert.That(m_Binary.Length - declared, Is.InRange(0, 3), "the chunk is the buffer and its padding");
        }

        public JsonElement Root { get; }

        public int AccessorCount => Root.GetProperty("accessors").GetArrayLength();

        /// <summary>The bytes of an image.</summary>
        public ReadOnlySpan<byte> Image(int index)
        {
            JsonElement view = Root.GetProperty("bufferViews")[Root.GetProperty("images")[index].GetProperty("bufferView").GetInt32()];
            return m_Binary.AsSpan(Number(view, "byteOffset"), view.GetProperty("byteLength").GetInt32());
        }

        public JsonElement Accessor(int index) => Root.GetProperty("accessors")[index];

        /// <summary>The numbers of an accessor, element by element; normalised integers as 0 to 1.</summary>
        public double[] Read(int index)
        {
            JsonElement accessor = Accessor(index), view = Root.GetProperty("bufferViews")[accessor.GetProperty("bufferView").GetInt32()];
            int type = accessor.GetProperty("componentType").GetInt32(), size = Size(type);
            int components = accessor.GetProperty("type").GetString() switch
            {
                "SCALAR" => 1,
                "VEC2" => 2,
                "VEC3" => 3,
                "VEC4" => 4,
                "MAT4" => 16,
                _ => 0,
            };
            int viewOffset = Number(view, "byteOffset"), offset = viewOffset + Number(accessor, "byteOffset");
            int stride = view.TryGetProperty("byteStride", out JsonElement given) ? given.GetInt32() : components * size;
            int count = accessor.GetProperty("count").GetInt32();
            bool isVertexData = view.TryGetProperty("target", out JsonElement target) && target.GetInt32() == 34962;

            Assert.That(view.GetProperty("buffer").GetInt32(), Is.EqualTo(0));
            Assert.That(components, Is.GreaterThan(0), "a known type");
            Assert.That(count, Is.GreaterThan(0));
            Assert.That(offset % size, Is.EqualTo(0), "aligned to its component");
            Assert.That(isVertexData ? offset % 4 + stride % 4 : 0, Is.EqualTo(0), "vertices are aligned to four bytes");
            int viewEnd = viewOffset + view.GetProperty("byteLength").GetInt32();
            Assert.That(offset + (count - 1) * stride + components * size, Is.LessThanOrEqualTo(viewEnd), "within its view");
            Assert.That(viewEnd, Is.LessThanOrEqualTo(m_Binary.Length), "within the buffer");

            bool isNormalised = accessor.TryGetProperty("normalized", out JsonElement flag) && flag.GetBoolean();
            double[] numbers = new double[count * components];
            for (int k = 0; k < numbers.Length; k++)
                numbers[k] = Component(type, offset + k / components * stride + k % components * size, isNormalised);
            return numbers;
        }

        /// <summary>The vectors of an accessor of three floats.</summary>
        public float3[] ReadVectors(int index)
        {
            Assert.That(Accessor(index).GetProperty("type").GetString(), Is.EqualTo("VEC3"));
            Assert.That(Accessor(index).GetProperty("componentType").GetInt32(), Is.EqualTo(5126));
            double[] numbers = Read(index);
            return Enumerable.Range(0, numbers.Length / 3)
                .Select(k => new float3((float)numbers[3 * k], (float)numbers[3 * k + 1], (float)numbers[3 * k + 2])).ToArray();
        }

        /// <summary>The only primitive of the mesh of the node of this name.</summary>
        public JsonElement Primitive(string node)
        {
            JsonElement mesh = Root.GetProperty("meshes")[Node(node).GetProperty("mesh").GetInt32()];
            return mesh.GetProperty("primitives").EnumerateArray().Single();
        }

        /// <summary>The node of this name.</summary>
        public JsonElement Node(string name) => Root.GetProperty("nodes").EnumerateArray()
            .Single(candidate => candidate.GetProperty("name").GetString() == name);

        private double Component(int type, int at, bool isNormalised)
        {
            switch (type)
            {
                case 5121:
                    return m_Binary[at] / (isNormalised ? 255.0 : 1.0);
                case 5123:
                    return BitConverter.ToUInt16(m_Binary, at) / (isNormalised ? 65535.0 : 1.0);
                case 5125:
                    return BitConverter.ToUInt32(m_Binary, at);
                default:
                    return BitConverter.ToSingle(m_Binary, at);
            }
        }

        private static int Size(int type)
        {
            Assert.That(type, Is.AnyOf(5121, 5123, 5125, 5126), "a component type of glTF that Alate writes");
            return type == 5121 ? 1 : type == 5123 ? 2 : 4;
        }

        private static byte[] Chunk(BinaryReader reader, uint type)
        {
            Assert.That(reader.BaseStream.Position % 4, Is.EqualTo(0), "chunks begin on four bytes");
            uint length = reader.ReadUInt32();
            Assert.That(length % 4, Is.EqualTo(0), "chunks are padded to four bytes");
            Assert.That(reader.ReadUInt32(), Is.EqualTo(type), "JSON first, then the buffer");
            byte[] content = reader.ReadBytes((int)length);
            Assert.That(content, Has.Length.EqualTo((int)length));
            return content;
        }

        private static int Number(JsonElement element, string name) =>
            element.TryGetProperty(name, out JsonElement number) ? number.GetInt32() : 0;
    }
}
