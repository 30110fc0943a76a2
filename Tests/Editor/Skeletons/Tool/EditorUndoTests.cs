using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor.Tests
{
    /// <summary>Commands in the editor's own undo history.</summary>
    public sealed class EditorUndoTests
    {
        private WingSkeleton m_Skeleton;
        private JointSelection m_Selection;
        private EditorUndo m_Undo;
        private SkeletonEditing m_Editing;

        [SetUp]
        public void Begin()
        {
            m_Skeleton = InsectCatalogue.Find("monarch").Wings[0].CreateSkeleton(WingSide.Right);
            m_Selection = JointSelection.Create(m_Skeleton);
            m_Undo = new EditorUndo();
            m_Editing = new SkeletonEditing(m_Selection, m_Undo)
            {
                Surface = new SnapSurface(InsectCatalogue.Find("monarch").Wings[0].CreateSurface(WingSide.Right)),
            };
        }

        [TearDown]
        public void Clear()
        {
            UnityEditor.Undo.ClearAll();
            Object.DestroyImmediate(m_Selection);
            Object.DestroyImmediate(m_Skeleton);
        }

        [TestCaseSource(nameof(Commands))]
        public void EveryCommand_IsUndoneToTheIdenticalAsset_AndRedone(string command)
        {
            m_Skeleton.Chains[2].joints[2] += new Vector3(0.01f, 0.02f, 0.005f);
            m_Editing.Select(new[] { new JointIndex(1, 2), new JointIndex(2, 2) });
            string before = State();

            Assert.That(SkeletonCommands.Find(command).Run(m_Editing).Done);
            string after = State();
            Assert.That(after, Is.Not.EqualTo(before));

            UnityEditor.Undo.PerformUndo();
            Assert.That(State(), Is.EqualTo(before));
            UnityEditor.Undo.PerformRedo();
            Assert.That(State(), Is.EqualTo(after));
        }

        [Test]
        public void Drag_IsOneStep()
        {
            m_Editing.Select(new[] { new JointIndex(2, 2) });
            string before = State();
            var drag = new JointDrag(new[] { m_Editing }, m_Editing, new JointIndex(2, 2), m_Undo);
            for (int k = 0; k < 10; k++)
                drag.Update(new Ray(new Vector3(0.2f + 0.01f * k, 2f, 0f), Vector3.down), DragMode.WingPlane);
            drag.End();
            string after = State();

            UnityEditor.Undo.PerformUndo();
            Assert.That(State(), Is.EqualTo(before));
            UnityEditor.Undo.PerformRedo();
            Assert.That(State(), Is.EqualTo(after).And.Not.EqualTo(before));
        }

        [Test]
        public void Drag_IsOneStep_ThoughTheEditorBeginsAGroupWithEachEvent()
        {
            m_Editing.Select(new[] { new JointIndex(2, 2) });
            WingSkeleton other = InsectCatalogue.Find("monarch").Wings[0].CreateSkeleton(WingSide.Left);
            try
            {
                string before = State(), others = SkeletonText.Of(other);
                m_Undo.Begin("Move Joints");
                foreach (WingSkeleton moved in new[] { m_Skeleton, other })
                {
                    UnityEditor.Undo.IncrementCurrentGroup();
                    m_Undo.Record(moved);
                    moved.Hinge += Vector3.up;
                }

                m_Undo.End();
                UnityEditor.Undo.PerformUndo();

                Assert.That(State(), Is.EqualTo(before));
                Assert.That(SkeletonText.Of(other), Is.EqualTo(others));
            }
            finally
            {
                Object.DestroyImmediate(other);
            }
        }

        [Test]
        public void CancelledDrag_LeavesNothing()
        {
            m_Editing.Select(new[] { new JointIndex(2, 2) });
            string before = State();
            var drag = new JointDrag(new[] { m_Editing }, m_Editing, new JointIndex(2, 2), m_Undo);
            drag.Update(new Ray(new Vector3(0.5f, 2f, 0f), Vector3.down), DragMode.WingPlane);

            drag.Cancel();

            Assert.That(State(), Is.EqualTo(before));
            UnityEditor.Undo.PerformRedo();
            Assert.That(State(), Is.EqualTo(before), "nothing to redo");
        }

        [Test]
        public void ChangedAssets_AreMarkedToBeSaved()
        {
            m_Editing.Select(new[] { new JointIndex(2, 2) });
            SkeletonCommands.Find("Smooth").Run(m_Editing);

            Assert.That(EditorUtility.IsDirty(m_Skeleton));
        }

        [Test]
        public void ManySteps_AreUndoneOneByOne()
        {
            var states = new List<string> { State() };
            foreach (int joint in new[] { 1, 2, 3 })
            {
                m_Editing.Do(
                    "Move", (draft, selected) => MoveCommands.By(draft, new[] { new JointIndex(2, joint) }, new Vector3(0f, 0.01f, 0f)));
                states.Add(State());
            }

            for (int k = states.Count - 2; k >= 0; k--)
            {
                UnityEditor.Undo.PerformUndo();
                Assert.That(State(), Is.EqualTo(states[k]));
            }
        }

        private static IEnumerable<string> Commands() =>
            SkeletonCommands.All.Select(command => command.Name).Where(name => name != "Mirror Onto Other Side" && name != "Mend");

        private string State() => SkeletonText.Of(m_Skeleton) + string.Join(" ", m_Selection.Joints.Select(joint => joint.ToString()));
    }
}
