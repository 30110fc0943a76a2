using Alate.Fitting;
using NUnit.Framework;

namespace Alate.Tests
{
    /// <summary>A wing that points the way the insect faces, or back: forward does not tell which of its edges leads, its shape does.</summary>
    public sealed class WingAlongForwardTests
    {
        private const int k_Wings = 25;

        [Test]
        public void ItsLeadingEdge_IsFoundByItsShape_AndCalledAGuess(
            [Values(OutlineKind.Butterfly, OutlineKind.Slender, OutlineKind.Oval)] OutlineKind kind, [Values(-90f, 90f)] float degrees)
        {
            int right = 0;
            for (int seed = 0; seed < k_Wings; seed++)
            {
                foreach (bool isMirrored in new[] { false, true })
                {
                    var wing = new DrawnInsectWing(InsectOutlines.Make(kind, seed), degrees, isMirrored);
                    SkeletonFit fit = SkeletonFitter.Fit(wing.Surface, SkeletonFitSettings.Default);
                    right += wing.Leads(fit.Skeleton) ? 1 : 0;
                    Assert.That(fit.Warns(SkeletonFitWarningKind.LeadingEdgeGuessed), $"wing {seed}");
                }
            }

            Assert.That(right, Is.GreaterThanOrEqualTo(2 * k_Wings * 9 / 10), $"of {2 * k_Wings}");
        }

        [Test]
        public void SweptUpTo50Degrees_ForwardStillDecides([Values(-50f, 0f, 50f)] float degrees)
        {
            for (int seed = 0; seed < k_Wings; seed++)
            {
                var wing = new DrawnInsectWing(InsectOutlines.Make(OutlineKind.Slender, seed), degrees, false);
                SkeletonFit fit = SkeletonFitter.Fit(wing.Surface, SkeletonFitSettings.Default);

                Assert.That(wing.Leads(fit.Skeleton), $"wing {seed}");
                Assert.That(fit.Warns(SkeletonFitWarningKind.LeadingEdgeGuessed), Is.False, $"wing {seed}");
            }
        }
    }
}
