using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    public sealed class FrameCommandsTests : EditingFixture
    {
        [Test]
        public void Hinge_GoesToTheSelectedJoint_AndBackToTheFirstRoot()
        {
            Select((2, 0));
            Assert.That(Do("Set Hinge").Done);
            Assert.That(Skeleton.Hinge, Is.EqualTo(Skeleton.GetJoint(2, 0)));

            Select();
            Assert.That(Do("Set Hinge").Done);
            Assert.That(Skeleton.Hinge, Is.EqualTo(Skeleton.GetJoint(0, 0)));
        }

        [Test]
        public void Hinge_GoesToTheMiddleOfSeveral()
        {
            Select((0, 0), (4, 0));

            Do("Set Hinge");

            Vector3 middle = 0.5f * (Skeleton.GetJoint(0, 0) + Skeleton.GetJoint(4, 0));
            Assert.That(Vector3.Distance(Skeleton.Hinge, middle), Is.LessThan(1e-7f));
        }

        [Test]
        public void SpanAxis_PointsToTheSelectedJoint()
        {
            Select((1, 4));

            Assert.That(Do("Set Span Axis").Done);

            Assert.That(Vector3.Angle(Skeleton.SpanAxis, Skeleton.GetJoint(1, 4) - Skeleton.Hinge), Is.LessThan(0.05f));
            Assert.That(Skeleton.SpanAxis.magnitude, Is.EqualTo(1f).Within(1e-6f));
        }

        [Test]
        public void SpanAxis_AlongUp_IsRefused()
        {
            Skeleton.Chains[2].joints[2] = Skeleton.Hinge + new Vector3(0f, 0.3f, 0f);
            Select((2, 2));

            Assert.That(Do("Set Span Axis").Message, Is.EqualTo("Span and up axis would be zero or parallel."));
        }

        [Test]
        public void FittedAxes_FollowATurnedWing([Values(-70f, 20f, 80f)] float degrees)
        {
            var turn = Quaternion.AngleAxis(degrees, new Vector3(1f, 2f, 0.5f).normalized);
            foreach (JointChain chain in Skeleton.Chains)
            {
                for (int j = 0; j < chain.Length; j++)
                    chain.joints[j] = turn * chain.joints[j];
            }

            Skeleton.Hinge = turn * Skeleton.Hinge;
            Vector3 span = Skeleton.GetJoint(0, 4) - Skeleton.Hinge;

            Assert.That(Do("Fit Axes").Done);

            Assert.That(Vector3.Angle(Skeleton.UpAxis, turn * Vector3.up), Is.LessThan(0.1f));
            Assert.That(Vector3.Angle(Skeleton.SpanAxis, span), Is.LessThan(0.1f));
            Assert.That(Skeleton.Validate(), Is.Empty);
        }

        [Test]
        public void FlippedUpAxis_PointsDown_AndTwiceUpAgain()
        {
            Vector3 up = Skeleton.UpAxis;

            Do("Flip Up Axis");
            Assert.That(Vector3.Angle(Skeleton.UpAxis, -up), Is.LessThan(0.05f));
            Do("Flip Up Axis");
            Assert.That(Vector3.Angle(Skeleton.UpAxis, up), Is.LessThan(0.05f));
        }
    }
}
