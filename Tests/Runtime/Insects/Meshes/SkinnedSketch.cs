using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>A skinned insect: bones turned and scaled in all ways, and a renderer that is not where its mesh is drawn.</summary>
    public sealed class SkinnedSketch : IDisposable
    {
        private readonly InsectSketch m_Insect = new InsectSketch();
        private readonly List<Transform> m_Bones = new List<Transform>();

        public SkinnedSketch()
        {
            Root.localScale = 1.5f * Vector3.one;
        }

        public Transform Root => m_Insect.Root;

        public SkinnedMeshRenderer Renderer { get; private set; }

        public IReadOnlyList<Transform> Bones => m_Bones;

        /// <summary>A bone below others, by their names with slashes between.</summary>
        public Transform Bone(string path, Vector3 position = default, Quaternion? rotation = null, float scale = 1f)
        {
            Transform bone = m_Insect.Place("Rig/" + path);
            bone.localPosition = position;
            bone.localRotation = rotation ?? Quaternion.Euler(20f, -50f, 110f);
            bone.localScale = scale * Vector3.one;
            m_Bones.Add(bone);
            return bone;
        }

        /// <summary>Binds a mesh, which is in the insect's space, to the bones as they are.</summary>
        /// <param name="name">Of the renderer.</param>
        /// <param name="sketch">The mesh; gets the number of each vertex as its first texture coordinate.</param>
        /// <param name="weights">The weights of bones at a place.</param>
        /// <param name="materials">Names.</param>
        public SkinnedMeshRenderer Skin(string name, MeshSketch sketch, Func<Vector3, BoneWeight> weights, params string[] materials)
        {
            Mesh mesh = m_Insect.Mesh(sketch);
            var numbers = new Vector2[mesh.vertexCount];
            for (int vertex = 0; vertex < numbers.Length; vertex++)
                numbers[vertex] = new Vector2(vertex, 0.5f);
            mesh.uv = numbers;
            mesh.tangents = Array.ConvertAll(mesh.vertices, _ => new Vector4(0.6f, 0f, 0.8f, -1f));
            if (m_Bones.Count > 0)
            {
                mesh.boneWeights = Array.ConvertAll(mesh.vertices, p => weights(p));
                mesh.bindposes = m_Bones.ConvertAll(bone => bone.worldToLocalMatrix * Root.localToWorldMatrix).ToArray();
            }

            Renderer = m_Insect.Place(name).gameObject.AddComponent<SkinnedMeshRenderer>();
            Renderer.transform.localPosition = new Vector3(7f, 8f, 9f);
            Renderer.sharedMesh = mesh;
            Renderer.bones = m_Bones.ToArray();
            Renderer.rootBone = m_Bones.Count > 0 ? m_Bones[0] : null;
            Renderer.sharedMaterials = Array.ConvertAll(materials.Length > 0 ? materials : new[] { "Default" }, m_Insect.Material);
            return Renderer;
        }

        /// <summary>Full weight of one bone.</summary>
        public static BoneWeight One(int bone) => new BoneWeight { boneIndex0 = bone, weight0 = 1f };

        /// <summary>Weight of two bones; the share is the second's.</summary>
        public static BoneWeight Two(int first, int second, float share) =>
            new BoneWeight { boneIndex0 = first, weight0 = 1f - share, boneIndex1 = second, weight1 = share };

        /// <summary>Moves and turns all bones.</summary>
        public void Move(int seed)
        {
            var random = new System.Random(seed);
            float Any(float size) => size * (2f * (float)random.NextDouble() - 1f);
            foreach (Transform bone in m_Bones)
            {
                bone.localPosition += new Vector3(Any(0.3f), Any(0.3f), Any(0.3f));
                bone.localRotation *= Quaternion.Euler(Any(60f), Any(60f), Any(60f));
            }
        }

        /// <summary>Vertices of a mesh by linear blend skinning, world space.</summary>
        public Vector3[] Posed(Mesh mesh)
        {
            Vector3[] positions = mesh.vertices;
            BoneWeight[] weights = mesh.boneWeights;
            Matrix4x4[] binds = mesh.bindposes;
            for (int vertex = 0; vertex < positions.Length; vertex++)
            {
                Vector3 p = positions[vertex];
                BoneWeight w = weights[vertex];
                positions[vertex] = w.weight0 * At(w.boneIndex0, p) + w.weight1 * At(w.boneIndex1, p)
                    + w.weight2 * At(w.boneIndex2, p) + w.weight3 * At(w.boneIndex3, p);
            }

            return positions;

            Vector3 At(int bone, Vector3 p) => (Renderer.bones[bone].localToWorldMatrix * binds[bone]).MultiplyPoint3x4(p);
        }

        public void Dispose() => m_Insect.Dispose();
    }
}
