using System;
using System.Collections.Generic;
using Alate.Geometry;

namespace Alate
{
    /// <summary>Checks how the joints of a skeleton with complete, finite chains lie to one another.</summary>
    internal static class SkeletonShape
    {
        /// <summary>Joints closer than this share of the skeleton's size count as one place: no bone or spring may be that short.</summary>
        private const double k_Coincidence = 1e-4;

        /// <summary>Bones closer than this share of the skeleton's size count as meeting.</summary>
        private const double k_Touch = 1e-6;

        /// <summary>Sine between bone and up axis below which a bone stands upright and has no bend axis.</summary>
        private const double k_LeastBoneSine = 0.02;

        /// <summary>Height over chordwise extent of the joints above which the up axis must be wrong.</summary>
        private const double k_UprightRatio = 4.0;

        /// <summary>Area, as a share of the squared size, below which a strip between chains is empty.</summary>
        private const double k_LeastArea = 1e-6;

        /// <summary>
        /// Least length of the principal chain over the last one's, in length and in span; a shorter one means a reversed order, because
        /// the principal chain reaches the wing tip (Sec. 4.1). A left wing is a mirrored right one, so nothing else tells the edges apart.
        /// </summary>
        private const double k_ShortPrincipalChain = 0.7;

        public static void Check(SkeletonPlan plan, List<SkeletonProblem> problems)
        {
            bool distinct = CheckDistinct(plan, problems);
            CheckAxes(plan, problems);
            if (distinct)
                CheckCrossings(plan, problems);
            CheckOrder(plan, problems);
        }

        private static bool CheckDistinct(SkeletonPlan plan, List<SkeletonProblem> problems)
        {
            int joints = plan.JointsPerChain, before = problems.Count;
            double least = k_Coincidence * k_Coincidence * plan.Size * plan.Size;
            for (int b = 1; b < plan.ChainCount * joints; b++)
            {
                for (int a = 0; a < b; a++)
                {
                    bool roots = a % joints == 0 && b % joints == 0;
                    if (roots || plan.DistanceSquared(a, b) > least)
                        continue;
                    Add(problems, SkeletonProblemKind.CoincidentJoints, b / joints, b % joints,
                        $"Joint {b % joints} of chain {b / joints} lies at the same place as joint {a % joints} of chain {a / joints}.");
                    break;
                }
            }

            return problems.Count == before;
        }

        private static void CheckAxes(SkeletonPlan plan, List<SkeletonProblem> problems)
        {
            int joints = plan.JointsPerChain;
            double reach = 0.0;
            for (int i = 0; i < plan.ChainCount; i++)
            {
                reach += plan[i, joints - 1].x - plan[i, 0].x;
                for (int j = 0; j + 1 < joints; j++)
                {
                    double inPlan = (plan[i, j + 1] - plan[i, j]).LengthSquared;
                    double inSpace = plan.DistanceSquared(i * joints + j, i * joints + j + 1);
                    if (inSpace > 0.0 && inPlan < k_LeastBoneSine * k_LeastBoneSine * inSpace)
                    {
                        Add(problems, SkeletonProblemKind.InvalidAxes, i, j,
                            $"The bone from joint {j} to joint {j + 1} of chain {i} runs along the up axis.");
                    }
                }
            }

            if (reach <= 0.0)
                Add(problems, SkeletonProblemKind.InvalidAxes, "The span axis does not point from the roots towards the tips.");
        }

        private static void CheckCrossings(SkeletonPlan plan, List<SkeletonProblem> problems)
        {
            for (int b = 1; b < plan.ChainCount; b++)
            {
                for (int a = 0; a < b; a++)
                {
                    int bone = FirstCrossing(plan, a, b);
                    if (bone >= 0)
                        Add(problems, SkeletonProblemKind.CrossingChains, b, bone, $"Chain {b} crosses chain {a} after its joint {bone}.");
                }
            }
        }

        private static int FirstCrossing(SkeletonPlan plan, int chainA, int chainB)
        {
            double touch = k_Touch * k_Touch * plan.Size * plan.Size;
            bool sharedRoot = (plan[chainA, 0] - plan[chainB, 0]).LengthSquared <= touch;
            for (int j = 0; j + 1 < plan.JointsPerChain; j++)
            {
                for (int k = 0; k + 1 < plan.JointsPerChain; k++)
                {
                    PlanPoint a0 = plan[chainA, k], a1 = plan[chainA, k + 1], b0 = plan[chainB, j], b1 = plan[chainB, j + 1];
                    bool meet = sharedRoot && j == 0 && k == 0
                        ? PlanPoint.DistanceSquared(a1, b0, b1) <= touch || PlanPoint.DistanceSquared(b1, a0, a1) <= touch
                        : Cross(a0, a1, b0, b1, touch);
                    if (meet)
                        return j;
                }
            }

            return -1;
        }

