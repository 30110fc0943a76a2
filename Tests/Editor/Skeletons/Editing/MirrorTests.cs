using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    public sealed class MirrorTests : EditingFixture
    {
        [Test]
        public void MirrorImage_IsTheLeftWingsSkeleton()
        {
            WingSkeleton made = Keep(SkeletonMirror.Create(Skeleton, SkeletonMirror.AcrossX, out string refusal));

            Assert.That(refusal, Is.Null);
            Assert.That(made.name, Is.EqualTo("Left Wing"));
            AssertMirrored(made, Left, Matrix4x4.identity);
            Assert.That(made.Validate(), Is.Empty);
        }

        [Test]
        public void MirrorImage_OfTheMirrorImage_IsIdentical()
        {
            WingSkeleton there = Keep(SkeletonMirror.Create(Skeleton, SkeletonMirror.AcrossX, out _));
            WingSkeleton back = Keep(SkeletonMirror.Create(there, SkeletonMirror.AcrossX, out _));

            Assert.That(SkeletonText.Of(back), Is.EqualTo(SkeletonText.Of(Skeleton)));
        }

        [TestCase("RightForeWing", "LeftForeWing")]
        [TestCase("wing left", "wing right")]
        [TestCase("Wing_L", "Wing_R")]
        [TestCase("Fin", "Fin Mirrored")]
        [TestCase("Left Field Moth Left Wing", "Left Field Moth Right Wing")]
        [TestCase("Upright Wing", "Upright Wing Mirrored")]
        [TestCase("Wing_Root", "Wing_Root Mirrored")]
        [TestCase("RightWing", "LeftWing")]
        public void Names_ChangeSides(string name, string other) => Assert.That(SkeletonMirror.OtherSide(name), Is.EqualTo(other));

        [Test]
        public void MirroringOntoTheOtherSide_ChangesThatOneOnly_AndIsUndone()
        {
            Left.Chains[1].joints[1] += new Vector3(0f, 0.1f, 0f);
            string left = SkeletonText.Of(Left), right = SkeletonText.Of(Skeleton);

            Assert.That(Do("Mirror Onto Other Side").Done);
            AssertMirrored(Left, Skeleton, SkeletonMirror.AcrossX);
            Assert.That(SkeletonText.Of(Skeleton), Is.EqualTo(right));

            Undo.Undo();
            Assert.That(SkeletonText.Of(Left), Is.EqualTo(left));
        }

        [Test]
        public void WithoutAnotherWing_MirroringIsRefused()
        {
            Editing.Twin = null;

            Assert.That(Do("Mirror Onto Other Side").Message, Is.EqualTo("There is no wing on the other side to mirror onto."));
        }

        [Test]
        public void UnusableMirror_IsRefused()
        {
            Editing.Twin = new SkeletonTwin(Left, Matrix4x4.Scale(new Vector3(float.NaN, 1f, 1f)));
            string left = SkeletonText.Of(Left);

            Assert.That(Do("Mirror Onto Other Side").Done, Is.False);
            Assert.That(SkeletonText.Of(Left), Is.EqualTo(left));
        }

        internal static void AssertMirrored(WingSkeleton twin, WingSkeleton skeleton, Matrix4x4 toTwin)
        {
            Assert.That(twin.ChainCount, Is.EqualTo(skeleton.ChainCount));
            Assert.That(twin.JointsPerChain, Is.EqualTo(skeleton.JointsPerChain));
            foreach (JointIndex joint in JointPicking.All(skeleton))
            {
                Vector3 image = toTwin.MultiplyPoint3x4(skeleton.GetJoint(joint.chain, joint.joint));
                Assert.That(Vector3.Distance(twin.GetJoint(joint.chain, joint.joint), image), Is.LessThan(1e-5f), joint.ToString());
            }

            Assert.That(Vector3.Distance(twin.Hinge, toTwin.MultiplyPoint3x4(skeleton.Hinge)), Is.LessThan(1e-5f));
        }
    }
}
