using System.Collections.Generic;
using System.Linq;
using Alate.Fitting;
using FsCheck;
using FsCheck.Fluent;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>Properties of the fitted skeleton of any wing: twenty random outlines, and two hundred in the long tests.</summary>
    public sealed class SkeletonFitProperties
    {
        private const int k_Wings = 12, k_MovedWings = 4, k_ManyWings = 200, k_Fins = 3, k_ManyFins = 40;

        private static readonly Dictionary<int, SkeletonFit> s_Fits = new Dictionary<int, SkeletonFit>();
        private static readonly Vector3 s_BodySide = Vector3.left, s_Forward = Vector3.forward, s_Up = Vector3.up;

        [Test]
        public void EveryRandomWing_GetsAValidSkeletonInsideItAlongItsLeadingEdge() => CheckWings(0, k_Wings);

        [Test]
        [Explicit]
        [Category("Long")]
        public void EveryOtherWing_GetsAValidSkeletonInsideItAlongItsLeadingEdge() => CheckWings(k_Wings, k_ManyWings);

        private static void CheckWings(int first, int end)
        {
            for (int seed = first; seed < end; seed++)
            {
                PolarWing wing = RandomWings.Make(seed);
                SkeletonFit fit = Fit(seed);
                var measure = new FitMeasure(fit.Skeleton, wing.Outline());

                Assert.That(fit.Skeleton.Validate(), Is.Empty, $"wing {seed}");
                Assert.That(measure.Outside(), Is.LessThan(0.01), $"outside wing {seed}");
                Assert.That(measure.OffLeadingEdge(), Is.LessThan(0.03), $"off the leading edge of wing {seed}");
                Assert.That(measure.TipsOffMargin(), Is.LessThan(0.01), $"off the margin of wing {seed}");
            }
        }

        [Test]
        public void RotationMirroringUnitAndTriangulation_MoveTheSkeletonAlong()
        {
            for (int seed = 0; seed < k_MovedWings; seed++)
                CheckMoves(seed);
        }

        [Test]
        [Explicit]
        [Category("Long")]
        public void RotationMirroringUnitAndTriangulation_MoveEveryOtherSkeletonAlong()
        {
            for (int seed = k_MovedWings; seed < k_ManyWings; seed++)
                CheckMoves(seed);
        }

        [Test]
        public void AnyCountOfChainsAndJoints_IsValidAndBakes() => CheckCounts(8, 1);

        [Test]
        [Explicit]
        [Category("Long")]
        public void MoreCountsOfChainsAndJoints_AreValidAndBake() => CheckCounts(100, 3);

        private static void CheckCounts(int wings, ulong replay)
        {
            Arbitrary<(int Seed, int Chains, int Joints)> any = Gen.Choose(0, 100000)
                .SelectMany(seed => Gen.Choose(3, 16).SelectMany(chains => Gen.Choose(3, 16).Select(joints => (seed, chains, joints))))
                .ToArbitrary();
            Prop.ForAll(any, given =>
            {
                SurfaceMesh mesh = RandomWings.Make(given.Seed).Mesh(given.Seed);
                SkeletonFitSettings hints = Hints();
                hints.chains = given.Chains;
                hints.jointsPerChain = given.Joints;

                WingSkeleton skeleton = SkeletonFitter.Fit(mesh, hints).Skeleton;

                Assert.That(skeleton.Validate(), Is.Empty);
                Assert.That(skeleton.Chains.Select(chain => chain.Length), Is.All.EqualTo(given.Joints));
                TestWings.Bake(skeleton, mesh).Release();
            }).Check(FixedRuns.Of(wings, replay));
        }

        [Test]
        public void RandomFins_AreFittedAlongTheirRays_WhereverTheyAre() => CheckFins(0, k_Fins);

        [Test]
        [Explicit]
        [Category("Long")]
        public void MoreRandomFins_AreFittedAlongTheirRays_WhereverTheyAre() => CheckFins(k_Fins, k_ManyFins);

        private static void CheckFins(int first, int end)
        {
            for (int seed = first; seed < end; seed++)
            {
                var random = new System.Random(seed);
                var fin = new RayFin
                {
                    rays = random.Next(7, 17),
                    depth = 0.03 + 0.2 * random.NextDouble(),
                    first = 0.5 + 0.8 * random.NextDouble(),
                    last = -0.5 - 0.9 * random.NextDouble(),
                };
                var measure = new FitMeasure(SkeletonFitter.Fit(fin.Mesh(seed), Hints()).Skeleton, fin.Outline());

                Assert.That(measure.Outside(), Is.LessThan(0.01), $"outside fin {seed}");
                Assert.That(measure.OffLeadingEdge(), Is.LessThan(0.03), $"off the leading edge of fin {seed}");
                CheckMoves(seed, measure, fin.Mesh);
            }
        }

        private static void CheckMoves(int seed)
        {
            PolarWing wing = RandomWings.Make(seed);
            CheckMoves(seed, new FitMeasure(Fit(seed).Skeleton, wing.Outline()), wing.Mesh);
        }

        // Wings that are not moved are fitted once for all tests.
        private static SkeletonFit Fit(int seed)
        {
            if (!s_Fits.TryGetValue(seed, out SkeletonFit fit))
                s_Fits.Add(seed, fit = SkeletonFitter.Fit(RandomWings.Make(seed).Mesh(seed), Hints()));
            return fit;
        }

        private static void CheckMoves(int seed, FitMeasure measure, System.Func<int, SurfaceMesh> mesh)
        {
            for (int variant = 1; variant <= 2; variant++)
            {
                var move = new WingMove(1000 * seed + variant);
                SkeletonFitSettings hints = Hints();
                hints.bodySide = move.Direction(s_BodySide);
                hints.forward = move.Direction(s_Forward);
                hints.up = move.Direction(s_Up);

                WingSkeleton moved = SkeletonFitter.Fit(move.Surface(mesh(1000 * seed + variant)), hints).Skeleton;

                Assert.That(moved.Validate(), Is.Empty, $"wing {seed}, variant {variant}");
                Assert.That(measure.Apart(moved, move.Point, move.Scale), Is.LessThan(0.01), $"wing {seed}, variant {variant}");
            }
        }

        private static SkeletonFitSettings Hints()
        {
            SkeletonFitSettings hints = SkeletonFitSettings.Default;
            hints.bodySide = s_BodySide;
            return hints;
        }
    }
}
