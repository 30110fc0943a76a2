using System;
using Alate.Catalogue;
using NUnit.Framework;
using Unity.Burst.Intrinsics;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests
{
    /// <summary>Vertices skinned eight at a time are those that are skinned four at a time, bit by bit.</summary>
    public sealed unsafe class EightVerticesLaws
    {
        private static readonly string[] s_Species = ["monarch", "fishfly", "painted-lichen-moth"];

        [OneTimeSetUp]
        public void NeedsAvx2()
        {
            if (!X86.Avx2.IsAvx2Supported)
                Assert.Ignore("This processor has no registers of eight lanes.");
        }

        [Test]
        public void Vertices_AndBounds_AreTheSame([ValueSource(nameof(s_Species))] string species, [Values] bool packed)
        {
            var random = new Random(771);
            foreach (WingDefinition wing in InsectCatalogue.Find(species).Wings)
            {
                using var skin = new BothWays(wing, packed);
                for (int pose = 0; pose < 20; pose++)
                {
                    skin.Turn(ref random);
                    skin.Skin(0, skin.Quads);
                    skin.AssertSame($"{wing.Name}, pose {pose}");

                    // As chunks of a large wing, which begin and end in the middle of a cell.
                    int first = random.NextInt(skin.Quads), end = random.NextInt(first, skin.Quads);
                    skin.Skin(first, end);
                    skin.AssertSame($"{wing.Name}, quads {first} to {end}");
                }
            }
        }

        [Test]
        public void AVertexThatIsNoNumber_LeavesTheBounds_OfTheOthers([Values] bool packed)
        {
            var random = new Random(772);
            using var skin = new BothWays(InsectCatalogue.Find("monarch").Wings[0], packed);
            skin.Turn(ref random);
            skin.Break();
            skin.Skin(0, skin.Quads);
            skin.AssertSame("with a joint that is no number");
            Assert.That(math.all(math.isfinite(skin.Bounds.min)) && math.all(math.isfinite(skin.Bounds.max)));
        }

        [Test]
        public void Registers_LieOnLines_WithinTheirRoom_WhereverTheStackIs()
        {
            SoaBounds empty = SoaBounds.Empty;
            byte[] memory = GC.AllocateArray<byte>(EightVertices.Room + 64, pinned: true);
            fixed (byte* start = memory)
            {
                for (int offset = 0; offset < 64; offset++)
                {
                    byte* given = start + offset;
                    byte* placed = (byte*)EightVertices.Place(given, &empty);
                    Assert.That((ulong)placed % 64, Is.Zero, $"offset {offset}");
                    Assert.That(placed >= given && placed + sizeof(EightVertices) <= given + EightVertices.Room, $"offset {offset}");
                }
            }
        }

        private sealed class BothWays : IDisposable
        {
            private readonly WingRig m_Rig;
            private readonly DualQuaternion[] m_Palette;
            private readonly byte[][] m_Vertices;
            private readonly ChunkBounds[] m_Bounds = new ChunkBounds[2];
            private readonly bool m_Packed;

            public BothWays(WingDefinition wing, bool packed)
            {
                m_Packed = packed;
                m_Rig = WingRig.Bake(wing.CreateSkeleton(WingSide.Right), wing.CreateSurface(WingSide.Right), WingRigSettings.Default);
                m_Palette = new DualQuaternion[m_Rig.JointCount];
                int size = packed ? sizeof(PackedVertex) : sizeof(SkinnedVertex);
                m_Vertices = [Bytes(size), Bytes(size)];
            }

            public int Quads => m_Rig.View.quadCount;

            public ChunkBounds Bounds => m_Bounds[1];

            /// <summary>Places the joints, each turned by up to 50° from a common turn, with either sign.</summary>
            public void Turn(ref Random random)
            {
                quaternion common = random.NextQuaternionRotation();
                for (int joint = 0; joint < m_Palette.Length; joint++)
                {
                    var own = quaternion.AxisAngle(random.NextFloat3Direction(), random.NextFloat(0f, math.radians(50f)));
                    var turned = new DualQuaternion(math.mul(common, own), random.NextFloat3(-0.3f, 0.3f));
                    float sign = random.NextBool() ? 1f : -1f;
                    m_Palette[joint] = new DualQuaternion { real = turned.real * sign, dual = turned.dual * sign };
                }
            }

            public void Break() => m_Palette[m_Palette.Length / 2].dual = float.NaN;

            public void Skin(int first, int end)
            {
                fixed (DualQuaternion* palette = m_Palette)
                fixed (byte* four = m_Vertices[0], eight = m_Vertices[1])
                {
                    m_Bounds[0] = SkinWingsJob.SkinQuads(Target(four), palette, first, end, false);
                    m_Bounds[1] = SkinWingsJob.SkinQuads(Target(eight), palette, first, end, true);
                }
            }

            public void AssertSame(string what)
            {
                Assert.That(m_Vertices[1].AsSpan().SequenceEqual(m_Vertices[0]), what);
                Assert.That(m_Vertices[0], Has.Some.Not.Zero, what);
                Assert.That(m_Bounds[1], Is.EqualTo(m_Bounds[0]), what);
            }

            public void Dispose() => m_Rig.Release();

            private byte[] Bytes(int size) => GC.AllocateArray<byte>(m_Rig.VertexCount * size, pinned: true);

            private SkinTarget Target(byte* vertices) => new()
            {
                rig = m_Rig.View,
                frame = m_Rig.Frame,
                vertices = m_Packed ? null : (SkinnedVertex*)vertices,
                packedVertices = m_Packed ? (PackedVertex*)vertices : null,
            };
        }
    }
}
