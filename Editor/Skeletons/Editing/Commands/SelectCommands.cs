using System.Collections.Generic;

namespace Alate.Editor
{
    /// <summary>Selections derived from others.</summary>
    internal static class SelectCommands
    {
        /// <summary>Selects all joints of the chains of some joints.</summary>
        public static List<JointIndex> Chains(WingSkeleton skeleton, IReadOnlyList<JointIndex> joints) =>
            Where(skeleton, candidate => Any(joints, joint => joint.chain == candidate.chain));

        /// <summary>Selects the joints at an equal place in every chain.</summary>
        public static List<JointIndex> Rows(WingSkeleton skeleton, IReadOnlyList<JointIndex> joints) =>
            Where(skeleton, candidate => Any(joints, joint => joint.joint == candidate.joint));

        /// <summary>Selects all other joints.</summary>
        public static List<JointIndex> Others(WingSkeleton skeleton, IReadOnlyList<JointIndex> joints) =>
            Where(skeleton, candidate => !Any(joints, joint => joint == candidate));

        /// <summary>Selects the joints that a problem is about; all where it is about none in particular.</summary>
        public static List<JointIndex> Of(WingSkeleton skeleton, SkeletonProblem problem) =>
            Where(skeleton, candidate =>
                (problem.Chain == SkeletonProblem.None || problem.Chain == candidate.chain)
                && (problem.Joint == SkeletonProblem.None || problem.Joint == candidate.joint));

        private static List<JointIndex> Where(WingSkeleton skeleton, System.Predicate<JointIndex> holds)
        {
            var found = new List<JointIndex>();
            foreach (JointIndex joint in JointPicking.All(skeleton))
            {
                if (holds(joint))
                    found.Add(joint);
            }

            return found;
        }

        private static bool Any(IReadOnlyList<JointIndex> joints, System.Predicate<JointIndex> holds)
        {
            foreach (JointIndex joint in joints)
            {
                if (holds(joint))
                    return true;
            }

            return false;
        }
    }
}
