using Alate.Fitting;
using NUnit.Framework;

namespace Alate.Tests
{
    /// <summary>Wings whose chains along the edges would cross get straight rays, with a warning, instead of an error.</summary>
    public sealed class CrossingChainsTests
    {
        private const int k_Wings = 6, k_ManyWings = 20;

        [TestCaseSource(typeof(WildWings), nameof(WildWings.Crossing))]
        public void WingWhoseChainsCross_GetsStraightRaysThatDoNot(int seed) => AssertStraight(seed);

        [TestCaseSource(typeof(WildWings), nameof(WildWings.MoreCrossing))]
        [Explicit]
        [Category("Long")]
        public void OneMoreWingWhoseChainsCross_GetsStraightRaysThatDoNot(int seed) => AssertStraight(seed);

        [Test]
        public void WingsWhoseChainsDoNotCross_KeepThem() => AssertKept(0, k_Wings);

        [Test]
        [Explicit]
        [Category("Long")]
        public void MoreWingsWhoseChainsDoNotCross_KeepThem() => AssertKept(k_Wings, k_ManyWings);

        private static void AssertStraight(int seed)
        {
            SurfaceMesh wing = WildWings.Make(seed, out SkeletonFitSettings hints);

            SkeletonFit fit = SkeletonFitter.Fit(wing, hints);

            Assert.That(fit.Skeleton.Validate(), Is.Empty);
            Assert.That((fit.Skeleton.ChainCount, fit.Skeleton.JointsPerChain), Is.EqualTo((hints.chains, hints.jointsPerChain)));
            Assert.That(fit.Confidence, Is.LessThanOrEqualTo(0.5f));
            if (!fit.Warns(SkeletonFitWarningKind.LeadingEdgeGuessed))
                Assert.That(fit.Warns(SkeletonFitWarningKind.ChainsLaidAsRays));
        }

        private static void AssertKept(int first, int end)
        {
            for (int seed = first; seed < end; seed++)
            {
                SkeletonFit fit = SkeletonFitter.Fit(WildWings.Make(seed, out SkeletonFitSettings hints), hints);

                Assert.That(fit.Warns(SkeletonFitWarningKind.ChainsLaidAsRays), Is.False, $"wing {seed}");
            }
        }
    }
}
