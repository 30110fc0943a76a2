using Alate.Fitting;
using NUnit.Framework;

namespace Alate.Tests
{
    /// <summary>
    /// A wing that points the way the insect faces, or back: forward does not tell which of its edges leads, its shape does.
    /// </summary>
    public sealed class WingAlongForwardTests
    {
        private const int k_Wings = 10, k_SweptWings = 4, k_ManyWings = 25;

        [TestCase(OutlineKind.Butterfly, -90f)]
        [TestCase(OutlineKind.Slender, 90f, Explicit = true, Category = "Long")]
        [TestCase(OutlineKind.Oval, -90f, Explicit = true, Category = "Long")]
        public void ItsLeadingEdge_IsFoundByItsShape_AndCalledAGuess(OutlineKind kind, float degrees) =>
            AssertGuessed(kind, degrees, k_Wings, areBothSides: false);

        [Test]
        [Explicit]
        [Category("Long")]
        public void OfMoreWings_TheLeadingEdge_IsFoundByItsShape_AndCalledAGuess(
            [Values(OutlineKind.Butterfly, OutlineKind.Slender, OutlineKind.Oval)] OutlineKind kind, [Values(-90f, 90f)] float degrees) =>
            AssertGuessed(kind, degrees, k_ManyWings, areBothSides: true);

        private static void AssertGuessed(OutlineKind kind, float degrees, int wings, bool areBothSides)
        {
            int right = 0, all = areBothSides ? 2 * wings : wings;
            for (int seed = 0; seed < wings; seed++)
            {
                foreach (bool isMirrored in areBothSides ? new[] { false, true } : new[] { seed % 2 == 1 })
                {
                    var wing = new DrawnInsectWing(InsectOutlines.Make(kind, seed), degrees, isMirrored);
                    SkeletonFit fit = SkeletonFitter.Fit(wing.Surface, SkeletonFitSettings.Default);
                    right += wing.Leads(fit.Skeleton) ? 1 : 0;
                    Assert.That(fit.Warns(SkeletonFitWarningKind.LeadingEdgeGuessed), $"wing {seed}");
                }
            }

            Assert.That(right, Is.GreaterThanOrEqualTo(all * 9 / 10), $"of {all}");
        }

        [Test]
        public void SweptUpTo50Degrees_ForwardStillDecides([Values(-50f, 0f, 50f)] float degrees) =>
            AssertDecides(degrees, 0, k_SweptWings);

        [Test]
        [Explicit]
        [Category("Long")]
        public void OfMoreWings_SweptUpTo50Degrees_ForwardStillDecides([Values(-50f, 0f, 50f)] float degrees) =>
            AssertDecides(degrees, k_SweptWings, k_ManyWings);

        private static void AssertDecides(float degrees, int first, int end)
        {
            for (int seed = first; seed < end; seed++)
            {
                var wing = new DrawnInsectWing(InsectOutlines.Make(OutlineKind.Slender, seed), degrees, false);
                SkeletonFit fit = SkeletonFitter.Fit(wing.Surface, SkeletonFitSettings.Default);

                Assert.That(wing.Leads(fit.Skeleton), $"wing {seed}");
                Assert.That(fit.Warns(SkeletonFitWarningKind.LeadingEdgeGuessed), Is.False, $"wing {seed}");
            }
        }
    }
}
