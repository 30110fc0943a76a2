using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    public sealed class SymmetryTests : EditingFixture
    {
        /// <summary>The left mesh may have a space of its own, turned and scaled.</summary>
        private static readonly Matrix4x4 s_ToTwin =
            Matrix4x4.TRS(new Vector3(1f, 2f, 3f), Quaternion.Euler(20f, 50f, -30f), 2f * Vector3.one) * SkeletonMirror.AcrossX;

        [SetUp]
        public void Pair()
        {
            Editing.Twin = new SkeletonTwin(Left, s_ToTwin);
            Do("Mirror Onto Other Side");
            Editing.IsSymmetric = true;
        }

        [Test]
        public void MovingAJoint_MovesItsTwin()
        {
            Select((1, 2));

            Assert.That(Move(new Vector3(0.02f, 0.01f, 0.03f)).Done);

            MirrorTests.AssertMirrored(Left, Skeleton, s_ToTwin);
        }

        [Test]
        public void JointsThatAreLeftAlone_KeepTheirPlaceInTheTwin()
        {
            var own = new Vector3(9f, 8f, 7f);
            Left.Chains[3].joints[3] = own;
            Select((1, 2));

            Move(new Vector3(0.02f, 0.01f, 0.03f));

            Assert.That(Left.GetJoint(3, 3), Is.EqualTo(own));
        }

        [Test]
        public void BothSides_AreOneStepOfUndo()
        {
            string right = SkeletonText.Of(Skeleton), left = SkeletonText.Of(Left);
            Select((1, 2));
            Move(new Vector3(0.02f, 0f, 0f));

            Undo.Undo();

            Assert.That(SkeletonText.Of(Skeleton), Is.EqualTo(right));
            Assert.That(SkeletonText.Of(Left), Is.EqualTo(left));
        }

        [Test]
        public void SwitchedOff_TheTwinStays()
        {
            Editing.IsSymmetric = false;
            string left = SkeletonText.Of(Left);
            Select((1, 2));

            Move(new Vector3(0.02f, 0f, 0f));

            Assert.That(SkeletonText.Of(Left), Is.EqualTo(left));
        }

        [TestCaseSource(nameof(EditingCommands))]
        public void EveryCommand_KeepsThePairSymmetric(string command)
        {
            Select((1, 1), (1, 2), (2, 2));
            Move(new Vector3(0.01f, 0.005f, 0f));

            Assert.That(Do(command).Done);

            MirrorTests.AssertMirrored(Left, Skeleton, s_ToTwin);
        }

        [Test]
        public void TwinOfOtherCounts_IsRefused_AndBothStay()
        {
            Left.Chains = Left.Chains.Take(4).ToArray();
            string right = SkeletonText.Of(Skeleton), left = SkeletonText.Of(Left);
            Select((1, 2));

            EditOutcome outcome = Move(new Vector3(0.02f, 0f, 0f));

            Assert.That(outcome.Message,
                Is.EqualTo("Symmetric editing: 'Left Wing' has other counts. Mirror onto it first, or turn symmetry off."));
            Assert.That(SkeletonText.Of(Skeleton), Is.EqualTo(right));
            Assert.That(SkeletonText.Of(Left), Is.EqualTo(left));
        }

        private static IEnumerable<string> EditingCommands() =>
            SkeletonCommands.All.Select(command => command.Name).Where(name => !name.Contains("Select"));

        private EditOutcome Move(Vector3 delta) => Editing.Do("Move", (draft, selected) => MoveCommands.By(draft, selected, delta));
    }
}
