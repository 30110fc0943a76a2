using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    public sealed class SkeletonSessionsTests : SkeletonSessionFixture
    {
        [TearDown]
        public void Close()
        {
            SkeletonSessions.Close(SkeletonSessions.Current);
            UnityEditor.Undo.ClearAll();
        }

        [Test]
        public void OpeningASession_EndsTheOneBefore()
        {
            SkeletonSession first = SkeletonSessions.Open(InsectTargets.Find(new[] { Insect }));
            first.Overlay.ShowsBeat = true;
            first.Place();
            Mesh shown = first.Overlay.BeatMesh;

            SkeletonSession second = SkeletonSessions.Open(InsectTargets.Find(new[] { Insect }));

            Assert.That(SkeletonSessions.Current, Is.SameAs(second));
            Assert.That(shown == null, "the first one's mesh is destroyed");
        }

        [Test]
        public void Selections_AreThereAgain_WhenTheToolIsTakenUpAgain_AndUndoFindsThem()
        {
            SkeletonSession first = SkeletonSessions.Open(InsectTargets.Find(new[] { Insect }));
            first.Select(first.Group.All[0], new[] { new JointIndex(1, 1) });
            first.Select(first.Group.All[0], new[] { new JointIndex(2, 2) });
            SkeletonSessions.Close(first);

            SkeletonSession second = SkeletonSessions.Open(InsectTargets.Find(new[] { Insect }));
            Assert.That(second.Group.All[0].Selection.Living(), Is.EqualTo(new[] { new JointIndex(2, 2) }));

            UnityEditor.Undo.PerformUndo();
            Assert.That(second.Group.All[0].Selection.Living(), Is.EqualTo(new[] { new JointIndex(1, 1) }));
        }

        [Test]
        public void SelectionsOfDestroyedSkeletons_AreCleanedAway()
        {
            var gone = ScriptableObject.CreateInstance<WingSkeleton>();
            JointSelection left = JointSelection.Of(gone);
            Assert.That(JointSelection.Of(gone), Is.SameAs(left));
            Object.DestroyImmediate(gone);

            JointSelection.Of(Right.Skeleton);

            Assert.That(left == null);
        }

        [Test]
        public void ClosingAnEarlierSession_LeavesTheLaterOne()
        {
            SkeletonSession first = SkeletonSessions.Open(InsectTargets.Find(new[] { Insect }));
            SkeletonSession second = SkeletonSessions.Open(InsectTargets.Find(new[] { Insect }));

            SkeletonSessions.Close(first);

            Assert.That(SkeletonSessions.Current, Is.SameAs(second));
        }
    }
}
