using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    public sealed class SkinnedWingMeshTests : SkinnedWingFixture
    {
        [TestCase(1f)]
        [TestCase(-1f)]
        public void FacesNormalsAndTangents_AreKept_AlsoUnderABoneThatMirrors(float scale)
        {
            Transform bone = m_Insect.Bone("chest/hinge", new Vector3(0.1f, 0f, 0f));
            bone.localScale = new Vector3(scale, 1f, 1f);
            SkinnedMeshRenderer source = m_Insect.Skin("Wing", Wing(1f), p => SkinnedSketch.One(1));
            Mesh original = source.sharedMesh;

            m_Result = SkinnedWingConversion.Convert(source);

            Mesh mesh = m_Result.WingMeshes.Single();
            Matrix4x4 toWorld = m_Result.Wings[0].transform.localToWorldMatrix;
            Matrix4x4 normalToWorld = toWorld.inverse.transpose;
            for (int corner = 0; corner < mesh.triangles.Length; corner += 3)
            {
                Vector3 a = mesh.vertices[mesh.triangles[corner]], b = mesh.vertices[mesh.triangles[corner + 1]];
                var face = Vector3.Cross(b - a, mesh.vertices[mesh.triangles[corner + 2]] - a);
                Assert.That(Vector3.Dot(face, mesh.normals[mesh.triangles[corner]]), Is.GreaterThan(0f));
            }

            for (int vertex = 0; vertex < mesh.vertexCount; vertex++)
            {
                Vector3 normal = normalToWorld.MultiplyVector(mesh.normals[vertex]).normalized;
                Assert.That((normal - m_Insect.Root.TransformDirection(original.normals[vertex])).magnitude, Is.LessThan(1e-4f));
                Vector3 tangent = toWorld.MultiplyVector(mesh.tangents[vertex]).normalized;
                Assert.That((tangent - m_Insect.Root.TransformDirection(original.tangents[vertex])).magnitude, Is.LessThan(1e-4f));
                Assert.That(mesh.tangents[vertex].w, Is.EqualTo(original.tangents[vertex].w * scale));
            }
        }

        [Test]
        public void ColoursAndAllTextureCoordinates_AreKept()
        {
            SkinnedMeshRenderer source = Winged("Wings", Wings(), p => SkinnedSketch.One(p.x > 0f ? 1 : 2));
            Mesh original = source.sharedMesh;
            original.colors32 = Array.ConvertAll(original.vertices, p => (Color32)new Color(p.x, p.y, -p.z, 1f));
            original.SetUVs(3, Array.ConvertAll(original.vertices, p => new Vector4(p.z, p.y, p.x, 5f)));
            original.SetUVs(7, Array.ConvertAll(original.vertices, p => p));

            m_Result = SkinnedWingConversion.Convert(source);

            var fours = new List<Vector4>();
            var threes = new List<Vector3>();
            foreach (Mesh mesh in m_Result.WingMeshes)
            {
                mesh.GetUVs(3, fours);
                mesh.GetUVs(7, threes);
                for (int vertex = 0; vertex < mesh.vertexCount; vertex++)
                {
                    Vector3 p = original.vertices[(int)mesh.uv[vertex].x];
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
            SkinnedMeshRenderer source = m_Insect.Skin("Wing", Wing(1f), p => SkinnedSketch.One(1));
            Mesh mesh = source.sharedMesh;
            foreach (float frame in new[] { 50f, 100f })
                mesh.AddBlendShapeFrame("flap", frame, Array.ConvertAll(mesh.vertices, p => new Vector3(0f, p.x * frame, 0f)), null, null);
            mesh.AddBlendShapeFrame("none", 100f, Array.ConvertAll(mesh.vertices, p => Vector3.one), null, null);
            source.SetBlendShapeWeight(0, 75f);

            m_Result = SkinnedWingConversion.Convert(source);

            Vector3[] expected = m_Insect.Posed(mesh);
            for (int vertex = 0; vertex < expected.Length; vertex++)
                expected[vertex] += m_Insect.Root.TransformVector(new Vector3(0f, 75f * mesh.vertices[vertex].x, 0f));
            AssertDrawn(m_Result.Wings[0], expected, near: 1e-2f);
        }

        [Test]
        public void TheSourceMesh_IsNeverChanged()
        {
            SkinnedMeshRenderer source = Winged("Fly", Body().Wing(Hinge(1f), 1f, 0.5f).Wing(Hinge(-1f), -1f, 0.5f), Blended);
            Mesh mesh = source.sharedMesh;
            (Vector3[] positions, int[] triangles, BoneWeight[] weights, Vector3[] normals) =
                (mesh.vertices, mesh.triangles, mesh.boneWeights, mesh.normals);

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
            SkinnedMeshRenderer source = insect.Skin("Wings", Wings(), p => default);
            source.transform.localPosition = Vector3.zero;

            m_Result = SkinnedWingConversion.Convert(source);

            Assert.That(m_Result.Wings.Select(wing => wing.transform.parent), Is.EqualTo(new[] { source.transform, source.transform }));
            Assert.That(m_Result.WingMeshes[0].bounds.min.x, Is.EqualTo(0.1f).Within(k_Near));
            Assert.That(m_Result.WingMeshes[1].bounds.max.x, Is.EqualTo(-0.1f).Within(k_Near));
        }
    }
}
