using System;
using Alate.Catalogue;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    public sealed class SkeletonGeneratorTests
    {
        private const double k_LastTipSpan = 26.9 / 61.0;

        private static WingOutline Outline => InsectCatalogue.Find("monarch").Wings[0].Outline;

        private WingSkeleton m_Skeleton;

        [TearDown]
        public void DestroySkeleton()
        {
            if (m_Skeleton != null)
            {
                UnityEngine.Object.DestroyImmediate(m_Skeleton);
            }
        }

        [Test]
        public void MonarchSkeleton_HasItsMiddleJointWhereTheOutlinePutsIt()
        {
            m_Skeleton = SkeletonGenerator.Generate(Outline, 5, 5, k_LastTipSpan);

            Vector3 joint = m_Skeleton.GetJoint(2, 2);
            (double x, double z) = MonarchLandmarks.MiddleJoint();
            Assert.That(joint.x, Is.EqualTo(x).Within(1e-3).Percent);
            Assert.That(joint.y, Is.EqualTo(0f));
            Assert.That(joint.z, Is.EqualTo(z).Within(1e-3).Percent);
        }

        [Test]
        public void TheHinge_IsTheRootOfTheLeadingChain()
        {
            m_Skeleton = SkeletonGenerator.Generate(Outline, 5, 5, k_LastTipSpan, 61f);

            Assert.That(m_Skeleton.Hinge, Is.EqualTo(m_Skeleton.GetJoint(0, 0)));
            Assert.That(m_Skeleton.Hinge.z, Is.EqualTo(0.3f).Within(1e-5f));
            Assert.That(m_Skeleton.SpanAxis, Is.EqualTo(new Vector3(1f, 0f, 0f)));
            Assert.That(m_Skeleton.UpAxis, Is.EqualTo(new Vector3(0f, 1f, 0f)));
        }

        [Test]
        public void TheFirstChain_FollowsTheLeadingEdge_TheOthersRunStraight()
        {
            m_Skeleton = SkeletonGenerator.Generate(Outline, 5, 7, k_LastTipSpan);

            for (int j = 0; j < 7; j++)
            {
                Vector3 joint = m_Skeleton.GetJoint(0, j);
                Assert.That(joint.z, Is.EqualTo(Outline.LeadingAt(joint.x)).Within(1e-4));
            }

            for (int i = 1; i < 5; i++)
            {
                Vector3 bone = m_Skeleton.GetJoint(i, 1) - m_Skeleton.GetJoint(i, 0);
                for (int j = 2; j < 7; j++)
                {
                    Assert.That((m_Skeleton.GetJoint(i, j) - m_Skeleton.GetJoint(i, j - 1) - bone).magnitude, Is.LessThan(1e-6f));
                }
            }
        }

        [Test]
        public void TheTips_LieOnTheContour_AtTheChosenSpanAtLast()
        {
            m_Skeleton = SkeletonGenerator.Generate(Outline, 5, 5, k_LastTipSpan);

            Assert.That(m_Skeleton.GetJoint(0, 4).x, Is.EqualTo(1f).Within(1e-6f));
            Assert.That(m_Skeleton.GetJoint(4, 4).x, Is.EqualTo(k_LastTipSpan).Within(1e-6));
            for (int i = 1; i < 5; i++)
            {
                Vector3 tip = m_Skeleton.GetJoint(i, 4);
                Assert.That(tip.z, Is.EqualTo(Outline.TrailingAt(tip.x)).Within(1e-4));
            }
        }

        [TestCase(3, 3)]
        [TestCase(5, 5)]
        [TestCase(8, 4)]
        [TestCase(16, 16)]
        public void AnyAllowedSize_IsUsable_OnBothSides(int chains, int joints)
        {
            foreach (WingSide side in new[] { WingSide.Right, WingSide.Left })
            {
                WingSkeleton skeleton = SkeletonGenerator.Generate(Outline, chains, joints, k_LastTipSpan, 1f, side);

                Assert.That(skeleton.Validate(), Is.Empty);
                Assert.That(skeleton.ChainCount, Is.EqualTo(chains));
                Assert.That(skeleton.JointsPerChain, Is.EqualTo(joints));
                UnityEngine.Object.DestroyImmediate(skeleton);
            }
        }

        [TestCase(2, 5, 0.5)]
        [TestCase(17, 5, 0.5)]
        [TestCase(5, 2, 0.5)]
        [TestCase(5, 17, 0.5)]
        [TestCase(5, 5, 0.0)]
        [TestCase(5, 5, 1.0)]
        [TestCase(5, 5, double.NaN)]
        public void AnImpossibleSkeleton_IsRefused(int chains, int joints, double lastTipSpan)
        {
            Assert.That(
                () => SkeletonGenerator.Generate(Outline, chains, joints, lastTipSpan), Throws.InstanceOf<ArgumentOutOfRangeException>());
        }
    }
}
