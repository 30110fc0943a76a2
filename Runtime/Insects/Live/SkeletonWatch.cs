using System.Collections.Generic;

namespace Alate
{
    /// <summary>The skeletons in use, each read once a frame to see whether it was edited.</summary>
    internal sealed class SkeletonWatch
    {
        private readonly Dictionary<WingSkeleton, SkeletonValue> m_Values = new Dictionary<WingSkeleton, SkeletonValue>();
        private readonly List<SkeletonValue> m_All = new List<SkeletonValue>();
        private readonly SkeletonValue m_None = new SkeletonValue(null);

        /// <summary>What stands for a skeleton's content.</summary>
        public SkeletonValue Of(WingSkeleton skeleton)
        {
            if (skeleton == null)
                return m_None;
            if (!m_Values.TryGetValue(skeleton, out SkeletonValue value))
            {
                m_Values.Add(skeleton, value = new SkeletonValue(skeleton));
                m_All.Add(value);
            }

            return value;
        }

        /// <summary>Reads all skeletons again.</summary>
        public void Refresh()
        {
            foreach (SkeletonValue value in m_All)
                value.Refresh();
        }
    }
}
