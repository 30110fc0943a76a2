using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;

namespace Alate
{
    /// <summary>Tells whether skeletons were edited, by their content.</summary>
    internal sealed class SkeletonWatch
    {
        private readonly Dictionary<WingSkeleton, uint> m_Hashes = new Dictionary<WingSkeleton, uint>();
        private readonly List<WingSkeleton> m_Known = new List<WingSkeleton>();

        /// <summary>A number that changes with the skeleton's content, as of the last <see cref="Refresh"/>; 0 for none.</summary>
        public uint HashOf(WingSkeleton skeleton)
        {
            if (skeleton == null)
                return 0;
            if (!m_Hashes.TryGetValue(skeleton, out uint hash))
            {
                m_Hashes.Add(skeleton, hash = Hash(skeleton));
                m_Known.Add(skeleton);
            }

            return hash;
        }

        /// <summary>Reads all known skeletons again.</summary>
        public void Refresh()
        {
            foreach (WingSkeleton skeleton in m_Known)
            {
                if (skeleton != null)
                    m_Hashes[skeleton] = Hash(skeleton);
            }
        }

        private static uint Hash(WingSkeleton skeleton)
        {
            uint hash = Mix(Mix(Mix(1u, skeleton.Hinge), skeleton.SpanAxis), skeleton.UpAxis);
            foreach (JointChain chain in skeleton.Chains)
            {
                hash = hash * 31u + (uint)chain.Length;
                for (int joint = 0; joint < chain.Length; joint++)
                    hash = Mix(hash, chain.joints[joint]);
            }

            return hash == 0 ? 1u : hash;
        }

        private static uint Mix(uint hash, Vector3 point)
        {
            uint3 bits = math.asuint((float3)point);
            return ((hash * 0x9E3779B1u + bits.x) * 0x85EBCA77u + bits.y) * 0xC2B2AE3Du + bits.z;
        }
    }
}
