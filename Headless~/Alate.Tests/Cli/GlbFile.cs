using System;
using System.IO;
using System.Linq;
using System.Text;
using System.Text.Json;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Cli
{
    /// <summary>Reads a GLB file as strictly as the specification of glTF 2.0 has it; asserts where the file departs from it.</summary>
    internal sealed class GlbFile
    {
        private const int k_HeaderLength = 12;

        private readonly byte[] m_Binary;

        public GlbFile(byte[] file)
        {
            Assert.That(BitConverter.ToUInt32(file, 0), Is.EqualTo(0x46546C67), "magic");
            Assert.That(BitConverter.ToUInt32(file, 4), Is.EqualTo(2), "version");
            Assert.That(BitConverter.ToUInt32(file, 8), Is.EqualTo(file.Length), "length");
            int next = k_HeaderLength;
            byte[] json = Chunk(file, "JSON", ref next);
            m_Binary = Chunk(file, "BIN\0", ref next);
            Assert.That(next, Is.EqualTo(file.Length), "two chunks and no more");
            Root = JsonDocument.Parse(json).RootElement;
            Assert.That(Encoding.UTF8.GetString(json).TrimEnd(' '), Does.EndWith("}"), "the JSON is padded with spaces");
        }

        public JsonElement Root { get; }

        public JsonElement Accessor(int index) => Root.GetProperty("accessors")[index];

        /// <summary>Every rule that a viewer may rely on.</summary>
        public void AssertValid()
        {
            Assert.That(Root.GetProperty("asset").GetProperty("version").GetString(), Is.EqualTo("2.0"));
            long length = Root.GetProperty("buffers")[0].GetProperty("byteLength").GetInt64();
            Assert.That(Root.GetProperty("buffers").GetArrayLength(), Is.EqualTo(1));
            Assert.That(m_Binary.Length - length, Is.InRange(0, 3), "the chunk is the buffer and its padding");
            Assert.That(m_Binary.Skip((int)length), Is.All.Zero);
            for (int k = 0; k < Root.GetProperty("accessors").GetArrayLength(); k++)
                AssertAccessor(k);
            GlbRules.AssertNodes(this);
            foreach (JsonElement mesh in Root.GetProperty("meshes").EnumerateArray())
                GlbRules.AssertMesh(this, mesh);
            foreach (JsonElement animation in Root.GetProperty("animations").EnumerateArray())
                GlbRules.AssertAnimation(this, animation);
        }

        public int Count(int accessor) => Accessor(accessor).GetProperty("count").GetInt32();

        public float3[] Vectors(int accessor)
        {
            Assert.That(Accessor(accessor).GetProperty("type").GetString(), Is.EqualTo("VEC3"));
            float[] numbers = Floats(accessor);
            return Enumerable.Range(0, numbers.Length / 3).Select(k => new float3(numbers[3 * k], numbers[3 * k + 1], numbers[3 * k + 2])).ToArray();
        }

        public float[] Floats(int accessor)
        {
            Assert.That(Accessor(accessor).GetProperty("componentType").GetInt32(), Is.EqualTo(5126));
            int offset = Offset(accessor), count = Count(accessor) * Components(accessor);
            return Enumerable.Range(0, count).Select(k => BitConverter.ToSingle(m_Binary, offset + 4 * k)).ToArray();
        }

        public uint[] Indices(int accessor)
        {
            int offset = Offset(accessor), size = ComponentSize(accessor);
            return Enumerable.Range(0, Count(accessor))
                .Select(k => size == 2 ? BitConverter.ToUInt16(m_Binary, offset + 2 * k) : BitConverter.ToUInt32(m_Binary, offset + 4 * k)).ToArray();
        }

        public JsonElement View(int accessor) => Root.GetProperty("bufferViews")[Accessor(accessor).GetProperty("bufferView").GetInt32()];

        public int ComponentSize(int accessor)
        {
            switch (Accessor(accessor).GetProperty("componentType").GetInt32())
            {
                case 5123:
                    return 2;
                case 5125:
                case 5126:
                    return 4;
                default:
                    throw new AssertionException("a component type that this file has no use for");
            }
        }

        private int Components(int accessor) =>
            Accessor(accessor).GetProperty("type").GetString() switch { "SCALAR" => 1, "VEC3" => 3, "VEC4" => 4, _ => 0 };

        private int Offset(int accessor) => View(accessor).GetProperty("byteOffset").GetInt32();

        private void AssertAccessor(int accessor)
        {
            JsonElement view = View(accessor);
            int offset = Offset(accessor), length = view.GetProperty("byteLength").GetInt32();
            int element = ComponentSize(accessor) * Components(accessor);
            Assert.That(Accessor(accessor).TryGetProperty("byteOffset", out _), Is.False, "each accessor begins its view");
            Assert.That(view.TryGetProperty("byteStride", out _), Is.False, "tightly packed");
            Assert.That(element, Is.GreaterThan(0));
            Assert.That(offset % 4, Is.Zero, "aligned");
            Assert.That(Count(accessor), Is.GreaterThan(0));
            Assert.That(length, Is.EqualTo(Count(accessor) * element), "the view holds the accessor and no more");
            Assert.That(offset + length, Is.LessThanOrEqualTo(Root.GetProperty("buffers")[0].GetProperty("byteLength").GetInt32()));
            if (Accessor(accessor).GetProperty("componentType").GetInt32() == 5126)
                AssertBounds(accessor);
        }

        private void AssertBounds(int accessor)
        {
            float[] numbers = Floats(accessor);
            Assert.That(numbers.All(float.IsFinite), "finite");
            int components = Components(accessor);
            for (int c = 0; c < components; c++)
            {
                float[] column = numbers.Where((_, k) => k % components == c).ToArray();
                Assert.That(Accessor(accessor).GetProperty("min")[c].GetSingle(), Is.EqualTo(column.Min()));
                Assert.That(Accessor(accessor).GetProperty("max")[c].GetSingle(), Is.EqualTo(column.Max()));
            }
        }

        private static byte[] Chunk(byte[] file, string type, ref int next)
        {
            int length = (int)BitConverter.ToUInt32(file, next);
            Assert.That(length % 4, Is.Zero, "chunks are padded");
            Assert.That(Encoding.ASCII.GetString(file, next + 4, 4), Is.EqualTo(type));
            byte[] content = file.Skip(next + 8).Take(length).ToArray();
            Assert.That(content, Has.Length.EqualTo(length));
            next += 8 + length;
            return content;
        }
    }
}
