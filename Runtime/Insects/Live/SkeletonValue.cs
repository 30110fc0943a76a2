using Unity.Mathematics;
using UnityEngine;

namespace Alate
{
    /// <summary>A number that changes with a skeleton's content, computed once a frame however many wings share it.</summary>
    internal sealed class SkeletonValue : WatchedValue
    {
        private readonly WingSkeleton m_Skeleton;
        private uint m_Hash, m_Checked;
        private string m_Problem;

        /// <param name="skeleton">May be null.</param>
        public SkeletonValue(WingSkeleton skeleton)
        {
            m_Skeleton = skeleton;
            Refresh();
        }

        /// <summary>Hash of the skeleton's content; 0 for no skeleton.</summary>
        public uint Hash
        {
            get
            {
                Use();
                return m_Hash;
            }
        }

        /// <summary>First reason why the skeleton cannot be used, a sentence, found once for a content; null where there is none.</summary>
        public string Problem
        {
            get
            {
                if (m_Skeleton == null)
                    return null;
                if (m_Checked != Hash)
                    m_Problem = InsectCheck.ProblemOf(m_Skeleton);
                m_Checked = Hash;
                return m_Problem;
            }
        }

        /// <inheritdoc/>
        public override void Refresh()
        {
            if (m_Skeleton == null)
                return;
            uint hash = Mix(Mix(Mix(1u, m_Skeleton.Hinge), m_Skeleton.SpanAxis), m_Skeleton.UpAxis);
            foreach (JointChain chain in m_Skeleton.Chains)
            {
                hash = hash * 31u + (uint)chain.Length;
                for (int joint = 0; joint < chain.Length; joint++)
                    hash = Mix(hash, chain.joints[joint]);
                hash = Mix(Mix(Mix(hash, chain.flexuralStiffness, 1u), chain.torsionalStiffness, 2u), chain.veinWidths, 3u);
            }

            m_Hash = hash == 0 ? 1u : hash;
        }

        private static uint Mix(uint hash, float[] values, uint kind)
        {
            for (int k = 0; values != null && k < values.Length; k++)
                hash = Spread((hash * 0x9E3779B1u + math.asuint(values[k])) * 0x85EBCA77u + kind);
            return hash;
        }

        // Round numbers differ in their highest bits alone, which products leave where they are.
        private static uint Spread(uint hash) => hash ^ hash >> 15;

        private static uint Mix(uint hash, Vector3 point)
        {
            uint3 bits = math.asuint((float3)point);
            return Spread((Spread(hash * 0x9E3779B1u + bits.x) * 0x85EBCA77u + bits.y) * 0xC2B2AE3Du + bits.z);
        }
    }
}
