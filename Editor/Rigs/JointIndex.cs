using System;

namespace Alate.Editor
{
    /// <summary>Index of a joint of a skeleton: its chain, 0 on the leading edge, and its place in the chain, 0 at the root.</summary>
    [Serializable]
    internal struct JointIndex : IEquatable<JointIndex>, IComparable<JointIndex>
    {
        public int chain;
        public int joint;

        public JointIndex(int chain, int joint)
        {
            this.chain = chain;
            this.joint = joint;
        }

        public static bool operator ==(JointIndex a, JointIndex b) => a.Equals(b);

        public static bool operator !=(JointIndex a, JointIndex b) => !a.Equals(b);

        /// <summary>Returns true where the skeleton has this joint.</summary>
        public bool IsIn(WingSkeleton skeleton) =>
            chain >= 0 && chain < skeleton.ChainCount && joint >= 0 && joint < skeleton.Chains[chain].Length;

        public bool Equals(JointIndex other) => chain == other.chain && joint == other.joint;

        public override bool Equals(object obj) => obj is JointIndex other && Equals(other);

        public override int GetHashCode() => chain * 397 ^ joint;

        /// <summary>Orders joints chain by chain from root to tip.</summary>
        public int CompareTo(JointIndex other) => chain != other.chain ? chain.CompareTo(other.chain) : joint.CompareTo(other.joint);

        public override string ToString() => $"joint {joint} of chain {chain}";
    }
}
