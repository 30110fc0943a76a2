using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Alate.Tests
{
    public sealed class SkinnedWingConversionTests
    {
        const float k_Near = 2e-5f;

        SkinnedSketch m_Insect;
        SkinnedWingResult m_Result;

        [SetUp]
        public void MakeAnInsect()
        {
            m_Insect = new SkinnedSketch();
            m_Insect.Bone("chest", new Vector3(0f, 0.1f, 0f), scale: 2f);
        }

        [TearDown]
        public void EndIt()
        {
            if (m_Result != null)
            {
                foreach (var mesh in m_Result.WingMeshes)
                    Object.DestroyImmediate(mesh);
                Object.DestroyImmediate(m_Result.BodyMesh);
            }

            m_Insect.Dispose();
        }

        [Test]
        public void ARendererThatIsAllWing_BecomesOneUnderItsBone_AndFollowsIt([Values(0, 1, 2)] int pose)
        {
            m_Insect.Bone("chest/hinge", new Vector3(0.1f, 0f, 0f));
            var source = m_Insect.Skin("Wing", Wing(1f), p => SkinnedSketch.One(1));
            MoveOnce(pose);
            var before = m_Insect.Posed(source.sharedMesh);

            m_Result = SkinnedWingConversion.Convert(source);

            Assert.That(source.enabled, Is.False);
            Assert.That(m_Result.BodyMesh, Is.Null);
            Assert.That(m_Result.Wings.Single().transform.parent, Is.SameAs(m_Insect.Bones[1]));
            AssertDrawn(m_Result.Wings[0], before);
            m_Insect.Move(7);
            AssertDrawn(m_Result.Wings[0], m_Insect.Posed(source.sharedMesh));
        }

        [Test]
        public void BothWingsOfARenderer_FollowTheirOwnBones()
        {
            var source = Winged("Wings", Wings(), p => SkinnedSketch.One(p.x > 0f ? 1 : 2));

            m_Result = SkinnedWingConversion.Convert(source);
            m_Insect.Move(3);

            Assert.That(m_Result.Wings.Select(wing => wing.name), Is.EqualTo(new[] { "Wing Right", "Wing Left" }));
            Assert.That(m_Result.Wings.Select(wing => wing.transform.parent), Is.EqualTo(m_Insect.Bones.Skip(1)));
            foreach (var wing in m_Result.Wings)
                AssertDrawn(wing, m_Insect.Posed(source.sharedMesh));
        }

        [Test]
        public void WingsThatGrowOutOfTheBody_AreCutOff_WhereTheirBonesTakeOver()
        {
            // One connected mesh, from the left tip to the right; weights blend from the chest to the wings.
            var sketch = new MeshSketch().Sheet(new Vector3(-1f, 0.1f, 0f), 2f * Vector3.right, 0.4f * Vector3.back, 40, 4);
            var source = Winged("Butterfly", sketch, Blended);
            var original = source.sharedMesh;
            var bind = m_Insect.Posed(original);

            m_Result = SkinnedWingConversion.Convert(source);

            Assert.That(source.enabled && source.sharedMesh == m_Result.BodyMesh);
            Assert.That(m_Result.Wings, Has.Count.EqualTo(2));
            Assert.That(TriangleCount(), Is.EqualTo(original.triangles.Length));
            foreach (var wing in m_Result.Wings)
                AssertDrawn(wing, bind);
            m_Insect.Move(11);
            var posed = m_Insect.Posed(original);
            Assert.That(m_Insect.Posed(m_Result.BodyMesh), Is.EqualTo(posed));
            foreach (var wing in m_Result.Wings)
                AssertDrawn(wing, posed, number => Mathf.Abs(original.vertices[number].x) > 0.3f);
        }

        [Test]
        public void OfOneMeshWithTheBody_WingsAreFoundByMaterial_AndTheRestStaysSkinned()
        {
            var sketch = Body().NextSubmesh().Wing(Hinge(1f), 1f, 0.5f).Wing(Hinge(-1f), -1f, 0.5f);
            var source = Skinned("Fly", sketch, Blended, "chitin", "wing");
            var original = source.sharedMesh;

            m_Result = SkinnedWingConversion.Convert(source, m_Insect.Root);

            Assert.That(m_Result.BodyMesh.subMeshCount, Is.EqualTo(2));
            Assert.That(m_Result.BodyMesh.GetTriangles(0), Is.EqualTo(original.GetTriangles(0)));
            Assert.That(m_Result.BodyMesh.GetTriangles(1), Is.Empty);
            Assert.That(m_Result.BodyMesh.boneWeights, Is.EqualTo(original.boneWeights));
            Assert.That(m_Result.Wings.Select(wing => wing.sharedMaterial), Is.All.SameAs(source.sharedMaterials[1]));
            Assert.That(m_Result.Wings.Select(wing => wing.transform.parent), Is.EqualTo(m_Insect.Bones.Skip(1)));
        }

        [Test]
        public void WhereNothingIsCalledAWing_ThinMirroredPartsAreWings()
        {
            var source = Skinned("Fly", Body().Wing(Hinge(1f), 1f, 0.5f).Wing(Hinge(-1f), -1f, 0.5f), Blended);

            m_Result = SkinnedWingConversion.Convert(source, m_Insect.Root);

            Assert.That(m_Result.Wings.Select(wing => wing.name), Is.EqualTo(new[] { "Wing Right", "Wing Left" }));
            Assert.That(m_Result.BodyMesh.triangles, Has.Length.EqualTo(36));
        }

        [Test]
        public void APartThatIsAskedFor_IsTaken_WhateverItIsCalled()
        {
            var source = Skinned("Fly", Body().NextSubmesh().Wing(Hinge(1f), 1f, 0.5f), p => SkinnedSketch.One(0));
            var original = source.sharedMesh;

            m_Result = SkinnedWingConversion.Convert(source, m_Insect.Root, WingPart.Submesh, 1);
            Assert.That(m_Result.WingMeshes.Single().triangles, Has.Length.EqualTo(original.GetTriangles(1).Length));
            m_Result.Restore();
            m_Result = SkinnedWingConversion.Convert(source, m_Insect.Root, WingPart.ConnectedPart, 0, new Vector3(1f, 0.1f, 0f));
            Assert.That(m_Result.WingMeshes.Single().triangles, Has.Length.EqualTo(original.GetTriangles(1).Length));
        }

        [Test]
        public void SeveralBonesOfAWing_HangFromItsFirst_WhichCarriesIt()
        {
            m_Insect.Bone("chest/wing.R", Hinge(1f));
            m_Insect.Bone("chest/wing.R/wing.R.001", 0.2f * Vector3.right);
            m_Insect.Bone("chest/wing.R/wing.R.001/Bone", 0.2f * Vector3.right);
            m_Insect.Bone("chest/wing.L", Hinge(-1f));
            var source = m_Insect.Skin("Wings", Wings(), p => p.x < 0f ? SkinnedSketch.One(4) : SkinnedSketch.Two(1, p.x > 0.6f ? 3 : 2, 0.9f));

            m_Result = SkinnedWingConversion.Convert(source);

            Assert.That(m_Result.Wings.Select(wing => wing.transform.parent.name), Is.EqualTo(new[] { "wing.R", "wing.L" }));
        }

        [Test]
        public void ForeAndHindWingsThatHangTogether_AreToldByTheirBones()
        {
            var sketch = new MeshSketch();
            foreach (var side in new[] { 1f, -1f })
                sketch.Wing(Hinge(side), side, 0.4f, 8, 8).Wing(Hinge(side) - new Vector3(0f, 0f, 0.4f), 0.8f * side, 0.3f, 8, 8);
            foreach (var name in new[] { "forewing_r", "hindwing_r", "forewing_l", "hindwing_l" })
                m_Insect.Bone("chest/" + name, Hinge(name.EndsWith("r") ? 1f : -1f));
            var source = m_Insect.Skin("Wings", sketch, p => SkinnedSketch.One((p.x > 0f ? 1 : 3) + (p.z < Hinge(1f).z - 0.4f ? 1 : 0)));

            m_Result = SkinnedWingConversion.Convert(source);

            Assert.That(
                m_Result.Wings.Select(wing => $"{wing.name}: {wing.transform.parent.name}"),
                Is.EqualTo(new[]
                {
                    "Fore Wing Right: forewing_r", "Fore Wing Left: forewing_l",
                    "Hind Wing Right: hindwing_r", "Hind Wing Left: hindwing_l",
                }));
            Assert.That(TriangleCount(), Is.EqualTo(source.sharedMesh.triangles.Length));
        }

        [TestCase(1f)]
        [TestCase(-1f)]
        public void FacesNormalsAndTangents_AreKept_AlsoUnderABoneThatMirrors(float scale)
        {
            var bone = m_Insect.Bone("chest/hinge", new Vector3(0.1f, 0f, 0f));
            bone.localScale = new Vector3(scale, 1f, 1f);
            var source = m_Insect.Skin("Wing", Wing(1f), p => SkinnedSketch.One(1));
            var original = source.sharedMesh;

            m_Result = SkinnedWingConversion.Convert(source);

            var mesh = m_Result.WingMeshes.Single();
            var toWorld = m_Result.Wings[0].transform.localToWorldMatrix;
            var normalToWorld = toWorld.inverse.transpose;
            for (var corner = 0; corner < mesh.triangles.Length; corner += 3)
            {
                Vector3 a = mesh.vertices[mesh.triangles[corner]], b = mesh.vertices[mesh.triangles[corner + 1]];
                var face = Vector3.Cross(b - a, mesh.vertices[mesh.triangles[corner + 2]] - a);
                Assert.That(Vector3.Dot(face, mesh.normals[mesh.triangles[corner]]), Is.GreaterThan(0f));
            }

            for (var vertex = 0; vertex < mesh.vertexCount; vertex++)
            {
                var normal = normalToWorld.MultiplyVector(mesh.normals[vertex]).normalized;
                Assert.That((normal - m_Insect.Root.TransformDirection(original.normals[vertex])).magnitude, Is.LessThan(1e-4f));
                var tangent = toWorld.MultiplyVector(mesh.tangents[vertex]).normalized;
                Assert.That((tangent - m_Insect.Root.TransformDirection(original.tangents[vertex])).magnitude, Is.LessThan(1e-4f));
                Assert.That(mesh.tangents[vertex].w, Is.EqualTo(original.tangents[vertex].w * scale));
            }
        }

        [Test]
        public void ColoursAndAllTextureCoordinates_AreKept()
        {
            var source = Winged("Wings", Wings(), p => SkinnedSketch.One(p.x > 0f ? 1 : 2));
            var original = source.sharedMesh;
            original.colors32 = Array.ConvertAll(original.vertices, p => (Color32)new Color(p.x, p.y, -p.z, 1f));
            original.SetUVs(3, Array.ConvertAll(original.vertices, p => new Vector4(p.z, p.y, p.x, 5f)));
            original.SetUVs(7, Array.ConvertAll(original.vertices, p => p));

            m_Result = SkinnedWingConversion.Convert(source);

            var fours = new List<Vector4>();
            var threes = new List<Vector3>();
            foreach (var mesh in m_Result.WingMeshes)
            {
                mesh.GetUVs(3, fours);
                mesh.GetUVs(7, threes);
                for (var vertex = 0; vertex < mesh.vertexCount; vertex++)
                {
                    var p = original.vertices[(int)mesh.uv[vertex].x];
                    Assert.That(mesh.colors32[vertex], Is.EqualTo((Color32)new Color(p.x, p.y, -p.z, 1f)));
                    Assert.That(fours[vertex], Is.EqualTo(new Vector4(p.z, p.y, p.x, 5f)));
                    Assert.That(threes[vertex], Is.EqualTo(p));
                }

                Assert.That(mesh.boneWeights, Is.Empty);
                Assert.That(mesh.uv2, Is.Empty);
            }
        }

        [Test]
        public void BlendShapes_AreKeptAsTheyAreSet()
        {
            m_Insect.Bone("chest/hinge", new Vector3(0.1f, 0f, 0f));
            var source = m_Insect.Skin("Wing", Wing(1f), p => SkinnedSketch.One(1));
            var mesh = source.sharedMesh;
            foreach (var frame in new[] { 50f, 100f })
                mesh.AddBlendShapeFrame("flap", frame, Array.ConvertAll(mesh.vertices, p => new Vector3(0f, p.x * frame, 0f)), null, null);
            mesh.AddBlendShapeFrame("none", 100f, Array.ConvertAll(mesh.vertices, p => Vector3.one), null, null);
            source.SetBlendShapeWeight(0, 75f);

            m_Result = SkinnedWingConversion.Convert(source);

            var expected = m_Insect.Posed(mesh);
            for (var vertex = 0; vertex < expected.Length; vertex++)
                expected[vertex] += m_Insect.Root.TransformVector(new Vector3(0f, 75f * mesh.vertices[vertex].x, 0f));
            AssertDrawn(m_Result.Wings[0], expected, near: 1e-2f);
        }

        [Test]
        public void TheSourceMesh_IsNeverChanged()
        {
            var source = Winged("Fly", Body().Wing(Hinge(1f), 1f, 0.5f).Wing(Hinge(-1f), -1f, 0.5f), Blended);
            var mesh = source.sharedMesh;
            var (positions, triangles, weights, normals) = (mesh.vertices, mesh.triangles, mesh.boneWeights, mesh.normals);

            m_Result = SkinnedWingConversion.Convert(source, m_Insect.Root);

            Assert.That(mesh.vertices, Is.EqualTo(positions));
            Assert.That(mesh.triangles, Is.EqualTo(triangles));
            Assert.That(mesh.normals, Is.EqualTo(normals));
            Assert.That(mesh.boneWeights, Is.EqualTo(weights));
            Assert.That(mesh.name, Is.EqualTo("Mesh"));
            Assert.That(m_Result.BodyMesh, Is.Not.SameAs(mesh));
        }

        [Test]
        public void AMeshWithoutBones_IsConvertedWhereItIs()
        {
            using var insect = new SkinnedSketch();
            var source = insect.Skin("Wings", Wings(), p => default);
            source.transform.localPosition = Vector3.zero;

            m_Result = SkinnedWingConversion.Convert(source);

            Assert.That(m_Result.Wings.Select(wing => wing.transform.parent), Is.EqualTo(new[] { source.transform, source.transform }));
            Assert.That(m_Result.WingMeshes[0].bounds.min.x, Is.EqualTo(0.1f).Within(k_Near));
            Assert.That(m_Result.WingMeshes[1].bounds.max.x, Is.EqualTo(-0.1f).Within(k_Near));
        }

        [Test]
        public void WhatCannotBeConverted_IsRefused_AndNothingIsMade()
        {
            Refuses<ArgumentNullException>(null, "source");
            var source = Skinned("Fly", Body(), p => SkinnedSketch.One(0));
            Refuses<ArgumentException>(source, "Nothing in 'Fly' looks like a wing");

            source.name = "Wing";
            source.bones = new Transform[2];
            Refuses<ArgumentException>(source, "Bone 0 of 'Wing', which carries a wing, is missing.");
            source.bones = new Transform[0];
            Refuses<ArgumentException>(source, "'Wing' has no bones: turn off Optimize Game Objects");
            source.sharedMesh.UploadMeshData(true);
            Refuses<ArgumentException>(source, "Mesh 'Mesh' is not readable");
            source.sharedMesh = null;
            Refuses<ArgumentException>(source, "'Wing' has no mesh.");
            Assert.That(m_Insect.Root.GetComponentsInChildren<MeshRenderer>(true), Is.Empty);
        }

        void Refuses<T>(SkinnedMeshRenderer source, string message) where T : ArgumentException
        {
            Assert.That(() => SkinnedWingConversion.Convert(source, m_Insect.Root), Throws.InstanceOf<T>().With.Message.Contains(message));
        }

        // Each vertex of the wing, by the number that it carries, is drawn at its place.
        static void AssertDrawn(MeshRenderer wing, Vector3[] places, Predicate<int> which = null, float near = k_Near)
        {
            var mesh = wing.GetComponent<MeshFilter>().sharedMesh;
            var numbers = mesh.uv;
            var positions = mesh.vertices;
            for (var vertex = 0; vertex < positions.Length; vertex++)
            {
                var number = (int)numbers[vertex].x;
                var drawn = wing.transform.localToWorldMatrix.MultiplyPoint3x4(positions[vertex]);
                if (which == null || which(number))
                    Assert.That((drawn - places[number]).magnitude, Is.LessThan(near), $"vertex {number}");
            }
        }

        int TriangleCount() =>
            m_Result.WingMeshes.Sum(mesh => mesh.triangles.Length) + (m_Result.BodyMesh != null ? m_Result.BodyMesh.triangles.Length : 0);

        void MoveOnce(int pose)
        {
            if (pose > 0)
                m_Insect.Move(pose);
        }

        SkinnedMeshRenderer Winged(string name, MeshSketch sketch, Func<Vector3, BoneWeight> weights)
        {
            m_Insect.Bone("chest/wing_R", Hinge(1f));
            m_Insect.Bone("chest/wing_L", Hinge(-1f), Quaternion.Euler(5f, 175f, 40f), 0.3f);
            return m_Insect.Skin(name, sketch, weights);
        }

        SkinnedMeshRenderer Skinned(string name, MeshSketch sketch, Func<Vector3, BoneWeight> weights, params string[] materials)
        {
            m_Insect.Bone("chest/b", Hinge(1f));
            m_Insect.Bone("chest/c", Hinge(-1f), Quaternion.Euler(5f, 175f, 40f), 0.3f);
            return m_Insect.Skin(name, sketch, weights, materials);
        }

        static BoneWeight Blended(Vector3 p) => SkinnedSketch.Two(0, p.x > 0f ? 1 : 2, Mathf.Clamp01((Mathf.Abs(p.x) - 0.1f) / 0.2f));

        static Vector3 Hinge(float side) => new Vector3(0.1f * side, 0.2f, 0.2f);

        static MeshSketch Body() => new MeshSketch().Box(Vector3.zero, new Vector3(0.2f, 0.2f, 1f));

        static MeshSketch Wing(float side) => new MeshSketch().Wing(Hinge(side), side, 0.5f);

        static MeshSketch Wings() => Wing(1f).Wing(Hinge(-1f), -1f, 0.5f);
    }
}
