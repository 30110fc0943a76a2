using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    /// <summary>Commands bring problems about and take them away again, and each problem knows which joints it is about.</summary>
    public sealed class ProblemSelectionTests : EditingFixture
    {
        [Test]
        public void CoincidentJoints_AppearAndVanish_AndTheJointIsSelected()
        {
            Vector3 there = Skeleton.GetJoint(1, 3) - Skeleton.GetJoint(1, 2);
            Select((1, 2));
            Move(there);

            SkeletonProblem problem = Problem(SkeletonProblemKind.CoincidentJoints);
            Assert.That(SelectCommands.Of(Skeleton, problem), Is.EqualTo(new[] { new JointIndex(problem.Chain, problem.Joint) }));

            Editing.Select(SelectCommands.Of(Skeleton, problem));
            Do("Space Evenly");
            Assert.That(Skeleton.Validate(), Is.Empty);
        }

        [Test]
        public void CrossingChains_AppearAndVanish()
        {
            Select((1, 2));
            Move(Skeleton.GetJoint(3, 2) - Skeleton.GetJoint(1, 2) + new Vector3(0f, 0f, -0.02f));
            Assert.That(Problem(SkeletonProblemKind.CrossingChains).Chain, Is.GreaterThan(0));

            Undo.Undo();
            Assert.That(Skeleton.Validate(), Is.Empty);
        }

        [Test]
        public void PrincipalChainNotLeading_Vanishes_WhenTheOrderIsReversed()
        {
            Do("Reverse Chains");
            SkeletonProblem problem = Problem(SkeletonProblemKind.PrincipalChainNotLeading);
            Assert.That(SelectCommands.Of(Skeleton, problem), Is.EqualTo(Enumerable.Range(0, 5).Select(j => new JointIndex(0, j))));

            Do("Reverse Chains");
            Assert.That(Skeleton.Validate(), Is.Empty);
        }

        [Test]
        public void InvalidAxes_Vanish_WhenTheyAreFitted()
        {
            Skeleton.SpanAxis = -Skeleton.SpanAxis;
            SkeletonProblem problem = Problem(SkeletonProblemKind.InvalidAxes);
            Assert.That(SelectCommands.Of(Skeleton, problem), Has.Count.EqualTo(25), "it is about the whole skeleton");

            Do("Fit Axes");
            Assert.That(Skeleton.Validate(), Is.Empty);
        }

        [Test]
        public void UnequalCounts_SelectTheChain_AndVanish_WhenMended()
        {
            Skeleton.Chains[2].joints = Skeleton.Chains[2].joints.Take(4).ToArray();
            SkeletonProblem problem = Problem(SkeletonProblemKind.UnequalJointCounts);
            Assert.That(SelectCommands.Of(Skeleton, problem), Is.EqualTo(Enumerable.Range(0, 4).Select(j => new JointIndex(2, j))));

            Do("Mend");
            Assert.That(Skeleton.Validate(), Is.Empty);
        }

        private SkeletonProblem Problem(SkeletonProblemKind kind)
        {
            SkeletonProblem[] found = Skeleton.Validate().Where(problem => problem.Kind == kind).ToArray();
            Assert.That(found, Is.Not.Empty, $"{kind} among {string.Join(" ", Skeleton.Validate())}");
            return found[0];
        }

        private void Move(Vector3 delta) => Editing.Do("Move", (draft, selected) => MoveCommands.By(draft, selected, delta));
    }
}
