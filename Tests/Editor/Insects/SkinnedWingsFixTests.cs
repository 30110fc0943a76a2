using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor.Tests
{
    /// <summary>The button that makes plain renderers of skinned wings.</summary>
    public sealed class SkinnedWingsFixTests : InsectFixture
    {
        [Test]
        public void SkinnedWings_AreTheState_AndTheButtonMendsIt()
        {
            InsectWings insect = Skinned();
            Assert.That(InsectStatus.Of(insect).Problem.State, Is.EqualTo(InsectState.SkinnedWings));

            FixOutcome outcome = Convert(insect, PathFor("Wing Meshes"));

            Assert.That(outcome.IsDone, Is.True, outcome.Message);
            Assert.That(insect.Wings.Select(wing => wing.Side), Is.EquivalentTo(new[] { WingSide.Right, WingSide.Left }));
            Assert.That(InsectStatus.Of(insect).IsShown, Is.False);
        }

        [Test]
        public void NewMeshes_AreSavedInTheProject()
        {
            InsectWings insect = Skinned();
            string path = PathFor("Saved Meshes");

            Convert(insect, path);

            Assert.That(insect.Wings, Is.Not.Empty);
            foreach (Wing wing in insect.Wings)
                Assert.That(AssetDatabase.GetAssetPath(MeshOf(wing)), Is.EqualTo(path));
        }

        [Test]
        public void Undo_GivesTheSkinnedRendererBack_InOneStep()
        {
            InsectWings insect = Skinned();
            SkinnedMeshRenderer source = insect.GetComponentInChildren<SkinnedMeshRenderer>();
            Mesh mesh = source.sharedMesh;
            Convert(insect, PathFor("Undone Meshes"));
            Assert.That(source.enabled && source.sharedMesh == mesh, Is.False, "the wings are still drawn by the skinned renderer");

            Undo.PerformUndo();

            Assert.That(source.sharedMesh, Is.SameAs(mesh));
            Assert.That(source.enabled, Is.True);
            Assert.That(insect.Wings, Is.Empty);
            Assert.That(insect.GetComponentsInChildren<MeshRenderer>(true), Is.Empty);
        }

        [TestCase(null)]
        [TestCase("Packages/com.alate.insect-wings/Wings.asset")]
        public void WithoutAPlaceForTheMeshes_NothingIsConverted(string path)
        {
            InsectWings insect = Skinned();
            SkinnedMeshRenderer source = insect.GetComponentInChildren<SkinnedMeshRenderer>();
            Mesh mesh = source.sharedMesh;

            FixOutcome outcome = Convert(insect, path);

            Assert.That(outcome.IsDone, Is.False);
            Assert.That(source.sharedMesh, Is.SameAs(mesh));
            Assert.That(insect.GetComponentsInChildren<MeshRenderer>(true), Is.Empty);
        }

        [Test]
        public void MeshThatCannotBeRead_IsNamed()
        {
            InsectWings insect = Skinned();
            insect.GetComponentInChildren<SkinnedMeshRenderer>().sharedMesh.UploadMeshData(true);

            Assert.That(Fix("").FindObstacle(insect, InsectProblem.None), Does.Contain("Wings").And.Contain("UploadMeshData"));
        }

        private static FixOutcome Convert(InsectWings insect, string path) => Fix(path).Apply(insect, InsectProblem.None);

        private static SkinnedWingsFix Fix(string path) => new SkinnedWingsFix((_, __, ___) => path);

        // A monarch whose two wings are one mesh, each moved by a bone.
        private InsectWings Skinned()
        {
            GameObject root = Keep(new GameObject("insect"));
            var bones = new List<Transform>();
            var vertices = new List<Vector3>();
            var weights = new List<BoneWeight>();
            var triangles = new List<int>();
            foreach (WingSide side in new[] { WingSide.Right, WingSide.Left })
            {
                Transform bone = new GameObject("wing." + (side == WingSide.Right ? "R" : "L")).transform;
                bone.SetParent(root.transform, false);
                bone.localPosition = Monarch.HingeOn(side);
                Mesh wing = Keep(Monarch.CreateSurface(side).ToMesh("part"));
                triangles.AddRange(wing.triangles.Select(vertex => vertex + vertices.Count));
                vertices.AddRange(wing.vertices.Select(vertex => vertex + bone.localPosition));
                weights.AddRange(wing.vertices.Select(_ => new BoneWeight { boneIndex0 = bones.Count, weight0 = 1f }));
                bones.Add(bone);
            }

            Mesh mesh = Keep(new Mesh { name = "Wings", vertices = vertices.ToArray(), triangles = triangles.ToArray() });
            mesh.RecalculateNormals();
            mesh.RecalculateBounds();
            mesh.boneWeights = weights.ToArray();
            mesh.bindposes = Array.ConvertAll(bones.ToArray(), bone => bone.worldToLocalMatrix);
            var child = new GameObject("Wings");
            child.transform.SetParent(root.transform, false);
            SkinnedMeshRenderer renderer = child.AddComponent<SkinnedMeshRenderer>();
            renderer.bones = bones.ToArray();
            renderer.rootBone = bones[0];
            renderer.sharedMesh = mesh;
            renderer.sharedMaterials = new Material[1];
            return Without(root);
        }
    }
}
