using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    public sealed class UndoTests : EditingFixture
    {
        [TestCaseSource(nameof(Commands))]
        public void EveryCommand_IsUndoneToTheIdenticalAsset_AndRedone(string command)
        {
            Roughen(command);
            Select((1, 2), (2, 1), (2, 2));
            string before = State();
            int steps = Undo.DoneCount;

            Assert.That(Do(command).Done, command);
            string after = State();

            Assert.That(after, Is.Not.EqualTo(before), "the command changes something");
            Assert.That(Undo.DoneCount, Is.EqualTo(steps + 1), "in one step");
            Assert.That(
                Undo.LastName, Is.EqualTo(command.Contains("Select") ? "Select Joints" : command.Replace(" Onto Other Side", " Skeleton")));
            Assert.That(Undo.ChangedUnrecorded, Is.False);
            Undo.Undo();
            Assert.That(State(), Is.EqualTo(before));
            Undo.Redo();
            Assert.That(State(), Is.EqualTo(after));
        }

        [Test]
        public void ActsThatChangeNothing_LeaveNoStep()
        {
            Do("Fit Axes");
            int steps = Undo.DoneCount;

            Assert.That(Do("Fit Axes").Done);

            Assert.That(Undo.DoneCount, Is.EqualTo(steps));
        }

        [Test]
        public void ActsNeverShareArrays_WithWhatUndoKeeps()
        {
            JointChain[] chains = Skeleton.Chains;
            Vector3[] joints = chains[1].joints;
            var copy = (Vector3[])joints.Clone();
            Select((1, 2));

            Editing.Do("Move", (draft, selected) => MoveCommands.By(draft, selected, Vector3.one));

            Assert.That(joints, Is.EqualTo(copy));
            Assert.That(Skeleton.Chains, Is.Not.SameAs(chains));
        }

        [Test]
        public void Selections_AreUndone()
        {
            Select((1, 2));
            Select((3, 4), (2, 2));

            Undo.Undo();

            Assert.That(Editing.Selection.Living(), Is.EqualTo(new[] { new JointIndex(1, 2) }));
        }

        [Test]
        public void SelectionsOfRemovedJoints_ComeBackWithThem()
        {
            Select((4, 4));
            Do("Remove Chain");
            Assert.That(Editing.Selection.Living(), Is.Empty);

            Undo.Undo();

            Assert.That(Editing.Selection.Living(), Is.EqualTo(new[] { new JointIndex(4, 4) }));
        }

        private static IEnumerable<string> Commands() => SkeletonCommands.All.Select(command => command.Name);

        // So that no command has nothing to do.
        private void Roughen(string command)
        {
            Skeleton.Chains[2].joints[2] += new Vector3(0.01f, 0.02f, 0.005f);
            Skeleton.Chains[1].joints[2] += new Vector3(0.01f, 0.02f, -0.005f);
            Skeleton.Chains[3].joints = Skeleton.Chains[3].joints.Select(p => p + new Vector3(0.001f, 0f, 0f)).ToArray();
            Skeleton.SpanAxis = new Vector3(1f, 0.1f, 0f);
            if (command == "Mend")
                Skeleton.Chains[4].joints[1] = Vector3.positiveInfinity;
        }

        private string State() =>
            SkeletonText.Of(Skeleton) + "\n" + SkeletonText.Of(Left) + "\n"
            + string.Join(" ", Editing.Selection.Joints.Select(s => s.ToString()));
    }
}
