using System;
using System.Collections.Generic;

namespace Alate.Editor
{
    /// <summary>Key of a picture over a wing, which tells whether the picture must be rebuilt.</summary>
    internal readonly struct OverlayKey : IEquatable<OverlayKey>
    {
        private readonly SkeletonTarget m_Target;
        private readonly uint m_Skeleton;
        private readonly RigColourMode? m_Colours;
        private readonly int m_Selection;
        private readonly int m_Preset;

        public OverlayKey(SkeletonTarget target, uint skeletonHash)
            : this(target, skeletonHash, null, 0, 0)
        {
        }

        private OverlayKey(SkeletonTarget target, uint skeletonHash, RigColourMode? colours, int selection, int preset)
        {
            m_Target = target;
            m_Skeleton = skeletonHash;
            m_Colours = colours;
            m_Selection = selection;
            m_Preset = preset;
        }

        /// <summary>Key with the values that colours depend on too.</summary>
        public OverlayKey With(RigColourMode? colours, IReadOnlyList<JointIndex> selected, int preset)
        {
            var selection = new HashCode();
            foreach (JointIndex joint in selected)
                selection.Add(joint);
            return new OverlayKey(m_Target, m_Skeleton, colours, selection.ToHashCode(), preset);
        }

        public bool Equals(OverlayKey other) =>
            m_Target == other.m_Target && m_Skeleton == other.m_Skeleton && m_Colours == other.m_Colours
            && m_Selection == other.m_Selection && m_Preset == other.m_Preset;

        public override bool Equals(object obj) => obj is OverlayKey other && Equals(other);

        public override int GetHashCode() => (int)m_Skeleton ^ m_Selection;
    }
}
