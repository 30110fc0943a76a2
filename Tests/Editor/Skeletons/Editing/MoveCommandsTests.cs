using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    public sealed class MoveCommandsTests : EditingFixture
    {
        private static readonly Vector3 s_Delta = new Vector3(0.01f, 0.02f, -0.03f);

        [TestCase(0.99e9f, true)]
        [TestCase(1.01e9f, false)]
        [TestCase(float.NaN, false)]
        public void AJoint_GoesAsFarAsABillion_AndNoFarther(float x, bool done)
        {
            Select((2, 2));
            string before = SkeletonText.Of(Skeleton);
            EditOutcome outcome = Editing.Do("Move", (draft, selected) => MoveCommands.By(draft, selected, new Vector3(0f, x, 0f)));
            Assert.That(outcome.Done, Is.EqualTo(done));
            Assert.That(outcome.Message, Is.EqualTo(done ? null : "Joint 2 of chain 2 would not be at a usable position."));
            Assert.That(SkeletonText.Of(Skeleton) == before, Is.EqualTo(!done));
        }

        [Test]
        public void SelectedJoints_Move_AndNoOthers()
        {
            Vector3[][] old = Skeleton.Chains.Select(chain => (Vector3[])chain.joints.Clone()).ToArray();
            Select((1, 2), (3, 4));

            Assert.That(Move(s_Delta).Done);

            foreach (JointIndex joint in JointPicking.All(Skeleton))
            {
                Vector3 by = Skeleton.GetJoint(joint.chain, joint.joint) - old[joint.chain][joint.joint];
                Vector3 expected = Editing.Selection.Contains(joint) ? s_Delta : Vector3.zero;
                Assert.That(Vector3.Distance(by, expected), Is.LessThan(1e-6f), joint.ToString());
            }
        }

        [Test]
        public void HingeOnTheFirstRoot_GoesWithIt()
        {
            Select((0, 0));

            Move(s_Delta);

            Assert.That(Skeleton.Hinge, Is.EqualTo(Skeleton.GetJoint(0, 0)));
        }

        [Test]
        public void HingeElsewhere_Stays()
        {
            Skeleton.Hinge = new Vector3(-0.01f, 0f, 0f);
            Select((0, 0));

            Move(s_Delta);

            Assert.That(Skeleton.Hinge, Is.EqualTo(new Vector3(-0.01f, 0f, 0f)));
        }

        [Test]
        public void SnappedJoints_LieOnTheSurface()
        {
            Select((2, 2), (1, 3));
            Move(s_Delta);
            float height = Skeleton.GetJoint(2, 2).y;

            Assert.That(Do("Snap To Surface").Done);

            Assert.That(height, Is.GreaterThan(0.019f));
            Assert.That(Skeleton.GetJoint(2, 2).y, Is.EqualTo(0f).Within(1e-6f));
            Assert.That(Skeleton.GetJoint(1, 3).y, Is.EqualTo(0f).Within(1e-6f));
        }

        [Test]
        public void Snapping_NeedsAMesh()
        {
            Editing.Surface = null;
            Select((1, 1));

            Assert.That(Do("Snap To Surface").Message, Is.EqualTo("There is no mesh to snap to."));
        }

        [Test]
        public void UnusablePositions_AreRefused_AndNothingIsRecorded(
            [Values(float.NaN, float.PositiveInfinity, 2e9f, float.MaxValue)] float far)
        {
            Select((1, 1));
            string before = SkeletonText.Of(Skeleton);
            int steps = Undo.DoneCount;

            EditOutcome outcome = Move(new Vector3(0f, far, 0f));

            Assert.That(outcome.Message, Is.EqualTo("Joint 1 of chain 1 would not be at a usable position."));
            Assert.That(SkeletonText.Of(Skeleton), Is.EqualTo(before));
            Assert.That(Undo.DoneCount, Is.EqualTo(steps));
        }

        [Test]
        public void NothingSelected_IsRefused() => Assert.That(Move(s_Delta).Message, Is.EqualTo("Select a joint first."));

        private EditOutcome Move(Vector3 delta) => Editing.Do("Move", (draft, selected) => MoveCommands.By(draft, selected, delta));
    }
}
