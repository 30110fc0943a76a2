using System;
using System.Linq;
using Alate.Fitting;
using Alate.Geometry;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>Wings on a stalk: their chains run side by side through it and spread in the blade.</summary>
    public sealed class StalkedWingTests
    {
        [TestCase(0.18f)]
        [TestCase(0.35f)]
        public void ChainsSpreadBeyondTheStalk(float stalk)
        {
            Vector2[] outline = stalk < 0.2f ? BladeOutline.Stalked : BladeOutline.LongStalked;
            SkeletonFitSettings settings = SkeletonFitSettings.Default;
            settings.hinge = Vector3.zero;
            settings.forward = Vector3.forward;
            SkeletonFit fit = SkeletonFitter.Fit(new DrawnInsectWing(outline, 0f, false).Surface, settings);
            PlanPoint[][] chains = Array.ConvertAll(
                fit.Skeleton.Chains, chain => Array.ConvertAll(chain.joints, joint => new PlanPoint(joint.x, joint.z)));
            Assert.That(fit.Warnings.Select(warning => warning.Kind), Has.No.Member(SkeletonFitWarningKind.ChainsLaidAsRays));
            foreach (PlanPoint[] chain in chains)
                Assert.That(chain[^1].x, Is.GreaterThan(stalk + 0.2));
            // Four strips share the stalk's width, 0.036 or 0.024; even ones would have this share of its length.
            double even = (stalk < 0.2f ? 0.036 : 0.024) / 4.0 / stalk;
            for (int i = 0; i + 1 < chains.Length; i++)
            {
                Assert.That(Narrowest(chains[i], chains[i + 1]), Is.GreaterThan(0.2 * even), $"from chain {i} to the next");
                Assert.That(Narrowest(chains[i + 1], chains[i]), Is.GreaterThan(0.2 * even), $"from chain {i + 1} to the one before");
            }
        }

        // Least distance of a joint from another chain, over its way from the root.
        private static double Narrowest(PlanPoint[] chain, PlanPoint[] beside)
        {
            double narrowest = double.MaxValue;
            for (int j = 1; j < chain.Length; j++)
            {
                double nearest = double.MaxValue;
                for (int k = 0; k + 1 < beside.Length; k++)
                    nearest = Math.Min(nearest, PlanPoint.DistanceSquared(chain[j], beside[k], beside[k + 1]));
                narrowest = Math.Min(narrowest, nearest / (chain[j] - chain[0]).LengthSquared);
            }

            return Math.Sqrt(narrowest);
        }
    }
}
