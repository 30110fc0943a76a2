using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using Alate.Catalogue;
using Alate.Crowds;
using Alate.Tests.Architecture;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Alate.Tests.Play.Headless
{
    /// <summary>Textures, meshes and numbers of a baked insect against its bake, and the surface that is drawn of an insect.</summary>
    public sealed class BakedInsectTests : CrowdFixture
    {
        [Test]
        public void AWingThatIsNotDrawn_IsNamed_AndNotBaked()
        {
            InsectWings insect = Keep(InsectFactory.Create("monarch").gameObject).GetComponent<InsectWings>();
            insect.Wings[0].Renderer.enabled = false;

            BakeException problem = Assert.Throws<BakeException>(
                () => InsectBaker.Bake(insect, new[] { BakeMotion.Find("rest") }, BakeSettings.Default));
            Assert.That(problem.Message, Does.Contain($"show the renderer '{insect.Wings[0].Renderer.name}'"));
        }

        // What the body weighs is that of the first wing's preset, as for an insect that flies.
        [Test]
        public void AnInsectWhoseWingsHavePresetsOfTheirOwn_FliesWithThem()
        {
            InsectDefinition species = InsectCatalogue.Find("monarch");
            InsectWings insect = Keep(InsectFactory.Create(species, InsectVariant.Flight).gameObject).GetComponent<InsectWings>();
            Alate.Flight.InsectFlight flight = CatalogueFlight.AddTo(insect, species);
            WingPreset own = insect.Preset, heavy = Keep(Object.Instantiate(own));
            heavy.Size.insectMass *= 3f;
            insect.Wings.ForEach(wing => wing.Preset = own);
            insect.Preset = heavy;
            using var drawn = new DrawnInsect(insect);
            using var flown = FlownInsect.Of(insect, drawn.Wings);

            Assert.That(flight.Trims, Is.Not.Null);
            Assert.That(() => flown.Fly(BakeMotion.Find("cruise")), Throws.Nothing);
        }

        [Test]
        public void TheTexture_HoldsEveryVertexAtEveryFrame_WhereTheMeshesLook_AndItsNormalAbove()
        {
            Scene = new CrowdScene("monarch", 1, "glide", "rest");
            InsectBake bake = Scene.Bake;
            BakedInsect baked = Scene.Baked;
            ReducedSurface[] reduced = ReducedSurface.Of(bake, CrowdScene.Triangles);
            Color[] pixels = baked.Texture.GetPixels();
            BakedFrame[] frames = bake.Clips.SelectMany(clip => clip.Frames).ToArray();
            for (int size = 0; size < reduced.Length; size++)
            {
                Mesh mesh = baked.Sizes[size].mesh;
                var coordinates = new List<Vector2>();
                mesh.GetUVs(1, coordinates);
                Assert.That(mesh.vertexCount, Is.EqualTo(reduced[size].Vertices.Length));
                Assert.That(mesh.indexFormat, Is.EqualTo(IndexFormat.UInt16));
                Assert.That(baked.Sizes[size].triangles,
                    Is.EqualTo(Enumerable.Range(0, mesh.subMeshCount).Sum(part => mesh.GetTriangles(part).Length / 3)));
                for (int k = 0; k < coordinates.Count; k += 5)
                {
                    int vertex = reduced[size].Vertices[k];
                    Assert.That((mesh.vertices[k], mesh.uv[k], mesh.colors32[k], mesh.normals[k]), Is.EqualTo(
                        (bake.Surface.Positions[vertex],
                            bake.Surface.Uvs[vertex], bake.Surface.Colours[vertex], bake.Surface.Normals[vertex])));
                    for (int frame = 0; frame < frames.Length; frame++)
                    {
                        int x = (int)(coordinates[k].x * baked.Texture.width), y = (int)(coordinates[k].y * baked.Texture.height) + frame;
                        Color place = pixels[y * baked.Texture.width + x],
                            normal = pixels[(y + baked.Texture.height / 2) * baked.Texture.width + x];
                        Assert.That(math.distance(new float3(place.r, place.g, place.b), frames[frame].Positions[vertex]),
                            Is.LessThan(1e-3f * bake.WingLength), "half-floats");
                        Assert.That(
                            math.distance(new float3(normal.r, normal.g, normal.b), frames[frame].Normals[vertex]), Is.LessThan(2e-3f));
                    }
                }

                for (int part = 0; part < mesh.subMeshCount; part++)
                {
                    Assert.That(
                        mesh.GetTriangles(part).Select(corner => reduced[size].Vertices[corner]), Is.EqualTo(reduced[size].Parts[part]));
                }
            }

            Assert.That(baked.TextureBytes, Is.EqualTo(8L * baked.Texture.width * baked.Texture.height));
            Assert.That((baked.Texture.filterMode, baked.Texture.wrapMode), Is.EqualTo((FilterMode.Point, TextureWrapMode.Clamp)));
        }

        [Test]
        public void MeshesHaveAboutTheTrianglesThatAreAskedFor_UnlessAskedTheManuals()
        {
            Match named = Regex.Match(
                ManualPages.Text("Documentation~/crowds.md"), @"meshes of about ([\d,]+), ([\d,]+) and ([\d,]+) triangles");
            Assert.That(BakedInsect.DefaultTriangles,
                Is.EqualTo(named.Groups.Values.Skip(1).Select(count => int.Parse(count.Value.Replace(",", "")))));
            Scene = new CrowdScene("monarch", 1, "rest");
            BakedInsect usual = Keep(BakedInsect.Create(Scene.Bake));
            Assert.That(usual.Sizes.Zip(BakedInsect.DefaultTriangles, (size, asked) => (double)size.triangles / asked),
                Is.All.InRange(0.5, 1.02));
            usual.DestroyParts();
        }

        [Test]
        public void Loops_AreThoseOfTheClips_InTheirRows_AndSizesSuitTheirHeights()
        {
            Scene = new CrowdScene("monarch", 1, "glide", "cruise", "turn-left");
            BakedInsect baked = Scene.Baked;
            int first = 0;
            for (int k = 0; k < 3; k++)
            {
                BakedClip clip = Scene.Bake.Clips[k];
                CrowdLoop loop = baked.Loops[k];
                Assert.That((loop.name, loop.firstFrame, loop.frames, loop.frequency, loop.roll, loop.error),
                    Is.EqualTo((clip.Name, first, clip.Frames.Count, clip.Frequency, clip.Motion.Roll, clip.Error.between)));
                Assert.That(((float3)loop.velocity, (float3)loop.angularVelocity, (quaternion)loop.attitude, loop.steering),
                    Is.EqualTo((clip.Velocity, clip.AngularVelocity, clip.Attitude, clip.Motion.Steering)));
                Assert.That(loop.isFlown, Is.False);
                first += clip.Frames.Count;
            }

            Assert.That((baked.IndexOf("CRUISE"), baked.IndexOf("none")), Is.EqualTo((1, -1)));
            Assert.That((baked.Bounds, baked.WingLength), Is.EqualTo((Scene.Bake.Bounds, Scene.Bake.WingLength)));
            foreach (CrowdSize size in baked.Sizes)
            {
                Assert.That(
                    size.screenHeight, Is.EqualTo(0.01f * Mathf.Sqrt(size.triangles)).Within(1e-6f), "edges of eight pixels of a thousand");
                Assert.That(size.mesh.bounds, Is.EqualTo(baked.Bounds), "all loops, not the shape at rest");
            }

            Assert.That(baked.Sizes.Select(size => size.screenHeight), Is.Ordered.Descending);
            Assert.That(baked.Materials, Is.All.Matches<Material>(material => material.enableInstancing
                && material.IsKeywordEnabled("_BAKED") && material.GetTexture("_BakeMap") == baked.Texture));
        }

        [Test]
        public void ErrorsOfAClip_AreThoseOfItsFrames()
        {
            Scene = new CrowdScene("monarch", 1, "cruise");
            // With a substep for each step of the finer bake, both fly alike.
            WingPreset preset = Keep(Object.Instantiate(Scene.Prefab.Preset));
            preset.SubstepsPerBeat = 4 * BakeSettings.DefaultFrames;
            Scene.Prefab.Preset = preset;
            InsectBake bake = InsectBaker.Bake(Scene.Prefab, [BakeMotion.Find("cruise")], BakeSettings.Default),
                fine = InsectBaker.Bake(Scene.Prefab, [BakeMotion.Find("cruise")], new BakeSettings(2 * BakeSettings.DefaultFrames));
            BakedClip clip = bake.Clips[0];
            float linear = 0f, between = 0f, turned = 0f;
            var positions = new float3[bake.Surface.VertexCount];
            var normals = new float3[positions.Length];
            foreach (BakedWing wing in bake.Wings)
            {
                for (int frame = 0; frame < clip.Frames.Count; frame++)
                {
                    // Twice as many frames lie in the middle between those that were kept.
                    clip.Evaluate((frame + 0.5f) / clip.Frames.Count, positions, normals);
                    BakedFrame middle = fine.Clips[0].Frames[2 * frame + 1];
                    for (int k = 0; k < wing.Vertices.Length; k++)
                    {
                        int vertex = wing.Vertices[k];
                        float3 skinned = 0f;
                        for (int c = 0; c < 4; c++)
                        {
                            BakedJoint pose = clip.Frames[frame].Joints[wing.FirstJoint + wing.VertexJoints[k][c]];
                            skinned += wing.VertexWeights[k][c] * (pose.position + math.rotate(
                                pose.rotation, (float3)bake.Surface.Positions[vertex] - wing.RestJoints[wing.VertexJoints[k][c]]));
                        }

                        linear = math.max(linear, math.distance(skinned, clip.Frames[frame].Positions[vertex]) / wing.Length);
                        between = math.max(between, math.distance(positions[vertex], middle.Positions[vertex]) / wing.Length);
                        turned = math.max(
                            turned, math.degrees(math.acos(math.clamp(math.dot(normals[vertex], middle.Normals[vertex]), -1f, 1f))));
                    }
                }
            }

            Assert.That(clip.Error.linearSkin, Is.EqualTo(linear).Within(0.05f * linear));
            Assert.That(clip.Error.between, Is.EqualTo(between).Within(0.02f * between));
            Assert.That(clip.Error.normalBetween, Is.EqualTo(turned).Within(0.02f * turned));
        }

        [Test]
        public void PartsOfAnInsect_AreDrawnWhereTheyAre_ScaledTurnedAndMirrored()
        {
            InsectWings insect = InsectFactory.Create("monarch");
            Keep(insect.gameObject);
            var tail = new GameObject("tail");
            tail.transform.SetParent(insect.transform, false);
            tail.transform.localPosition = new Vector3(0.01f, 0.02f, 0.03f);
            tail.transform.localRotation = Quaternion.Euler(0f, 90f, 0f);
            tail.transform.localScale = new Vector3(-2f, 1f, 0.5f);
            Mesh mesh = Keep(new Mesh
            {
                vertices = [Vector3.zero, Vector3.right, Vector3.forward],
                normals = [Vector3.up, Vector3.right, new Vector3(0.6f, 0f, 0.8f)],
                uv = [Vector2.zero, new Vector2(0.25f, 0.75f), Vector2.one],
                triangles = [0, 2, 1],
            });
            tail.AddComponent<MeshFilter>().sharedMesh = mesh;
            tail.AddComponent<MeshRenderer>();
            BakedSurface surface = InsectBaker.Bake(insect, [BakeMotion.Find("rest")], new BakeSettings(4)).Surface;
            BakedPart part = surface.Parts.Single(known => known.Name == "tail");
            int[] corners = part.Triangles;

            // Scaled, then a quarter turn to the right: X goes to -Z and Z to X.
            Vector3[] places = corners.Select(corner => surface.Positions[corner]).ToArray();
            Assert.That(places.Select(place => place - new Vector3(0.01f, 0.02f, 0.03f)),
                Is.EquivalentTo(new[] { Vector3.zero, new Vector3(0f, 0f, 2f), new Vector3(0.5f, 0f, 0f) })
                    .Using<Vector3>((a, b) => (a - b).magnitude < 1e-5f));
            Assert.That(
                Vector3.Cross(places[1] - places[0], places[2] - places[0]).y, Is.GreaterThan(0f), "the side that was seen is seen");
            Assert.That((part.HasColours, part.Material), Is.EqualTo((false, (Material)null)));
            foreach (int corner in corners)
            {
                Vector3 place = surface.Positions[corner] - new Vector3(0.01f, 0.02f, 0.03f);
                Vector3 normal = place.magnitude < 1e-5f
                    ? Vector3.up : place.z > 1f ? Vector3.forward : new Vector3(0.8f / 0.5f, 0f, 0.6f / 2f).normalized;
                Assert.That(Vector3.Distance(surface.Normals[corner], normal), Is.LessThan(1e-4f), $"at {place}");
                Assert.That(surface.Colours[corner], Is.EqualTo(new Color32(255, 255, 255, 255)));
                Assert.That(surface.Uvs[corner],
                    Is.EqualTo(place.magnitude < 1e-5f ? Vector2.zero : place.z > 1f ? new Vector2(0.25f, 0.75f) : Vector2.one));
            }
        }

        [Test]
        public void AWing_HasItsRigsVerticesJointsAndLength_InTheInsectsSpace()
        {
            Scene = new CrowdScene("monarch", 1, "rest");
            InsectBake bake = Scene.Bake;
            float metres = Scene.Prefab.Preset.Size.wingLength;

            Assert.That(bake.MetresPerUnit * bake.WingLength, Is.EqualTo(metres).Within(1e-4f * metres), "life size");
            Assert.That(bake.WingLength, Is.EqualTo(bake.Wings.Max(wing => wing.Length)));
            Assert.That(bake.JointCount, Is.EqualTo(bake.Wings.Sum(wing => wing.RestJoints.Length) + bake.Abdomens.Count));
            Assert.That(bake.Abdomens.Single().Joint, Is.EqualTo(bake.JointCount - 1), "behind those of the wings");
            Assert.That(bake.Wings.Select(wing => wing.Side), Is.EqualTo(new[] { WingSide.Right, WingSide.Left }));
            int joints = 0;
            foreach (BakedWing wing in bake.Wings)
            {
                Assert.That(wing.FirstJoint, Is.EqualTo(joints));
                joints += wing.RestJoints.Length;
                Assert.That(wing.RestJoints.Length % wing.JointsPerChain, Is.Zero);
                Assert.That(math.sign(wing.RestJoints[wing.JointsPerChain - 1].x), Is.EqualTo(wing.Side == WingSide.Right ? 1f : -1f));
                Assert.That(wing.VertexWeights.Select(weights => math.csum(weights)), Is.All.EqualTo(1f).Within(1e-4f));
                Assert.That(wing.VertexJoints.Select(indices => math.cmax(indices)), Is.All.LessThan(wing.RestJoints.Length));
                foreach (float3 joint in wing.RestJoints)
                {
                    Assert.That(wing.Vertices.Min(vertex => math.distance(joint, bake.Surface.Positions[vertex])),
                        Is.LessThan(0.1f * wing.Length), "joints lie on the wing");
                }
            }
        }
    }
}
