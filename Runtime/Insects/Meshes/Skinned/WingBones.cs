using System;
using UnityEngine;

namespace Alate
{
    /// <summary>Bones of a skinned mesh: their weights at its vertices, and the bones that are named wings.</summary>
    internal sealed class WingBones
    {
        private readonly Transform[] m_Bones;
        private readonly BoneWeight[] m_Weights;
        private readonly WingName[] m_Names;

        /// <param name="source">A renderer with a readable mesh.</param>
        /// <param name="insect">Above all of its bones; its name does not count.</param>
        public WingBones(SkinnedMeshRenderer source, Transform insect)
        {
            m_Bones = source.bones;
            m_Weights = source.sharedMesh.boneWeights;
            m_Names = Array.ConvertAll(m_Bones, bone => NameOf(bone, insect, m_Bones));
        }

        /// <summary>True where the mesh is moved by bones, not by its own transform.</summary>
        public bool IsSkinned => m_Weights.Length > 0;

        /// <summary>Number of bones.</summary>
        public int Count => m_Bones.Length;

        /// <summary>Transform of a bone; may be missing.</summary>
        public Transform this[int bone] => m_Bones[bone];

        /// <summary>Meaning of the name of a bone, or of its nearest parent that is named a wing.</summary>
        public WingName Name(int bone) => m_Names[bone];

        /// <summary>
        /// Returns true where most of the weight at the three corners is that of bones that are named wings, or of their children.
        /// </summary>
        public bool IsWing(int a, int b, int c) => WingWeight(a) + WingWeight(b) + WingWeight(c) > 1.5f;

        /// <summary>Adds the weights at a vertex to sums by bone.</summary>
        public void AddWeights(int vertex, float[] sums)
        {
            BoneWeight weights = m_Weights[vertex];
            Add(weights.boneIndex0, weights.weight0, sums);
            Add(weights.boneIndex1, weights.weight1, sums);
            Add(weights.boneIndex2, weights.weight2, sums);
            Add(weights.boneIndex3, weights.weight3, sums);
        }

        /// <summary>
        /// The first bone of the wing that a bone moves: the wings of finer rigs have several, which all hang from the first.
        /// </summary>
        public int RootOf(int bone)
        {
            int root = bone;
            for (Transform place = m_Bones[bone].parent; place != null; place = place.parent)
            {
                int above = Array.IndexOf(m_Bones, place);
                if (above < 0)
                    continue;
                if (!IsSameWing(m_Names[above], m_Names[root]))
                    break;
                root = above;
            }

            return root;
        }

        // Bones above without a side move both wings, those without a pair move fore and hind wing.
        private static bool IsSameWing(WingName above, WingName below) =>
            above.NamesWing && above.Side != null && above.Side == below.Side && above.Pair == below.Pair;

        // Of objects above that are no bones, such as the rig, only those with a side speak for a wing.
        private static WingName NameOf(Transform bone, Transform insect, Transform[] bones)
        {
            for (Transform place = bone; place != null && place != insect; place = place.parent)
            {
                var name = WingName.Read(place.name);
                if (name.IsCase || (name.NamesWing && (name.Side != null || Array.IndexOf(bones, place) >= 0)))
                    return name;
            }

            return default;
        }

        private float WingWeight(int vertex)
        {
            BoneWeight weights = m_Weights[vertex];
            return WingWeight(weights.boneIndex0, weights.weight0) + WingWeight(weights.boneIndex1, weights.weight1)
                + WingWeight(weights.boneIndex2, weights.weight2) + WingWeight(weights.boneIndex3, weights.weight3);
        }

        private float WingWeight(int bone, float weight) => bone < m_Names.Length && m_Names[bone].NamesWing ? weight : 0f;

        private static void Add(int bone, float weight, float[] sums)
        {
            if (bone < sums.Length)
                sums[bone] += weight;
        }
    }
}
