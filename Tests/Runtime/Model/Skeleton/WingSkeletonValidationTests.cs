using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    public sealed class WingSkeletonValidationTests
    {
        [TestCase(3, 3)]
        [TestCase(5, 5)]
        [TestCase(16, 16)]
        public void AFan_IsValid(int chains, int joints)
        {
            Assert.That(TestWings.Fan(chains, joints).Validate(), Is.Empty);
        }

        [Test]
        public void ParallelChains_AreValid()
        {
            Assert.That(TestWings.Lattice().Validate(), Is.Empty);
        }

        [Test]
        public void ChainsFromOneSharedRoot_AreValid()
        {
            WingSkeleton skeleton = TestWings.Fan();
            for (int i = 1; i < skeleton.ChainCount; i++)
                skeleton.Chains[i].joints[0] = skeleton.GetJoint(0, 0);

            Assert.That(skeleton.Validate(), Is.Empty);
        }

        [Test]
        public void TheMirrorImageOfAValidSkeleton_IsValid()
        {
            Assert.That(Mirrored(TestWings.Fan()).Validate(), Is.Empty);
        }

        [Test]
        public void TheSizeOfASkeleton_DoesNotMatter([Values(1e-20f, 1e-6f, 1e6f, 1e20f)] float scale)
        {
            Assert.That(Scaled(TestWings.Fan(), scale).Validate(), Is.Empty);
        }

        [Test]
        public void ANewSkeleton_HasTooFewChains()
        {
            WingSkeleton skeleton = ScriptableObject.CreateInstance<WingSkeleton>();

            Assert.That(Kinds(skeleton), Is.EqualTo(new[] { SkeletonProblemKind.TooFewChains }));
        }

        [Test]
        public void TwoChains_AreTooFew()
        {
            WingSkeleton skeleton = TestWings.Fan();
            skeleton.Chains = skeleton.Chains.Take(2).ToArray();

            SkeletonProblem problem = Only(skeleton);
            Assert.That(problem.Kind, Is.EqualTo(SkeletonProblemKind.TooFewChains));
            Assert.That(problem.Message, Does.Contain("2 chains").And.Contain("3"));
        }

        [Test]
        public void SeventeenChains_AreTooMany()
        {
            Assert.That(Kinds(TestWings.Fan(17)), Is.EqualTo(new[] { SkeletonProblemKind.TooManyChains }));
        }

        [Test]
        public void TwoJoints_AreTooFew()
        {
            Assert.That(Kinds(TestWings.Fan(3, 2)), Is.EqualTo(Enumerable.Repeat(SkeletonProblemKind.TooFewJoints, 3)));
        }

        [Test]
        public void SeventeenJoints_AreTooMany()
        {
            Assert.That(Kinds(TestWings.Fan(3, 17)), Is.EqualTo(Enumerable.Repeat(SkeletonProblemKind.TooManyJoints, 3)));
        }

        [TestCase(1e-6f, 2e-7f, null)]
        [TestCase(-1f, null, "Chain 2 has a flexural stiffness of -1 N·m² (value 0); it must be between 1E-15 and 1000.")]
        [TestCase(float.NaN, null, "Chain 2 has a flexural stiffness of NaN N·m² (value 0); it must be between 1E-15 and 1000.")]
        [TestCase(0f, null, "Chain 2 has a flexural stiffness of 0 N·m² (value 0); it must be between 1E-15 and 1000.")]
        [TestCase(1e-6f, float.PositiveInfinity,
            "Chain 2 has a torsional stiffness of Infinity N·m² (value 0); it must be between 1E-15 and 1000.")]
        [TestCase(null, 1e-6f, "Chain 2 has a torsional stiffness but no flexural stiffness; give both, or the flexural one alone.")]
        public void AMeasuredStiffness_IsChecked(float? flexural, float? torsional, string expected)
        {
            WingSkeleton skeleton = TestWings.Fan();
            skeleton.Chains[2].flexuralStiffness = flexural is float bend ? new[] { bend } : null;
            skeleton.Chains[2].torsionalStiffness = torsional is float twist ? new[] { twist } : null;

            Assert.That(
                skeleton.Validate().Select(problem => problem.Message), Is.EqualTo(expected == null ? new string[0] : new[] { expected }));
            if (expected != null)
                Assert.That(Only(skeleton).Kind, Is.EqualTo(SkeletonProblemKind.InvalidStiffness));
        }

        [Test]
        public void SeventeenValuesOfStiffness_AreTooMany()
        {
            WingSkeleton skeleton = TestWings.Fan();
            skeleton.Chains[0].flexuralStiffness = Enumerable.Repeat(1e-6f, 17).ToArray();

            Assert.That(Only(skeleton).Message, Is.EqualTo("Chain 0 has 17 values of flexural stiffness; it takes at most 16."));
        }

        [Test]
        public void AShorterChain_IsNamed()
        {
            WingSkeleton skeleton = TestWings.Fan();
            skeleton.Chains[3].joints = skeleton.Chains[3].joints.Take(4).ToArray();

            SkeletonProblem problem = Only(skeleton);
            Assert.That(problem.Kind, Is.EqualTo(SkeletonProblemKind.UnequalJointCounts));
            Assert.That(problem.Chain, Is.EqualTo(3));
            Assert.That(problem.Joint, Is.EqualTo(SkeletonProblem.None));
        }

        [Test]
        public void AJointThatIsNotFinite_IsNamed([Values(float.NaN, float.PositiveInfinity)] float value)
        {
            WingSkeleton skeleton = TestWings.Fan();
            skeleton.Chains[2].joints[4].y = value;

            SkeletonProblem problem = Only(skeleton);
            Assert.That(problem.Kind, Is.EqualTo(SkeletonProblemKind.NonFinitePosition));
            Assert.That((problem.Chain, problem.Joint), Is.EqualTo((2, 4)));
        }

        [Test]
        public void AHingeThatIsNotFinite_IsAProblemOfNoChain()
        {
            WingSkeleton skeleton = TestWings.Fan();
            skeleton.Hinge = new Vector3(float.NaN, 0f, 0f);

            SkeletonProblem problem = Only(skeleton);
            Assert.That(problem.Kind, Is.EqualTo(SkeletonProblemKind.NonFinitePosition));
            Assert.That(problem.Chain, Is.EqualTo(SkeletonProblem.None));
        }

        [Test]
        public void CoincidentJointsOfAChain_AreNamed()
        {
            WingSkeleton skeleton = TestWings.Fan();
            skeleton.Chains[1].joints[3] = skeleton.Chains[1].joints[2];

            SkeletonProblem problem = Only(skeleton);
            Assert.That(problem.Kind, Is.EqualTo(SkeletonProblemKind.CoincidentJoints));
            Assert.That((problem.Chain, problem.Joint), Is.EqualTo((1, 3)));
        }

        [Test]
        public void ATipSharedByTwoChains_IsCoincident()
        {
            WingSkeleton skeleton = TestWings.Fan();
            skeleton.Chains[1].joints[4] = skeleton.Chains[0].joints[4];

            Assert.That(Kinds(skeleton), Does.Contain(SkeletonProblemKind.CoincidentJoints));
        }

        [Test]
        public void AJointOnTheRootOfAnotherChain_IsCoincident()
        {
            WingSkeleton skeleton = TestWings.Fan();
            skeleton.Chains[2].joints[1] = skeleton.Chains[0].joints[0];

            SkeletonProblem problem = skeleton.Validate().First(p => p.Kind == SkeletonProblemKind.CoincidentJoints);
            Assert.That((problem.Chain, problem.Joint), Is.EqualTo((2, 1)));
        }

        [Test]
        public void ChainsThatCross_AreNamed()
        {
            WingSkeleton skeleton = TestWings.Fan();
            (skeleton.Chains[2].joints[4], skeleton.Chains[3].joints[4]) = (skeleton.Chains[3].joints[4], skeleton.Chains[2].joints[4]);

            SkeletonProblem crossing = skeleton.Validate().First(p => p.Kind == SkeletonProblemKind.CrossingChains);
            Assert.That((crossing.Chain, crossing.Joint), Is.EqualTo((3, 3)));
            Assert.That(crossing.Message, Does.Contain("chain 2").IgnoreCase);
        }

        [Test]
        public void ChainsThatPassOverOneAnother_CrossWhateverTheirHeights()
        {
            WingSkeleton skeleton = TestWings.Fan();
            (skeleton.Chains[2].joints[4], skeleton.Chains[3].joints[4]) = (skeleton.Chains[3].joints[4], skeleton.Chains[2].joints[4]);
            skeleton.Chains[2].joints[4].y = 0.05f;

            Assert.That(Kinds(skeleton), Does.Contain(SkeletonProblemKind.CrossingChains));
        }

        [Test]
        public void APrincipalChainBehindTheSecond_IsNotLeading()
        {
            WingSkeleton skeleton = TestWings.Fan();
            Swap(skeleton, 0, 1);

            SkeletonProblem problem = Only(skeleton);
            Assert.That(problem.Kind, Is.EqualTo(SkeletonProblemKind.PrincipalChainNotLeading));
            Assert.That(problem.Chain, Is.EqualTo(0));
        }

        [Test]
        public void APrincipalChainOnTheTrailingEdge_IsNotLeading()
        {
            WingSkeleton skeleton = TestWings.Fan();
            Array.Reverse(skeleton.Chains);

            Assert.That(Kinds(skeleton), Is.EqualTo(new[] { SkeletonProblemKind.PrincipalChainNotLeading }));
        }

        [Test]
        public void ExchangedMiddleChains_AreOutOfOrder()
        {
            WingSkeleton skeleton = TestWings.Fan(6);
            Swap(skeleton, 2, 3);

            SkeletonProblem problem = Only(skeleton);
            Assert.That(problem.Kind, Is.EqualTo(SkeletonProblemKind.ChainsOutOfOrder));
            Assert.That(problem.Chain, Is.EqualTo(3));
        }

        [Test]
        public void JointsOnOneLine_MakeNoWing()
        {
            WingSkeleton skeleton = TestWings.Skeleton(
                TestWings.Chain(Vector3.zero, new Vector3(1f, 0f, 0f), 3),
                TestWings.Chain(new Vector3(2f, 0f, 0f), new Vector3(3f, 0f, 0f), 3),
                TestWings.Chain(new Vector3(4f, 0f, 0f), new Vector3(5f, 0f, 0f), 3));

            Assert.That(Kinds(skeleton), Is.Not.Empty.And.All.EqualTo(SkeletonProblemKind.ChainsOutOfOrder));
        }

        private static readonly Vector3[] s_BrokenAxes =
        {
            Vector3.zero, new Vector3(float.NaN, 1f, 0f), new Vector3(float.NegativeInfinity, 0f, 0f),
            new Vector3(2f, 0f, 0f), new Vector3(-1f, 0f, 0f),
        };

        [TestCaseSource(nameof(s_BrokenAxes))]
        public void AnUpAxisThatIsNoDirectionOrParallelToTheSpan_IsInvalid(Vector3 up)
        {
            WingSkeleton skeleton = TestWings.Fan();
            skeleton.UpAxis = up;

            Assert.That(Kinds(skeleton), Is.EqualTo(new[] { SkeletonProblemKind.InvalidAxes }));
        }

        [Test]
        public void AnUpAxisInThePlaneOfTheWing_IsInvalid()
        {
            WingSkeleton skeleton = TestWings.Fan();
            skeleton.UpAxis = new Vector3(0f, 0f, 1f);

            Assert.That(Kinds(skeleton), Does.Contain(SkeletonProblemKind.InvalidAxes));
        }

        [Test]
        public void ASpanAxisTowardsTheBody_IsInvalid()
        {
            WingSkeleton skeleton = TestWings.Fan();
            skeleton.SpanAxis = new Vector3(-1f, 0f, 0f);

            Assert.That(Kinds(skeleton), Does.Contain(SkeletonProblemKind.InvalidAxes));
        }

        [Test]
        public void ABoneAlongTheUpAxis_IsNamed()
        {
            WingSkeleton skeleton = TestWings.Fan();
            skeleton.Chains[1].joints[4] = skeleton.Chains[1].joints[3] + new Vector3(0f, 0.2f, 0f);

            SkeletonProblem problem = skeleton.Validate().First(p => p.Kind == SkeletonProblemKind.InvalidAxes);
            Assert.That((problem.Chain, problem.Joint), Is.EqualTo((1, 3)));
        }

        [Test]
        public void JointsThatAreNotThere_AreRefused()
        {
            WingSkeleton skeleton = TestWings.Fan();

            Assert.Throws<ArgumentOutOfRangeException>(() => skeleton.GetJoint(5, 0));
            Assert.Throws<ArgumentOutOfRangeException>(() => skeleton.GetJoint(0, -1));
        }

        [Test]
        public void Chains_AreNeverNull()
        {
            WingSkeleton skeleton = TestWings.Fan();
            skeleton.Chains = null;

            Assert.That(skeleton.Chains, Is.Empty);
            Assert.That(skeleton.JointsPerChain, Is.EqualTo(0));
        }

        private static void Swap(WingSkeleton skeleton, int a, int b)
        {
            (skeleton.Chains[a], skeleton.Chains[b]) = (skeleton.Chains[b], skeleton.Chains[a]);
        }

        private static WingSkeleton Scaled(WingSkeleton skeleton, float scale)
        {
            foreach (JointChain chain in skeleton.Chains)
            {
                for (int j = 0; j < chain.Length; j++)
                    chain.joints[j] *= scale;
            }

            return skeleton;
        }

        private static WingSkeleton Mirrored(WingSkeleton skeleton)
        {
            foreach (JointChain chain in skeleton.Chains)
            {
                for (int j = 0; j < chain.Length; j++)
                    chain.joints[j].x = -chain.joints[j].x;
            }

            skeleton.SpanAxis = new Vector3(-1f, 0f, 0f);
            return skeleton;
        }

        private static SkeletonProblemKind[] Kinds(WingSkeleton skeleton) => skeleton.Validate().Select(p => p.Kind).ToArray();

        private static SkeletonProblem Only(WingSkeleton skeleton)
        {
            List<SkeletonProblem> problems = skeleton.Validate();
            Assert.That(problems, Has.Count.EqualTo(1));
            return problems[0];
        }
    }
}
