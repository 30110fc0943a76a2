using System.IO;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Bakes
{
    /// <summary>glTF files that <c>bake</c> writes, played as the specification says, beside the live wings.</summary>
    [Explicit]
    [Category("Long")]
    [Category("Faults")]
    public sealed class BakedGltfTests : BakedFilesFixture
    {
        // Linear blends of joints differ from the live wings' dual quaternions by up to 0.06 %, see crowds.md.
        private const double k_AtFrames = 1.5e-3;

        [TestCase("monarch")]
        public void Joints_MoveTheWingsAsTheLiveOnes(string species) => AssertLive(species, "gltf-skin", "skin", k_AtFrames);

        [TestCaseSource(nameof(Others))]
        [Explicit]
        [Category("Long")]
        public void Joints_MoveTheWingsOfAnyOtherSpecies_AsTheLiveOnes(string species) =>
            AssertLive(species, "gltf-skin", "skin", k_AtFrames);

        [TestCase("monarch")]
        [TestCase("fishfly", Explicit = true, Category = "Long")]
        public void Shapes_AreThoseOfTheLiveWings(string species) => AssertLive(species, "gltf-morph", "morph", atFrames: 1e-3);

        [Test]
        public void ASecondClip_IsAnAnimationOfItsOwn()
        {
            foreach (string form in new[] { "skin", "morph" })
            {
                string folder = Files.Folder($"monarch --clips cruise,rest --frames 16 --format gltf-{form}");
                var file = new GltfPlayer(File.ReadAllBytes(Path.Combine(folder, $"monarch-{form}.glb")));
                float3[] early = file.Play("rest", 0.0).Positions, late = file.Play("rest", 0.5 * file.Length("rest")).Positions;
                float3[] top = file.Play("cruise", 0.0).Positions, bottom = file.Play("cruise", 0.5 * file.Length("cruise")).Positions;

                Assert.That(Farthest(early, late), Is.LessThan(1e-5f), "at rest nothing moves");
                Assert.That(Farthest(top, bottom), Is.GreaterThan(0.03f), "metres from the top of the beat to the bottom");
            }
        }

        private void AssertLive(string species, string format, string ending, double atFrames)
        {
            string folder = Files.Folder($"{species} --clips cruise --format {format}");
            var file = new GltfPlayer(File.ReadAllBytes(Path.Combine(folder, $"{species}-{ending}.glb")));
            var live = LiveWings.Of(species);
            double length = file.Length("cruise");

            Assert.That(length, Is.EqualTo(1.0 / live.Frequency).Within(1e-5));
            for (int half = 0; half < 2 * LiveWings.Frames; half += 5)
            {
                double turns = half / (2.0 * LiveWings.Frames);
                (float3[] positions, float3[] normals) = file.Play("cruise", turns * length);
                (double distance, double angle) = live.Compare(turns, positions, normals);
                Assert.That(distance, Is.LessThan(half % 2 == 0 ? atFrames : 5e-3), $"at {turns} of the beat");
                Assert.That(angle, Is.LessThan(2.0), $"at {turns} of the beat");
            }
        }

        private static float Farthest(float3[] a, float3[] b)
        {
            float farthest = 0f;
            for (int k = 0; k < a.Length; k++)
                farthest = math.max(farthest, math.distance(a[k], b[k]));
            return farthest;
        }
    }
}
