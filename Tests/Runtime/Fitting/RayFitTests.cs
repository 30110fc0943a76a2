using System;
using Alate.Fitting;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>Fins whose margin tells where their rays end.</summary>
    public sealed class RayFitTests
    {
        [Test]
        [Pairwise]
        public void Chains_RunAlongRays_FromTheFirstToTheLast(
            [Values(8, 11, 15)] int rays, [Values(0.03, 0.1, 0.25)] double depth, [Values(3, 5, 8)] int chains) =>
            AssertAlong(rays, depth, chains);

        [Test]
        [Explicit]
        [Category("Long")]
        public void ChainsOfEveryFin_RunAlongRays_FromTheFirstToTheLast(
            [Values(8, 11, 15)] int rays, [Values(0.03, 0.1, 0.25)] double depth, [Values(3, 5, 8)] int chains) =>
            AssertAlong(rays, depth, chains);

        private static void AssertAlong(int rays, double depth, int chains)
        {
            var fin = new RayFin { rays = rays, depth = depth };
            WingSkeleton skeleton = Fit(fin, chains, out SkeletonFit fit);

            Assert.That(skeleton.Validate(), Is.Empty);
            Assert.That(fit.Warnings, Is.Empty);
            for (int i = 0; i < chains; i++)
            {
                double ray = Math.Round((double)i * (rays - 1) / (chains - 1));
                Vector3 tip = skeleton.GetJoint(i, skeleton.JointsPerChain - 1);
                Assert.That(Vector3.Distance(tip, fin.End(ray)), Is.LessThan(0.01), $"chain {i}");
            }

            var measure = new FitMeasure(skeleton, fin.Outline());
            Assert.That(measure.Outside(), Is.LessThan(0.01));
            Assert.That(measure.OffLeadingEdge(), Is.LessThan(0.03));
        }

        [Test]
        public void MoreChainsThanRays_LieEvenlyBetweenThem()
        {
            var fin = new RayFin { rays = 9, depth = 0.05 };
            WingSkeleton skeleton = Fit(fin, 16, out _);

            Assert.That(skeleton.Validate(), Is.Empty);
            for (int i = 0; i < 16; i++)
            {
                Vector3 tip = skeleton.GetJoint(i, skeleton.JointsPerChain - 1);
                Assert.That(Vector3.Angle(tip, fin.End(i * 8.0 / 15.0)), Is.LessThan(4f), $"chain {i}");
            }
        }

        [Test]
        public void AScallopedRearMargin_MakesNoFan([Values(0.01, 0.02, 0.03)] double scallop)
        {
            var plain = new PolarWing { aspect = 0.7 };
            var scalloped = new PolarWing { aspect = 0.7, scallop = scallop };
            WingSkeleton expected = SkeletonFitter.Fit(plain.Mesh(), Hints(5)).Skeleton;

            WingSkeleton skeleton = SkeletonFitter.Fit(scalloped.Mesh(), Hints(5)).Skeleton;

            Assert.That(Vector3.Distance(skeleton.GetJoint(0, 4), expected.GetJoint(0, 4)), Is.LessThan(0.03));
        }

        [Test]
        [Pairwise]
        public void AShortFirstRay_IsLeftToTheLeadingEdge(
            [Values(0.5, 0.6, 0.7)] double length, [Values(9, 13)] int rays, [Values(3, 6)] int chains) => AssertLeft(length, rays, chains);

        [Test]
        [Explicit]
        [Category("Long")]
        public void AShortFirstRayOfEveryFin_IsLeftToTheLeadingEdge(
            [Values(0.5, 0.6, 0.7)] double length, [Values(9, 13)] int rays, [Values(3, 6)] int chains) => AssertLeft(length, rays, chains);

        private static void AssertLeft(double length, int rays, int chains)
        {
            var fin = new RayFin { rays = rays, depth = 0.1, firstLength = length };

            WingSkeleton skeleton = Fit(fin, chains, out _);

            Assert.That(skeleton.Validate(), Is.Empty);
            Vector3 first = skeleton.GetJoint(0, skeleton.JointsPerChain - 1),
                last = skeleton.GetJoint(chains - 1, skeleton.JointsPerChain - 1);
            Assert.That(Vector3.Distance(first, fin.End(1)), Is.LessThan(0.02), "the first chain ends at the first long ray");
            Assert.That(Vector3.Distance(last, fin.End(rays - 1)), Is.LessThan(0.02));
        }

        [Test]
        public void AMarginInSteps_AsPixelsMakeIt_MakesNoFan([Values(0.4, 0.8)] double aspect, [Values(80, 200)] int pixels)
        {
            var wing = new PolarWing { aspect = aspect };
            SurfaceMesh stepped = wing.Mesh();
            for (int k = 0; k < stepped.positions.Length; k++)
            {
                Vector3 p = stepped.positions[k] * pixels;
                stepped.positions[k] = new Vector3(Mathf.Round(p.x), 0f, Mathf.Round(p.z)) / pixels;
            }

            WingSkeleton expected = SkeletonFitter.Fit(wing.Mesh(), Hints(5)).Skeleton;
            WingSkeleton skeleton = SkeletonFitter.Fit(stepped, Hints(5)).Skeleton;

            for (int i = 0; i < 5; i++)
                Assert.That(Vector3.Distance(skeleton.GetJoint(i, 4), expected.GetJoint(i, 4)), Is.LessThan(0.05), $"chain {i}");
        }

        [Test]
        public void ALastRayLongerThanTheFirstMayBe_IsPassedOver()
        {
            var fin = new RayFin { rays = 9, first = 0.3, last = -1.5 };
            SurfaceMesh surface = fin.Mesh();
            for (int k = 0; k < surface.positions.Length; k++)
                surface.positions[k].z *= surface.positions[k].z < 0f ? 1.6f : 1f;

            Assert.That(SkeletonFitter.Fit(surface, Hints(5)).Skeleton.Validate(), Is.Empty);
        }

        private static WingSkeleton Fit(RayFin fin, int chains, out SkeletonFit fit)
        {
            fit = SkeletonFitter.Fit(fin.Mesh(), Hints(chains));
            return fit.Skeleton;
        }

        private static SkeletonFitSettings Hints(int chains)
        {
            SkeletonFitSettings hints = SkeletonFitSettings.Default;
            hints.bodySide = Vector3.left;
            hints.chains = chains;
            return hints;
        }
    }
}