        private static bool Cross(PlanPoint a0, PlanPoint a1, PlanPoint b0, PlanPoint b1, double touch)
        {
            PlanPoint a = a1 - a0, b = b1 - b0;
            bool apart = PlanPoint.Cross(a, b0 - a0) > 0.0 != PlanPoint.Cross(a, b1 - a0) > 0.0;
            bool across = PlanPoint.Cross(b, a0 - b0) > 0.0 != PlanPoint.Cross(b, a1 - b0) > 0.0;
            return (apart && across)
                || PlanPoint.DistanceSquared(a0, b0, b1) <= touch || PlanPoint.DistanceSquared(a1, b0, b1) <= touch
                || PlanPoint.DistanceSquared(b0, a0, a1) <= touch || PlanPoint.DistanceSquared(b1, a0, a1) <= touch;
        }

        // The strips between neighbouring chains all lie the same way round; one that does not begins or ends at a misplaced chain.
        private static void CheckOrder(SkeletonPlan plan, List<SkeletonProblem> problems)
        {
            double least = k_LeastArea * plan.Size * plan.Size;
            if (StandsUpright(plan))
            {
                Add(problems, SkeletonProblemKind.InvalidAxes, "The up axis lies in the plane of the joints; it must stand on the wing.");
                return;
            }

            double side = UsualSide(plan, least);
            bool inOrder = true;
            for (int i = 0; i + 1 < plan.ChainCount; i++)
            {
                double area = plan.StripArea(i);
                if (area * side > 0.0 && Math.Abs(area) > least)
                    continue;
                inOrder = false;
                if (i == 0 && Math.Abs(area) > least)
                {
                    AddNotLeading(problems,
                        "Chain 0 is the principal chain and must lie on the leading edge, but chain 1 lies before it.");
                }
                else
                {
                    Add(problems, SkeletonProblemKind.ChainsOutOfOrder, i + 1, SkeletonProblem.None,
                        $"Chain {i + 1} does not lie behind chain {i}.");
                }
            }

            if (inOrder && IsReversed(plan))
            {
                AddNotLeading(problems,
                    "Chain 0 is the principal chain, on the leading edge, but the last chain is far longer: is the order reversed?");
            }
        }

        private static bool StandsUpright(SkeletonPlan plan)
        {
            double lowest = double.MaxValue, highest = double.MinValue;
            for (int i = 0; i < plan.ChainCount; i++)
            {
                for (int j = 0; j < plan.JointsPerChain; j++)
                {
                    lowest = Math.Min(lowest, plan[i, j].z);
                    highest = Math.Max(highest, plan[i, j].z);
                }
            }

            return plan.HeightExtent > k_UprightRatio * (highest - lowest);
        }

        private static double UsualSide(SkeletonPlan plan, double least)
        {
            int balance = 0;
            for (int i = 0; i + 1 < plan.ChainCount; i++)
            {
                double area = plan.StripArea(i);
                if (Math.Abs(area) > least)
                    balance += Math.Sign(area);
            }

            return balance != 0 ? balance : plan.SignedArea();
        }

        private static bool IsReversed(SkeletonPlan plan)
        {
            int last = plan.ChainCount - 1, tip = plan.JointsPerChain - 1;
            PlanPoint first = plan[0, tip] - plan[0, 0], end = plan[last, tip] - plan[last, 0];
            return first.LengthSquared < k_ShortPrincipalChain * k_ShortPrincipalChain * end.LengthSquared
                && first.x < k_ShortPrincipalChain * end.x;
        }

        private static void AddNotLeading(List<SkeletonProblem> problems, string message) =>
            Add(problems, SkeletonProblemKind.PrincipalChainNotLeading, 0, SkeletonProblem.None, message);

        private static void Add(List<SkeletonProblem> problems, SkeletonProblemKind kind, string message) =>
            Add(problems, kind, SkeletonProblem.None, SkeletonProblem.None, message);

        private static void Add(List<SkeletonProblem> problems, SkeletonProblemKind kind, int chain, int joint, string message) =>
            problems.Add(new SkeletonProblem(kind, chain, joint, message));
    }
}
