using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>When insects may share a skeleton that was laid out for one of them.</summary>
    public sealed class AutomaticSkeletonLaws
    {
        private GameObject m_Insect, m_Wing;

        [SetUp]
        public void Make()
        {
            m_Insect = new GameObject("insect");
            m_Wing = new GameObject("wing");
            m_Wing.transform.SetParent(m_Insect.transform, false);
        }

        [TearDown]
        public void Clear() => Object.DestroyImmediate(m_Insect);

        [Test]
        public void WhereTheInsectIs_DoesNotMatter()
        {
            AutomaticSkeleton here = Of();
            m_Insect.transform.SetPositionAndRotation(new Vector3(1e6f, -4f, 3e5f), Quaternion.Euler(10f, 20f, 30f));
            Assert.That(Of().Matches(here), Is.True);
        }

        [Test]
        public void WhereTheWingIsOnIt_Does()
        {
            AutomaticSkeleton plain = Of();
            m_Wing.transform.localPosition = new Vector3(0f, 0.01f, 0f);
            Assert.That(Of().Matches(plain), Is.False, "moved");
            m_Wing.transform.localPosition = Vector3.zero;
            m_Wing.transform.localRotation = Quaternion.Euler(20f, 0f, 0f);
            Assert.That(Of().Matches(plain), Is.False, "pitched");
            m_Wing.transform.localRotation = Quaternion.Euler(0f, 20f, 0f);
            Assert.That(Of().Matches(plain), Is.False, "turned about its upright, which stays");
            m_Wing.transform.localRotation = Quaternion.Euler(0f, 0f, 20f);
            Assert.That(Of().Matches(plain), Is.False, "rolled about its length, which stays");
            m_Wing.transform.localRotation = Quaternion.identity;
            Assert.That(Of().Matches(plain), Is.True);
        }

        // One that hangs elsewhere is laid out by where both are.
        [Test]
        public void BesideItsInsect_AWingIsWhereTheWorldHasIt()
        {
            AutomaticSkeleton plain = Of();
            m_Wing.transform.SetParent(null, false);
            Assert.That(Of().Matches(plain), Is.True);
            m_Insect.transform.position = new Vector3(1f, 2f, 3f);
            Assert.That(Of().Matches(plain), Is.False);
            m_Wing.transform.position = new Vector3(1f, 2f, 3f);
            Assert.That(Of().Matches(plain), Is.True, "both moved");
            m_Wing.transform.SetParent(m_Insect.transform, true);
        }

        // The hinge is at the end that is nearer to the insect's middle; its upper side is above.
        [TestCase(-0.1f)]
        [TestCase(1.2f)]
        public void TheSkeleton_HingesTowardsTheInsect_AndHasItsUp(float body)
        {
            m_Wing.transform.localPosition = new Vector3(-body, 0f, 0.1f);
            SurfaceMesh surface = TestWings.Rectangle();
            foreach (bool turned in new[] { false, true })
            {
                m_Wing.transform.localRotation = Quaternion.Euler(turned ? 180f : 0f, 0f, 0f);
                WingSkeleton skeleton = Of().Fit(surface).Skeleton;
                (Vector3 hinge, Vector3 up) = (skeleton.Hinge, skeleton.UpAxis);
                Object.DestroyImmediate(skeleton);
                Assert.That(Mathf.Abs(hinge.x - body), Is.LessThan(0.5f));
                Assert.That(up.y, turned ? Is.LessThan(-0.9f) : Is.GreaterThan(0.9f));
            }
        }

        private AutomaticSkeleton Of() => new AutomaticSkeleton(m_Insect.transform, m_Wing.transform);
    }
}
