using System.Linq;
using Alate.Catalogue;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    public sealed class SkeletonReportTests
    {
        [Test]
        public void GoodSkeleton_HasASizeAndNoProblem()
        {
            var report = SkeletonReport.Of(new[] { Monarch() });

            Assert.That(report.Size, Is.EqualTo("5 chains of 5 joints"));
            Assert.That(report.Problems, Is.Empty);
            Assert.That(report.HiddenProblems, Is.Zero);
        }

        [Test]
        public void Problems_AreThoseThatValidateFinds()
        {
            WingSkeleton skeleton = Monarch();
            skeleton.Chains = skeleton.Chains.Take(2).ToArray();
            skeleton.Hinge = new Vector3(float.NaN, 0f, 0f);

            var report = SkeletonReport.Of(new[] { skeleton });

            Assert.That(report.Problems, Has.Count.EqualTo(2));
            Assert.That(report.Problems, Is.EqualTo(skeleton.Validate().Select(problem => problem.Message)));
        }

        [Test]
        public void SeveralSkeletons_AreToldApartByName_AndByADashWhereTheyDiffer()
        {
            WingSkeleton good = Monarch(), broken = Monarch();
            broken.name = "Torn";
            broken.Chains = broken.Chains.Take(2).ToArray();

            var report = SkeletonReport.Of(new[] { good, broken });

            Assert.That(report.Size, Is.EqualTo("—"));
            Assert.That(report.Problems.Single(), Is.EqualTo("Torn: " + broken.Validate().Single().Message));
        }

        [Test]
        public void LongLists_AreCutAndCounted()
        {
            WingSkeleton skeleton = Monarch();
            foreach (JointChain chain in skeleton.Chains)
            {
                for (int joint = 0; joint < chain.Length; joint++)
                    chain.joints[joint] = Vector3.positiveInfinity;
            }

            var report = SkeletonReport.Of(new[] { skeleton });

            Assert.That(report.Problems, Has.Count.EqualTo(SkeletonReport.MaxProblems));
            Assert.That(report.HiddenProblems, Is.EqualTo(25 - SkeletonReport.MaxProblems));
        }

        [Test]
        public void EmptySkeleton_SaysSo()
        {
            var report = SkeletonReport.Of(new[] { ScriptableObject.CreateInstance<WingSkeleton>() });

            Assert.That(report.Size, Is.EqualTo("no chains"));
            Assert.That(report.Problems, Is.Not.Empty);
        }

        private static WingSkeleton Monarch() => InsectCatalogue.Find("monarch").Wings[0].CreateSkeleton(WingSide.Right);
    }
}
