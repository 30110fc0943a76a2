using System.IO;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Bakes
{
    /// <summary>Textures that <c>bake</c> writes, read as the open importers read them, beside the live wings.</summary>
    [Explicit]
    [Category("Long")]
    [Category("Faults")]
    public sealed class OpenVatTests : BakedFilesFixture
    {
        [TestCase("monarch")]
        public void Played_TheWingsAreTheLiveOnes(string species) => AssertLive(species);

        [TestCaseSource(nameof(Others))]
        [Explicit]
        [Category("Long")]
        public void Played_TheWingsOfAnyOtherSpecies_AreTheLiveOnes(string species) => AssertLive(species);

        [Test]
        public void EveryClip_EndsAsItBegins()
        {
            VatReader vat = Read("monarch", "monarch --clips cruise,hover,rest --frames 16 --normals packed");
            foreach (string clip in new[] { "cruise", "hover", "rest" })
            {
                (int start, int end, _) = vat.Clip(clip);
                (float3[] first, float3[] firstNormals) = vat.At(start);
                (float3[] last, float3[] lastNormals) = vat.At(end);

                Assert.That(last, Is.EqualTo(first));
                Assert.That(lastNormals, Is.EqualTo(firstNormals));
            }
        }

        [Test]
        public void PackedNormals_AreThoseOfASeparateTexture()
        {
            VatReader separate = Read("monarch", "monarch --clips cruise,hover,rest --frames 16"),
                packed = Read("monarch", "monarch --clips cruise,hover,rest --frames 16 --normals packed");

            Assert.That(separate.IsPacked, Is.False);
            Assert.That(packed.IsPacked, Is.True);
            Assert.That(packed.Width * packed.Height, Is.GreaterThan(separate.Width * separate.Height));
            Assert.That(packed.At(5).Positions, Is.EqualTo(separate.At(5).Positions));
            Assert.That(packed.At(5).Normals, Is.EqualTo(separate.At(5).Normals));
        }

        [Test]
        public void TheFolder_HoldsWhatTheConventionNames()
        {
            string folder = Files.Folder("monarch --clips cruise,hover,rest --frames 16");

            Assert.That(
                Directory.GetFiles(folder, "*", SearchOption.AllDirectories)
                    .Select(file => Path.GetRelativePath(folder, file).Replace('\\', '/')),
                Is.EquivalentTo(new[] { "monarch_vat/monarch.glb", "monarch_vat/monarch.png", "monarch_vat/monarch-remap_info.json",
                    "monarch_vat/monarch-vnrm.png" }));
        }

        [Test]
        public void MoreVerticesThanColumns_GoOnBelow()
        {
            VatReader wide = Read("fishfly", "fishfly --frames 4 --max-size 4096"),
                tall = Read("fishfly", "fishfly --frames 48 --max-size 2048");

            Assert.That(wide.VertexCount, Is.GreaterThan(wide.Width));
            Assert.That(tall.Height % tall.Frames, Is.Zero);
            Assert.That(tall.Height / tall.Frames, Is.EqualTo((tall.VertexCount + tall.Width - 1) / tall.Width));
            Assert.That(wide.At(1).Positions.Zip(tall.At(12).Positions, (a, b) => math.distance(a, b)).Max(), Is.LessThan(1e-3f));
        }

        [Test]
        public void ASmallerMesh_IsOfVerticesOfTheWholeOne()
        {
            VatReader whole = Read("monarch", "monarch --frames 12"), smaller = Read("monarch", "monarch --frames 12 --triangles 160");
            float3[] all = whole.At(5).Positions;

            Assert.That(smaller.VertexCount, Is.InRange(60, 300));
            foreach (float3 position in smaller.At(5).Positions)
                Assert.That(all.Min(place => math.distance(place, position)), Is.LessThan(3e-6f));
        }

        private void AssertLive(string species)
        {
            VatReader vat = Read(species, $"{species} --clips cruise");
            var live = LiveWings.Of(species);
            (int start, int end, double rate) = vat.Clip("cruise");

            Assert.That(end - start, Is.EqualTo(LiveWings.Frames));
            Assert.That(rate / (end - start), Is.EqualTo(live.Frequency).Within(1e-3));
            for (int frame = 0; frame < LiveWings.Frames; frame++)
            {
                (float3[] positions, float3[] normals) = vat.At(start + frame);
                (double distance, double angle) = live.Compare((double)frame / LiveWings.Frames, positions, normals);
                Assert.That(distance, Is.LessThan(1e-3), $"at baked phase {frame}");
                Assert.That(angle, Is.LessThan(2.0), $"at baked phase {frame}");
                (positions, normals) = vat.At(start + frame + 0.5);
                (distance, angle) = live.Compare((frame + 0.5) / LiveWings.Frames, positions, normals);
                Assert.That(distance, Is.LessThan(5e-3), $"behind phase {frame}");
                Assert.That(angle, Is.LessThan(2.0), $"behind phase {frame}");
            }
        }

        private VatReader Read(string species, string arguments) =>
            new VatReader(Path.Combine(Files.Folder(arguments), species + "_vat"), species);
    }
}
