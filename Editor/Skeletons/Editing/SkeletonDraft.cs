using System;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>
    /// Content of a skeleton while a command works on it: a grid of joints, so that all chains have equal counts by construction, and what
    /// was measured of each chain. Mesh space and units. A copy: nothing in it is shared with the asset but the measured values, which no
    /// command changes.
    /// </summary>
    internal sealed class SkeletonDraft
    {
        /// <summary>Largest coordinate that commands accept; squares of lengths stay well inside the range of a float.</summary>
        public const float Farthest = 1e9f;

        private readonly Vector3[,] m_Joints;
        private readonly JointChain[] m_Measured;

        public SkeletonDraft(int chains, int joints)
        {
            m_Joints = new Vector3[chains, joints];
            m_Measured = new JointChain[chains];
        }

        public Vector3 Hinge { get; set; }

        public Vector3 SpanAxis { get; set; } = Vector3.right;

        public Vector3 UpAxis { get; set; } = Vector3.up;

        public int ChainCount => m_Joints.GetLength(0);

        public int JointsPerChain => m_Joints.GetLength(1);

        public Vector3 this[int chain, int joint]
        {
            get => m_Joints[chain, joint];
            set => m_Joints[chain, joint] = value;
        }

        public Vector3 this[JointIndex index]
        {
            get => m_Joints[index.chain, index.joint];
            set => m_Joints[index.chain, index.joint] = value;
        }

        /// <summary>Reads a skeleton; refuses where its chains are no grid.</summary>
        /// <returns>Null, or one sentence for the user.</returns>
        public static string Read(WingSkeleton skeleton, out SkeletonDraft draft)
        {
            draft = null;
            if (skeleton.ChainCount == 0)
                return "The skeleton has no chains yet.";
            for (int i = 0; i < skeleton.ChainCount; i++)
            {
                if (skeleton.Chains[i].Length != skeleton.JointsPerChain || skeleton.JointsPerChain == 0)
                    return "The chains have not the same number of joints: mend the skeleton first.";
            }

            draft = new SkeletonDraft(skeleton.ChainCount, skeleton.JointsPerChain).TakeFrame(skeleton);
            for (int i = 0; i < draft.ChainCount; i++)
                draft.SetChain(i, skeleton.Chains[i].joints, skeleton.Chains[i]);

            return null;
        }

        /// <summary>Makes a copy.</summary>
        public SkeletonDraft Copy()
        {
            SkeletonDraft copy = Resized(ChainCount, JointsPerChain);
            for (int i = 0; i < ChainCount; i++)
                copy.SetChain(i, Chain(i));
            return copy;
        }

        /// <summary>
        /// Makes a draft of other counts with equal hinge and axes and all joints at the origin. With as many chains, these keep what was
        /// measured of them.
        /// </summary>
        public SkeletonDraft Resized(int chains, int joints)
        {
            var draft = new SkeletonDraft(chains, joints) { Hinge = Hinge, SpanAxis = SpanAxis, UpAxis = UpAxis };
            for (int i = 0; chains == ChainCount && i < chains; i++)
                draft.m_Measured[i] = m_Measured[i];
            return draft;
        }

        /// <summary>Takes over the hinge and axes of a skeleton.</summary>
        public SkeletonDraft TakeFrame(WingSkeleton skeleton)
        {
            Hinge = skeleton.Hinge;
            SpanAxis = skeleton.SpanAxis;
            UpAxis = skeleton.UpAxis;
            return this;
        }

        /// <summary>A chain's joints from root to tip, a copy.</summary>
        public Vector3[] Chain(int chain)
        {
            var joints = new Vector3[JointsPerChain];
            for (int j = 0; j < joints.Length; j++)
                joints[j] = this[chain, j];
            return joints;
        }

        /// <summary>Replaces a chain's joints.</summary>
        public void SetChain(int chain, Vector3[] joints)
        {
            for (int j = 0; j < joints.Length; j++)
                this[chain, j] = joints[j];
        }

        /// <summary>Replaces a chain's joints and what was measured of it.</summary>
        public void SetChain(int chain, Vector3[] joints, in JointChain measured)
        {
            SetChain(chain, joints);
            m_Measured[chain] = measured;
        }

        /// <summary>Measured values of a chain; its joints do not count.</summary>
        public JointChain Measured(int chain) => m_Measured[chain];

        /// <summary>Returns true where the same was measured of a chain as of one of another draft.</summary>
        public bool IsMeasuredAs(SkeletonDraft other, int chain) =>
            AreSame(m_Measured[chain].flexuralStiffness, other.m_Measured[chain].flexuralStiffness)
            && AreSame(m_Measured[chain].torsionalStiffness, other.m_Measured[chain].torsionalStiffness)
            && AreSame(m_Measured[chain].veinWidths, other.m_Measured[chain].veinWidths);

        /// <summary>Makes the skeleton equal to this draft, in new arrays.</summary>
        public void WriteTo(WingSkeleton skeleton)
        {
            var chains = new JointChain[ChainCount];
            for (int i = 0; i < chains.Length; i++)
            {
                chains[i] = m_Measured[i];
                chains[i].joints = Chain(i);
            }

            skeleton.Chains = chains;
            skeleton.Hinge = Hinge;
            skeleton.SpanAxis = SpanAxis;
            skeleton.UpAxis = UpAxis;
        }

        /// <summary>
        /// Reason why no skeleton may become like this: a count out of range or a position that is not usable. Null when it may.
        /// </summary>
        public string FindFault()
        {
            if (ChainCount < WingSkeleton.MinChains || ChainCount > WingSkeleton.MaxChains)
                return $"A wing has {WingSkeleton.MinChains} to {WingSkeleton.MaxChains} chains, not {ChainCount}.";
            if (JointsPerChain < WingSkeleton.MinJoints || JointsPerChain > WingSkeleton.MaxJoints)
                return $"A chain has {WingSkeleton.MinJoints} to {WingSkeleton.MaxJoints} joints, not {JointsPerChain}.";
            if (!IsUsable(Hinge))
                return "The hinge would not be a usable position.";
            if (!IsUsable(SpanAxis) || !IsUsable(UpAxis))
                return "The axes would not be usable directions.";
            for (int i = 0; i < ChainCount; i++)
            {
                for (int j = 0; j < JointsPerChain; j++)
                {
                    if (!IsUsable(this[i, j]))
                        return $"Joint {j} of chain {i} would not be at a usable position.";
                }
            }

            return null;
        }

        /// <summary>Returns true where all numbers are equal, bit for bit but for the sign of zero.</summary>
        public bool IsSame(SkeletonDraft other)
        {
            bool same = other != null && ChainCount == other.ChainCount && JointsPerChain == other.JointsPerChain
                && Hinge.Equals(other.Hinge) && SpanAxis.Equals(other.SpanAxis) && UpAxis.Equals(other.UpAxis);
            for (int i = 0; same && i < ChainCount; i++)
            {
                same = IsMeasuredAs(other, i);
                for (int j = 0; same && j < JointsPerChain; j++)
                    same = this[i, j].Equals(other[i, j]);
            }

            return same;
        }

        private static bool AreSame(float[] a, float[] b) => new ReadOnlySpan<float>(a).SequenceEqual(new ReadOnlySpan<float>(b));

        /// <summary>Returns true where all components are finite and none is beyond <see cref="Farthest"/>.</summary>
        public static bool IsUsable(Vector3 v) => math.all(math.abs((float3)v) <= Farthest);
    }
}
