using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    public sealed class SkeletonKeysTests : SkeletonSessionFixture
    {
        private SnapshotUndo m_Undo;
        private SkeletonSession m_Session;

        [SetUp]
        public void Open()
        {
            m_Undo = new SnapshotUndo();
            m_Session = new SkeletonSession(InsectTargets.Find(new[] { Insect }), m_Undo);
            m_Session.Select(m_Session.Group.All[0], new[] { new JointIndex(2, 2) });
        }

        [TearDown]
        public void Close() => m_Session.Dispose();

        [Test]
        public void EveryActWithAKey_IsDoneByIt()
        {
            foreach (EditCommand command in SkeletonCommands.All.Where(
                command => command.Key != KeyCode.None && command.Name != "Mirror Onto Other Side"))
            {
                Right.Skeleton.Chains[2].joints[2] += new Vector3(0.004f, 0.01f, 0.002f);
                Right.Skeleton.SpanAxis = new Vector3(1f, 0f, 0.2f);
                int steps = m_Undo.DoneCount;

                Assert.That(
                    SkeletonKeys.Press(m_Session, command.Key, command.Shift ? EventModifiers.Shift : EventModifiers.None), command.Name);

                Assert.That(m_Session.LastRefusal, Is.Null, command.Name);
                Assert.That(m_Undo.DoneCount, Is.EqualTo(steps + 1), command.Name);
                m_Undo.Undo();
            }
        }

        [Test]
        public void KeysWithCtrlOrAlt_AreLeftToTheEditor(
            [Values(EventModifiers.Control, EventModifiers.Alt, EventModifiers.Command)] EventModifiers held)
        {
            Assert.That(SkeletonKeys.Press(m_Session, KeyCode.C, held), Is.False);
            Assert.That(Right.Skeleton.ChainCount, Is.EqualTo(5));
        }

        [Test]
        public void SceneViewsOwnKeys_AreLeftToIt() => Assert.That(SkeletonKeys.Press(m_Session, KeyCode.F, EventModifiers.None), Is.False);

        [Test]
        public void Switches_HaveKeys()
        {
            Assert.That(SkeletonKeys.Press(m_Session, KeyCode.K, EventModifiers.None));
            Assert.That(m_Session.Overlay.ShowsBeat);
            Assert.That(SkeletonKeys.Press(m_Session, KeyCode.M, EventModifiers.Shift));
            Assert.That(m_Session.IsSymmetric);
        }

        [Test]
        public void SwitchesKeys_AreNoCommands()
        {
            Assert.That(SkeletonCommands.Find(SkeletonKeys.Beat, shift: false), Is.Null);
            bool shows = m_Session.Overlay.ShowsBeat;
            SkeletonKeys.Press(m_Session, SkeletonKeys.Beat, EventModifiers.Shift);
            Assert.That(m_Session.Overlay.ShowsBeat, Is.EqualTo(shows), "with shift it is another key");
            bool symmetric = m_Session.IsSymmetric;
            SkeletonKeys.Press(m_Session, SkeletonKeys.Symmetry, EventModifiers.None);
            Assert.That(m_Session.IsSymmetric, Is.EqualTo(symmetric));
            SkeletonKeys.Press(m_Session, SkeletonKeys.Symmetry, EventModifiers.Shift);
            Assert.That(m_Session.IsSymmetric, Is.Not.EqualTo(symmetric));
            Assert.That(SkeletonCommands.Find(SkeletonKeys.Symmetry, shift: true), Is.Null);
        }

        [Test]
        public void Escape_EndsTheDrag_ThenTheSelection_ThenIsLeftToTheEditor()
        {
            View view = View.FromAbove;
            SkeletonEditing editing = m_Session.Group.Active;
            string before = SkeletonText.Of(Right.Skeleton);
            Vector2 pixel = view.Project(editing.LocalToWorld.MultiplyPoint3x4(Right.Skeleton.GetJoint(2, 2)));
            m_Session.Pointer.Press(view.Project, pixel, adds: false);
            m_Session.Pointer.Move(pixel + new Vector2(40f, 0f), view.Through(pixel + new Vector2(40f, 0f)), DragMode.Free);
            Assert.That(SkeletonText.Of(Right.Skeleton), Is.Not.EqualTo(before));

            Assert.That(Escape());
            Assert.That(SkeletonText.Of(Right.Skeleton), Is.EqualTo(before));
            Assert.That(m_Session.Group.SelectedCount, Is.EqualTo(1));
            Assert.That(Escape());
            Assert.That(m_Session.Group.SelectedCount, Is.Zero);
            Assert.That(Escape(), Is.False);
        }

        [Test]
        public void ActsWait_WhileTheMouseIsDown()
        {
            View view = View.FromAbove;
            m_Session.Pointer.Press(view.Project, new Vector2(-9999f, 0f), adds: false);

            Assert.That(SkeletonKeys.Press(m_Session, KeyCode.C, EventModifiers.None));
            Assert.That(Right.Skeleton.ChainCount, Is.EqualTo(5));
        }

        [Test]
        public void Commands_OfTheEditMenu_AreUnderstood()
        {
            SkeletonKeys.Execute(m_Session, "SelectAll");
            Assert.That(m_Session.Group.SelectedCount, Is.EqualTo(50));
            SkeletonKeys.Execute(m_Session, "DeselectAll");
            Assert.That(m_Session.Group.SelectedCount, Is.Zero);

            m_Session.Select(m_Session.Group.All[1], SelectCommands.Chains(Left.Skeleton, new[] { new JointIndex(1, 0) }));
            SkeletonKeys.Execute(m_Session, "Delete");
            Assert.That(Left.Skeleton.ChainCount, Is.EqualTo(4));
            Assert.That(Right.Skeleton.ChainCount, Is.EqualTo(5));
            Assert.That(SkeletonKeys.Knows("FrameSelected"));
            Assert.That(SkeletonKeys.Knows("Copy"), Is.False);
        }

        private bool Escape() => SkeletonKeys.Press(m_Session, KeyCode.Escape, EventModifiers.None);
    }
}
