using Alate.Fitting;
using NUnit.Framework;

namespace Alate.Tests
{
    /// <summary>Wings whose chains along the edges would cross get straight rays, with a warning, instead of an error.</summary>
    public sealed class CrossingChainsTests
    {
        [TestCaseSource(typeof(WildWings), nameof(WildWings.Crossing))]
        public void WingWhoseChainsCross_GetsStraightRaysThatDoNot(int seed)
        {
            WingSurface wing = WildWings.Make(seed, out SkeletonFitSettings hints);

            SkeletonFit fit = SkeletonFitter.Fit(wing, hints);

            Assert.That(fit.Skeleton.Validate(), Is.Empty);
            Assert.That((fit.Skeleton.ChainCount, fit.Skeleton.JointsPerChain), Is.EqualTo((hints.chains, hints.jointsPerChain)));
            Assert.That(fit.Confidence, Is.LessThanOrEqualTo(0.5f));
            if (!fit.Warns(SkeletonFitWarningKind.LeadingEdgeGuessed))
                Assert.That(fit.Warns(SkeletonFitWarningKind.ChainsLaidAsRays));
        }

        [Test]
        public void WingsWhoseChainsDoNotCross_KeepThem()
        {
            for (int seed = 0; seed < 20; seed++)
            {
                SkeletonFit fit = SkeletonFitter.Fit(WildWings.Make(seed, out SkeletonFitSettings hints), hints);

                Assert.That(fit.Warns(SkeletonFitWarningKind.ChainsLaidAsRays), Is.False, $"wing {seed}");
            }
        }
    }
}
