using System;
using System.IO;
using System.Text;
using System.Text.Json.Nodes;
using Alate.Formats;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Cli
{
    /// <summary>The strict reader is strict: it sees faults that are planted into a file that it takes.</summary>
    public sealed class GlbFileTests
    {
        [Test]
        public void SoundFile_IsTaken() => Assert.That(Read(_ => { }), Throws.Nothing);

        [Test]
        public void WrongLength_IsSeen() => Assert.That(Read(file => file[8]++), Throws.InstanceOf<AssertionException>());

        [Test]
        public void WrongVersion_IsSeen() => Assert.That(Read(file => file[4] = 1), Throws.InstanceOf<AssertionException>());

        [Test]
        public void UnpaddedChunk_IsSeen() => Assert.That(Read(file => file[12]++), Throws.InstanceOf<Exception>());

        [Test]
        public void AccessorBeyondItsView_IsSeen() =>
            Assert.That(Read(file => Replace(file, "\"count\":2", "\"count\":9")), Throws.InstanceOf<AssertionException>());

        [Test]
        public void UnalignedView_IsSeen() =>
            Assert.That(Read(file => Replace(file, "\"byteOffset\":0", "\"byteOffset\":2")), Throws.InstanceOf<AssertionException>());

        private static TestDelegate Read(Action<byte[]> fault) => () =>
        {
            byte[] file = Sound();
            fault(file);
            using (new NUnit.Framework.Internal.TestExecutionContext.IsolatedContext())
                new GlbFile(file).ReadVectors(0);
        };

        private static byte[] Sound()
        {
            var buffer = new GlbBuffer();
            buffer.AddVectors(new[] { new float3(1f, 2f, 3f), new float3(4f, 5f, 6f) });
            byte[] binary = buffer.ToArray();
            var gltf = new JsonObject
            {
                ["asset"] = new JsonObject { ["version"] = "2.0" },
                ["accessors"] = buffer.Accessors,
                ["bufferViews"] = buffer.Views,
                ["buffers"] = new JsonArray(new JsonObject { ["byteLength"] = binary.Length }),
            };
            using var stream = new MemoryStream();
            GlbWriter.Write(gltf, binary, stream);
            return stream.ToArray();
        }

        private static void Replace(byte[] file, string old, string fresh)
        {
            int at = Encoding.ASCII.GetString(file).IndexOf(old, StringComparison.Ordinal);
            Assert.That(at, Is.Positive);
            Encoding.ASCII.GetBytes(fresh).CopyTo(file, at);
        }
    }
}
