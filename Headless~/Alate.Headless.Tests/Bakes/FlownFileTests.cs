using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Alate.Catalogue;
using Alate.Cli;
using Alate.Crowds;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Bakes
{
    /// <summary>
    /// Files of loops that insects fly by their trims, read as the open importers and glTF's specification do, beside the flown frames, and
    /// between them beside those of a flight twice as fine.
    /// </summary>
    public sealed class FlownFileTests
    {
        private const int k_Frames = 48;

        private static readonly string[] s_Clips = ["cruise", "hover", "climb", "turn-left", "turn-right"];

        private readonly BakedFiles m_Files = new BakedFiles();

        private static IEnumerable<string> Species =>
            InsectCatalogue.Names.Where(name => InsectCatalogue.Find(name).Variants.Contains(InsectVariant.Flight));

        [OneTimeTearDown]
        public void RemoveFiles() => m_Files.Dispose();

        [TestCaseSource(nameof(Species)), Explicit, Category("Long")]
        public void Played_TheWingsAreTheFlownOnes(string species)
        {
            string arguments = $"{species} --variant flight --clips {string.Join(',', s_Clips)}";
            var vat = new VatReader(Path.Combine(m_Files.Folder(arguments), species + "_vat"), species);
            var skin = new GltfPlayer(
                File.ReadAllBytes(Path.Combine(m_Files.Folder(arguments + " --format gltf-skin"), species + "-skin.glb")));
            InsectBake whole = Flown(species, k_Frames), finer = Flown(species, 2 * k_Frames);
            for (int k = 0; k < s_Clips.Length; k++)
            {
                BakedClip clip = finer.Clips[k];

                // The finer flight has another time step, which turns normals at the fishfly's folds by more than the frames do: the bake's
                // own error has the step of its frames.
                Assert.That(whole.Clips[k].Error.normalBetween, Is.LessThan(2f), clip.Name);
                (int start, _, _) = vat.Clip(clip.Name);
                for (int half = 0; half < 2 * k_Frames; half++)
                {
                    BakedFrame flown = half % 2 == 0 ? whole.Clips[k].Frames[half / 2] : clip.Frames[half];
                    (float3[] positions, float3[] normals) = vat.At(start + 0.5 * half);
                    AssertNear(finer, flown, positions, normals, half % 2 == 0 ? 1e-3 : 5e-3, half % 2 == 0,
                        $"texture, {clip.Name} at {half} of {2 * k_Frames}");
                    if (half % 5 != 0)
                        continue;
                    (positions, normals) = skin.Play(clip.Name, half / (2.0 * k_Frames) * skin.Length(clip.Name));
                    AssertNear(finer, flown, positions, normals, half % 2 == 0 ? 1.5e-3 : 5e-3, half % 2 == 0,
                        $"joints, {clip.Name} at {half} of {2 * k_Frames}");
                }
            }
        }

        [Test]
        public void ASmallerMesh_IsPlayedByTheSameJoints_AndItsAbdomenSwings()
        {
            InsectBake bake = new BakePlan { Species = InsectCatalogue.Find("monarch"), Frames = 8, Triangles = 1500 }.Bake(out _);
            var skin = new GltfPlayer(File.ReadAllBytes(
                Path.Combine(m_Files.Folder("monarch --format gltf-skin --frames 8 --triangles 1500"), "monarch-skin.glb")));
            BakedAbdomen abdomen = bake.Abdomens.Single();
            float swing = 0f;
            for (int frame = 0; frame < 8; frame++)
            {
                BakedFrame baked = bake.Clips[0].Frames[frame];
                (float3[] positions, _) = skin.Play("cruise", frame / 8.0 * skin.Length("cruise"));
                for (int vertex = 0; vertex < positions.Length; vertex++)
                {
                    float3 place = ToGltf(baked.Positions[vertex]) * bake.MetresPerUnit;
                    Assert.That(
                        math.distance(place, positions[vertex]), Is.LessThan(1.5e-3f * bake.WingLength * bake.MetresPerUnit), $"{vertex}");
                }

                for (int vertex = abdomen.FirstVertex; vertex < abdomen.FirstVertex + abdomen.VertexCount; vertex++)
                    swing = math.max(swing, math.distance(baked.Positions[vertex], bake.Clips[0].Frames[0].Positions[vertex]));
            }

            Assert.That(swing / bake.WingLength, Is.GreaterThan(0.01f));
        }

        private static InsectBake Flown(string species, int frames) => new BakePlan
        {
            Species = InsectCatalogue.Find(species),
            Variant = InsectVariant.Flight,
            Motions = [.. s_Clips.Select(BakeMotion.Find)],
            Frames = frames,
        }.Bake(out _);

        private static void AssertNear(
            InsectBake bake, BakedFrame flown, float3[] positions, float3[] normals, double near, bool atFrame, string where)
        {
            double distance = 0.0, angle = 0.0;
            foreach (BakedWing wing in bake.Wings)
            {
                foreach (int vertex in wing.Vertices)
                {
                    float3 place = ToGltf(flown.Positions[vertex]) * bake.MetresPerUnit;
                    distance = Math.Max(distance, math.distance(place, positions[vertex]) / (wing.Length * bake.MetresPerUnit));
                    angle = Math.Max(
                        angle, math.degrees(math.acos(math.min(1f, math.dot(normals[vertex], ToGltf(flown.Normals[vertex]))))));
                }
            }

            Assert.That(distance, Is.LessThan(near), where);
            if (atFrame)
                Assert.That(angle, Is.LessThan(2.0), where);
        }

        private static float3 ToGltf(float3 insect) => new float3(-insect.x, insect.y, insect.z);
    }
}
