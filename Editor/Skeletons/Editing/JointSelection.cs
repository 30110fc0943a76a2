using System.Collections.Generic;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>
    /// Selected joints of one skeleton. An object of its own, never saved, so that undo brings selections back together with the joints.
    /// Changed through <see cref="SkeletonEditing"/> only, which records it first.
    /// </summary>
    internal sealed class JointSelection : ScriptableObject
    {
        [SerializeField] private WingSkeleton m_Skeleton;
        [SerializeField] private List<JointIndex> m_Joints = new List<JointIndex>();

        /// <summary>Skeleton of the joints.</summary>
        public WingSkeleton Skeleton => m_Skeleton;

        /// <summary>
        /// Selected joints, chain by chain from root to tip, none twice. May name joints that undo or other tools have removed.
        /// </summary>
        public IReadOnlyList<JointIndex> Joints => m_Joints;

        /// <summary>
        /// Finds or makes the selection of a skeleton: one object as long as the skeleton lives, so that undo still finds it after the tool
        /// was left and taken up again, and after scripts were compiled.
        /// </summary>
        public static JointSelection Of(WingSkeleton skeleton)
        {
            JointSelection found = null;
            foreach (JointSelection known in Resources.FindObjectsOfTypeAll<JointSelection>())
            {
                if (known.m_Skeleton == null)
                    DestroyImmediate(known);
                else if (known.m_Skeleton == skeleton)
                    found = known;
            }

            return found != null ? found : Create(skeleton);
        }

        /// <summary>A new empty selection.</summary>
        public static JointSelection Create(WingSkeleton skeleton)
        {
            JointSelection selection = CreateInstance<JointSelection>();
            selection.hideFlags = HideFlags.HideAndDontSave;
            selection.name = "Joint Selection";
            selection.m_Skeleton = skeleton;
            return selection;
        }

        /// <summary>Returns true where the joint is selected.</summary>
        public bool Contains(JointIndex joint) => m_Joints.BinarySearch(joint) >= 0;

        /// <summary>Selected joints that exist in the skeleton.</summary>
        public JointIndex[] Living()
        {
            var living = new List<JointIndex>(m_Joints.Count);
            foreach (JointIndex joint in m_Joints)
            {
                if (m_Skeleton != null && joint.IsIn(m_Skeleton))
                    living.Add(joint);
            }

            return living.ToArray();
        }

        /// <summary>Returns true where exactly these joints are selected, in any order.</summary>
        public bool IsSame(IEnumerable<JointIndex> joints) => new SortedSet<JointIndex>(joints).SetEquals(m_Joints);

        /// <summary>Selects these joints and no others.</summary>
        public void Set(IEnumerable<JointIndex> joints)
        {
            var sorted = new SortedSet<JointIndex>(joints);
            m_Joints.Clear();
            m_Joints.AddRange(sorted);
        }
    }
}
