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
            WingSkeleton gone = ScriptableObject.CreateInstance<WingSkeleton>();
            var left = JointSelection.Of(gone);
            Assert.That(JointSelection.Of(gone), Is.SameAs(left));
            Object.DestroyImmediate(gone);

            JointSelection.Of(Right.Skeleton);

            Assert.That(left == null);
        }

        [Test]
        public void Settings_AreThereAgain_InTheNextSession()
        {
            SkeletonSession first = SkeletonSessions.Open(InsectTargets.Find(new[] { Insect }));
            first.Mode = DragMode.Surface;
            first.IsSymmetric = true;
            first.ShowsLabels = false;
            first.Overlay.ShowsBeat = true;
            first.Overlay.Phase = 0.7f;
            first.Overlay.Colours = RigColourMode.JointWeight;
            SkeletonSessions.Close(first);

            SkeletonSession second = SkeletonSessions.Open(InsectTargets.Find(new[] { Insect }));

            Assert.That(second.Mode, Is.EqualTo(DragMode.Surface));
            Assert.That(second.IsSymmetric);
            Assert.That(second.ShowsLabels, Is.False);
            Assert.That(second.Overlay.ShowsBeat);
            Assert.That(second.Overlay.Phase, Is.EqualTo(0.7f));
            Assert.That(second.Overlay.Colours, Is.EqualTo(RigColourMode.JointWeight));

            second.Overlay.Colours = null;
            Assert.That(SkeletonSessions.Open(InsectTargets.Find(new[] { Insect })).Overlay.Colours, Is.Null);
        }

        [Test]
        public void UndoneDrag_EndsThere_AndCanBeRedone()
        {
            View view = View.FromAbove;
            SkeletonSession session = SkeletonSessions.Open(InsectTargets.Find(new[] { Insect }));
            session.Select(session.Group.All[0], new[] { new JointIndex(2, 2) });
            string before = SkeletonText.Of(Right.Skeleton);
            Vector2 from = view.Project(session.Group.All[0].LocalToWorld.MultiplyPoint3x4(Right.Skeleton.GetJoint(2, 2)));
            session.Pointer.Press(view.Project, from, adds: false);
            session.Pointer.Move(from + new Vector2(40f, 0f), view.Through(from + new Vector2(40f, 0f)), DragMode.Free);
            string dragged = SkeletonText.Of(Right.Skeleton);

            UnityEditor.Undo.PerformUndo();
            session.Pointer.Move(from + new Vector2(80f, 0f), view.Through(from + new Vector2(80f, 0f)), DragMode.Free);
            session.Pointer.Release();

            Assert.That(dragged, Is.Not.EqualTo(before));
            Assert.That(SkeletonText.Of(Right.Skeleton), Is.EqualTo(before));
            UnityEditor.Undo.PerformRedo();
            Assert.That(SkeletonText.Of(Right.Skeleton), Is.EqualTo(dragged));
            UnityEditor.Undo.PerformUndo();
            Assert.That(SkeletonText.Of(Right.Skeleton), Is.EqualTo(before));
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
