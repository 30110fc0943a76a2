using System;
using UnityEngine;

namespace Alate
{
    /// <summary>
    /// Key of a template: a mesh, the wings on it, the number of patches that meet the air, and whether it has smaller parts.
    /// </summary>
    internal sealed class TemplateKey
    {
        private readonly Mesh m_Mesh;
        private readonly int m_Patches;
        private readonly bool m_Smaller;
        private readonly WingKey[] m_Wings;
        private readonly AutomaticSkeleton m_Automatic;

        public TemplateKey(Mesh mesh, int patches, bool smaller, WingKey[] wings, in AutomaticSkeleton automatic)
        {
            m_Automatic = automatic;
            m_Mesh = mesh;
            m_Patches = patches;
            m_Smaller = smaller;
            m_Wings = wings;
        }

        public bool Matches(TemplateKey other)
        {
            if (!ReferenceEquals(m_Mesh, other.m_Mesh) || m_Patches != other.m_Patches || m_Smaller != other.m_Smaller
                || m_Wings.Length != other.m_Wings.Length)
            {
                return false;
            }

            for (int w = 0; w < m_Wings.Length; w++)
            {
                if (!m_Wings[w].Equals(other.m_Wings[w]) || (m_Wings[w].IsAutomatic && !m_Automatic.Matches(other.m_Automatic)))
                    return false;
            }

            return true;
        }

        /// <summary>Part of the mesh, and its skeleton with the hash of its content.</summary>
        public readonly struct WingKey : IEquatable<WingKey>
        {
            private readonly WingPart m_Part;
            private readonly int m_Submesh;
            private readonly Vector3 m_Point;
            private readonly WingSkeleton m_Skeleton;
            private readonly bool m_HadNone;
            private readonly uint m_SkeletonHash;

            public WingKey(Wing wing, uint skeletonHash)
            {
                m_Part = wing.Part;
                m_Submesh = wing.Part == WingPart.Submesh ? wing.Submesh : 0;
                m_Point = wing.Part == WingPart.ConnectedPart ? wing.Point : Vector3.zero;
                m_Skeleton = wing.Skeleton;
                m_HadNone = m_Skeleton == null;
                m_SkeletonHash = skeletonHash;
            }

            /// <summary>True where the wing has no skeleton of its own.</summary>
            public bool IsAutomatic => m_Skeleton == null;

            /// <summary>Returns true where a wing still matches the key.</summary>
            public bool Describes(Wing wing, uint skeletonHash) =>
                IsSame(wing.Skeleton) && m_SkeletonHash == skeletonHash && Equals(new WingKey(wing, skeletonHash));

            public bool Equals(WingKey other) =>
                m_Part == other.m_Part && m_Submesh == other.m_Submesh && m_Point == other.m_Point
                && m_SkeletonHash == other.m_SkeletonHash && IsSame(other.m_Skeleton);

            // In the editor an empty field holds an object that only equals null, and another one after each edit.
            private bool IsSame(WingSkeleton skeleton) => ReferenceEquals(m_Skeleton, skeleton) || (m_HadNone && skeleton == null);
        }
    }
}
