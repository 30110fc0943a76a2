using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Alate.Tests
{
    /// <summary>A skinned insect with a chest bone, and what its conversion makes.</summary>
    public abstract class SkinnedWingFixture
    {
        protected const float k_Near = 2e-5f;

        protected SkinnedSketch m_Insect;
        protected SkinnedWingResult m_Result;

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
                foreach (Mesh mesh in m_Result.WingMeshes)
                    Object.DestroyImmediate(mesh);
                Object.DestroyImmediate(m_Result.BodyMesh);
            }

            m_Insect.Dispose();
        }

        // Each vertex of the wing, by the number that it carries, is drawn at its place.
        protected static void AssertDrawn(MeshRenderer wing, Vector3[] places, Predicate<int> which = null, float near = k_Near)
        {
            Mesh mesh = wing.GetComponent<MeshFilter>().sharedMesh;
            Vector2[] numbers = mesh.uv;
            Vector3[] positions = mesh.vertices;
            for (int vertex = 0; vertex < positions.Length; vertex++)
            {
                int number = (int)numbers[vertex].x;
                Vector3 drawn = wing.transform.localToWorldMatrix.MultiplyPoint3x4(positions[vertex]);
                if (which == null || which(number))
                    Assert.That((drawn - places[number]).magnitude, Is.LessThan(near), $"vertex {number}");
            }
        }

        protected int TriangleCount() =>
            m_Result.WingMeshes.Sum(mesh => mesh.triangles.Length) + (m_Result.BodyMesh != null ? m_Result.BodyMesh.triangles.Length : 0);

        protected SkinnedMeshRenderer Winged(string name, MeshSketch sketch, Func<Vector3, BoneWeight> weights)
        {
            m_Insect.Bone("chest/wing_R", Hinge(1f));
            m_Insect.Bone("chest/wing_L", Hinge(-1f), Quaternion.Euler(5f, 175f, 40f), 0.3f);
            return m_Insect.Skin(name, sketch, weights);
        }

        protected SkinnedMeshRenderer Skinned(string name, MeshSketch sketch, Func<Vector3, BoneWeight> weights, params string[] materials)
        {
            m_Insect.Bone("chest/b", Hinge(1f));
            m_Insect.Bone("chest/c", Hinge(-1f), Quaternion.Euler(5f, 175f, 40f), 0.3f);
            return m_Insect.Skin(name, sketch, weights, materials);
        }

        protected static BoneWeight Blended(Vector3 p) =>
            SkinnedSketch.Two(0, p.x > 0f ? 1 : 2, Mathf.Clamp01((Mathf.Abs(p.x) - 0.1f) / 0.2f));

        protected static Vector3 Hinge(float side) => new Vector3(0.1f * side, 0.2f, 0.2f);

        protected static MeshSketch Body() => new MeshSketch().Box(Vector3.zero, new Vector3(0.2f, 0.2f, 1f));

        protected static MeshSketch Wing(float side) => new MeshSketch().Wing(Hinge(side), side, 0.5f);

        protected static MeshSketch Wings() => Wing(1f).Wing(Hinge(-1f), -1f, 0.5f);
    }
}
