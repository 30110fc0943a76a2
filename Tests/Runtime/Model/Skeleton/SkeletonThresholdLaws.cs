using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>Bounds at which a skeleton ceases to be one, just before and just beyond each; and values along its chains.</summary>
    public sealed class SkeletonThresholdLaws
    {
        [TestCase(0.95e-4f, SkeletonProblemKind.CoincidentJoints)]
        [TestCase(1.05e-4f, null)]
        public void JointsCoincide_WithinATenThousandthOfTheSize(float apart, SkeletonProblemKind? problem)
        {
            AssertProblem(Moved(1, 1, new Vector3(0.5f, 0f, -apart)), problem, 1, 1);
            AssertProblem(Scaled(Moved(1, 1, new Vector3(0.5f, 0f, -apart)), 30f), problem, 1, 1);
        }

        [TestCase(0.95e-6f, SkeletonProblemKind.CrossingChains)]
        [TestCase(1.05e-6f, null)]
        public void ChainsTouch_WithinAMillionthOfTheSize(float apart, SkeletonProblemKind? problem) =>
            AssertProblem(Moved(1, 1, new Vector3(0.3f, 0f, -apart)), problem, 1, 0);

        [TestCase(0.0195f, SkeletonProblemKind.InvalidAxes)]
        [TestCase(0.0205f, null)]
        public void ABone_IsUpright_WhereItsSineIsBelowTwoHundredths(float sine, SkeletonProblemKind? problem) =>
            AssertProblem(Moved(1, 1, new Vector3(0.5f * sine, 0.5f, -0.25f)), problem, 1, 0);

        [TestCase(1.95f, null)]
        [TestCase(2.05f, SkeletonProblemKind.InvalidAxes)]
        public void AWingIsUpright_WhereItIsFourTimesAsHighAsDeep(float height, SkeletonProblemKind? problem)
        {
            WingSkeleton skeleton = TestWings.Lattice(3, 3);
            for (int joint = 0; joint < 3; joint++)
                skeleton.Chains[2].joints[joint].y = -height;

            AssertProblem(skeleton, problem, SkeletonProblem.None, SkeletonProblem.None);
        }

        [TestCase(0.69f, SkeletonProblemKind.PrincipalChainNotLeading)]
        [TestCase(0.71f, null)]
        public void ThePrincipalChain_IsSevenTenthsOfTheLastAtLeast(float length, SkeletonProblemKind? problem) =>
            AssertProblem(Moved(0, 2, new Vector3(length, 0f, 0f)), problem, 0, SkeletonProblem.None);

        [Test]
        public void AShortPrincipalChain_ThatReachesAsFar_Leads()
        {
            // The last chain is long, but goes back.
            WingSkeleton skeleton = Moved(0, 2, new Vector3(0.6f, 0f, 0f));
            skeleton.Chains[2] = TestWings.Chain(new Vector3(0f, 0f, -0.5f), new Vector3(0.8f, 0f, -1.5f), 3);

            AssertProblem(skeleton, null, 0, 0);
        }

        [TestCase(0.95e-3f, false)]
        [TestCase(1.05e-3f, true)]
        public void SpanAndUp_AreParallel_WithinAThousandth(float sine, bool areAxes)
        {
            foreach (float length in new[] { 1e-30f, 1f, 1e30f })
            {
                Vector3 span = new Vector3(1f, 2f, -2f) / 3f, square = new Vector3(2f, 1f, 2f) / 3f;
                bool made = WingAxes.TryMake(length * span, (span + sine * square) * length, out float3x3 axes);
                Assert.That(made, Is.EqualTo(areAxes), $"of length {length}");
                if (!made)
                    continue;
                Assert.That(math.distance(axes.c0, span), Is.LessThan(1e-6f));
                Assert.That(math.distance(axes.c1, square), Is.LessThan(1e-3f));
                Assert.That(math.dot(axes.c0, axes.c1), Is.EqualTo(0f).Within(1e-6f));
                Assert.That(math.distance(axes.c2, math.cross(axes.c0, axes.c1)), Is.LessThan(1e-6f));
            }
        }

        [Test]
        public void AxesOfNoLength_OrNoNumber_AreNone()
        {
            foreach (Vector3 bad in new[] { Vector3.zero, new Vector3(0f, float.NaN, 1f), new Vector3(float.PositiveInfinity, 0f, 0f) })
            {
                Assert.That(WingAxes.TryMake(bad, Vector3.up, out _), Is.False);
                Assert.That(WingAxes.TryMake(Vector3.right, bad, out _), Is.False);
            }
        }

        [Test]
        public void ValuesAlongAChain_FallByFactors_AndWidthsEvenly()
        {
            float[] two = { 100f, 1f }, three = { 8f, 2f, 50f };
            Assert.That(ChainValues.At(two, 0.5), Is.EqualTo(10.0).Within(1e-9));
            Assert.That(ChainValues.At(three, 0.25), Is.EqualTo(4.0).Within(1e-9));
            Assert.That(ChainValues.At(three, 0.75), Is.EqualTo(10.0).Within(1e-9));
            Assert.That(ChainValues.Between(two, 0.25), Is.EqualTo(75.25).Within(1e-9));
            Assert.That(ChainValues.Between(three, 0.25), Is.EqualTo(5.0).Within(1e-9));
            Assert.That(ChainValues.Between(three, 0.75), Is.EqualTo(26.0).Within(1e-9));
            for (double place = 0.0; place <= 1.0; place += 0.25)
            {
                Assert.That(ChainValues.At(new[] { 7f }, place), Is.EqualTo(7.0));
                Assert.That(ChainValues.Between(new[] { 7f }, place), Is.EqualTo(7.0));
            }

            Assert.That(ChainValues.At(three, 0.0), Is.EqualTo(8.0));
            Assert.That(ChainValues.At(three, 1.0), Is.EqualTo(50.0).Within(1e-9));
            Assert.That((ChainValues.Between(three, 0.0), ChainValues.Between(three, 1.0)), Is.EqualTo((8.0, 50.0)));
        }

        [Test]
        public void ValuesOutOfBounds_AreNamed_ThoseOnThemAreNot()
        {
            Assert.That(ChainValues.FindProblem("width", " m", new[] { 1f, 2f, 3f }, 1f, 3f), Is.Null);
            Assert.That(ChainValues.FindProblem("width", " m", new float[16], 0f, 3f), Is.Null);
            Assert.That(ChainValues.FindProblem("width", " m", null, 1f, 3f), Is.Null);
            Assert.That(ChainValues.FindProblem("width", " m", new float[0], 1f, 3f), Is.Null);
            Assert.That(
                ChainValues.FindProblem("width", " m", new float[17], 0f, 3f), Is.EqualTo("has 17 values of width; it takes at most 16"));
            Assert.That(ChainValues.FindProblem("width", " m", new[] { 2f, 0.5f }, 1f, 3f),
                Is.EqualTo("has a width of 0.5 m (value 1); it must be between 1 and 3"));
            Assert.That(ChainValues.FindProblem("width", "", new[] { 3.5f }, 1f, 3f), Does.StartWith("has a width of 3.5 (value 0)"));
            Assert.That(ChainValues.FindProblem("width", "", new[] { 1f, float.NaN }, 1f, 3f), Does.Contain("(value 1)"));
        }

        private static void AssertProblem(WingSkeleton skeleton, SkeletonProblemKind? kind, int chain, int joint)
        {
            List<SkeletonProblem> problems = skeleton.Validate();
            if (kind == null)
            {
                Assert.That(problems.Select(problem => problem.Message), Is.Empty);
                return;
            }

            Assert.That(problems.Select(problem => problem.Kind), Has.Member(kind.Value));
            SkeletonProblem found = problems.First(problem => problem.Kind == kind.Value);
            Assert.That((found.Chain, found.Joint), Is.EqualTo((chain, joint)), found.Message);
        }

        private static WingSkeleton Moved(int chain, int joint, Vector3 place)
        {
            WingSkeleton skeleton = TestWings.Lattice(3, 3);
            skeleton.Chains[chain].joints[joint] = place;
            return skeleton;
        }

        private static WingSkeleton Scaled(WingSkeleton skeleton, float by)
        {
            foreach (JointChain chain in skeleton.Chains)
            {
                for (int joint = 0; joint < chain.Length; joint++)
                    chain.joints[joint] *= by;
            }

            return skeleton;
        }
    }
}
