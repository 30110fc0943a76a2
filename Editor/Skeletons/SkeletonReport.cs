using System.Collections.Generic;

namespace Alate.Editor
{
    /// <summary>Content of the inspector of the selected skeletons. Texts only, so that it can be tested without a window.</summary>
    internal sealed class SkeletonReport
    {
        /// <summary>Largest number of listed problems; a skeleton with broken numbers has hundreds.</summary>
        public const int MaxProblems = 8;

        private SkeletonReport(string size, List<string> problems, int hidden)
        {
            Size = size;
            Problems = problems;
            HiddenProblems = hidden;
        }

        /// <summary>Chains and joints: "5 chains of 5 joints"; "—" where the selected ones differ.</summary>
        public string Size { get; }

        /// <summary>One line a problem, at most <see cref="MaxProblems"/>; with the skeleton's name where several are selected.</summary>
        public IReadOnlyList<string> Problems { get; }

        /// <summary>Number of problems beyond those listed.</summary>
        public int HiddenProblems { get; }

        /// <summary>Reports on the selected skeletons.</summary>
        public static SkeletonReport Of(IReadOnlyList<WingSkeleton> skeletons)
        {
            var problems = new List<string>();
            string size = null;
            int found = 0;
            foreach (WingSkeleton skeleton in skeletons)
            {
                string own = Describe(skeleton);
                size = size == null || size == own ? own : "—";
                foreach (SkeletonProblem problem in skeleton.Validate())
                {
                    if (++found <= MaxProblems)
                        problems.Add(skeletons.Count == 1 ? problem.Message : $"{skeleton.name}: {problem.Message}");
                }
            }

            return new SkeletonReport(size ?? "", problems, found - problems.Count);
        }

        private static string Describe(WingSkeleton skeleton) =>
            skeleton.ChainCount == 0 ? "no chains" : $"{skeleton.ChainCount} chains of {skeleton.JointsPerChain} joints";
    }
}
