using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;

namespace Alate
{
    /// <summary>Finds the problems of a skeleton: first numbers and values, then, when those are right, places.</summary>
    internal static class SkeletonValidation
    {
        public static List<SkeletonProblem> Run(WingSkeleton skeleton)
        {
            var problems = new List<SkeletonProblem>();
            CheckVersion(skeleton, problems);
            CheckCounts(skeleton.Chains, problems);
            CheckFinite(skeleton, problems);
            CheckStiffness(skeleton.Chains, problems);
            if (!WingAxes.TryMake(skeleton.SpanAxis, skeleton.UpAxis, out float3x3 axes))
            {
                Add(problems, SkeletonProblemKind.InvalidAxes,
                    "The span and up axes must be finite, not zero and not parallel.");
            }

            if (problems.Count == 0)
                SkeletonShape.Check(new SkeletonPlan(skeleton, axes), problems);
            return problems;
        }

        private static void CheckVersion(WingSkeleton skeleton, List<SkeletonProblem> problems)
        {
            if (skeleton.Version != WingSkeleton.CurrentVersion)
            {
                Add(problems, SkeletonProblemKind.UnsupportedVersion,
                    $"The skeleton has version {skeleton.Version}; this package reads version {WingSkeleton.CurrentVersion}.");
            }
        }

        private static void CheckCounts(JointChain[] chains, List<SkeletonProblem> problems)
        {
            if (chains.Length < WingSkeleton.MinChains)
            {
                Add(problems, SkeletonProblemKind.TooFewChains,
                    $"The skeleton has {Count(chains.Length, "chain")}; a wing needs at least {WingSkeleton.MinChains}.");
            }

            if (chains.Length > WingSkeleton.MaxChains)
            {
                Add(problems, SkeletonProblemKind.TooManyChains,
                    $"The skeleton has {chains.Length} chains; a wing has at most {WingSkeleton.MaxChains}.");
            }

            for (int i = 0; i < chains.Length; i++)
            {
                int joints = chains[i].Length;
                if (joints < WingSkeleton.MinJoints)
                {
                    Add(problems, SkeletonProblemKind.TooFewJoints,
                        $"Chain {i} has {Count(joints, "joint")}; a chain needs at least {WingSkeleton.MinJoints}.", i);
                }

                if (joints > WingSkeleton.MaxJoints)
                {
                    Add(problems, SkeletonProblemKind.TooManyJoints,
                        $"Chain {i} has {joints} joints; a chain has at most {WingSkeleton.MaxJoints}.", i);
                }

                if (joints != chains[0].Length)
                {
                    Add(problems, SkeletonProblemKind.UnequalJointCounts,
                        $"Chain {i} has {Count(joints, "joint")} but chain 0 has {chains[0].Length}; all chains need the same number.", i);
                }
            }
        }

        private static void CheckFinite(WingSkeleton skeleton, List<SkeletonProblem> problems)
        {
            if (!IsFinite(skeleton.Hinge))
                Add(problems, SkeletonProblemKind.NonFinitePosition, "The hinge is not a finite position.");
            JointChain[] chains = skeleton.Chains;
            for (int i = 0; i < chains.Length; i++)
            {
                for (int j = 0; j < chains[i].Length; j++)
                {
                    if (!IsFinite(chains[i].joints[j]))
                    {
                        Add(problems, SkeletonProblemKind.NonFinitePosition,
                            $"Joint {j} of chain {i} is not a finite position.", i, j);
                    }
                }
            }
        }

        private static void CheckStiffness(JointChain[] chains, List<SkeletonProblem> problems)
        {
            const string k_Unit = " N·m²";
            const float k_Least = ChainValues.LeastStiffness, k_Most = ChainValues.MostStiffness;
            for (int i = 0; i < chains.Length; i++)
            {
                string problem = ChainValues.FindProblem("flexural stiffness", k_Unit, chains[i].flexuralStiffness, k_Least, k_Most)
                    ?? ChainValues.FindProblem("torsional stiffness", k_Unit, chains[i].torsionalStiffness, k_Least, k_Most)
                    ?? ChainValues.FindProblem("vein width", "", chains[i].veinWidths, 0f, ChainValues.MostWidth);
                if (problem == null && ChainValues.AreGiven(chains[i].torsionalStiffness)
                    && !ChainValues.AreGiven(chains[i].flexuralStiffness))
                {
                    problem = "has a torsional stiffness but no flexural stiffness; give both, or the flexural one alone";
                }
                if (problem != null)
                    Add(problems, SkeletonProblemKind.InvalidStiffness, $"Chain {i} {problem}.", i);
            }
        }

        private static bool IsFinite(Vector3 v) => math.all(math.isfinite((float3)v));

        private static string Count(int number, string what) => number == 1 ? $"1 {what}" : $"{number} {what}s";

        private static void Add(
            List<SkeletonProblem> problems, SkeletonProblemKind kind, string message,
            int chain = SkeletonProblem.None, int joint = SkeletonProblem.None) =>
            problems.Add(new SkeletonProblem(kind, chain, joint, message));
    }
}
