using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    public sealed class EditingGroupTests : EditingFixture
    {
        private SkeletonEditing m_Other;
        private EditingGroup m_Group;

        [SetUp]
        public void Group()
        {
            m_Other = Edit(Left);
            m_Group = new EditingGroup(new[] { Editing, m_Other }, Undo);
        }

        [Test]
        public void Acts_AreDoneToEverySkeletonWithASelection_InOneStep()
        {
            Select((1, 1));
            m_Other.Select(new[] { new JointIndex(2, 2) });
            string right = SkeletonText.Of(Skeleton), left = SkeletonText.Of(Left);
            int steps = Undo.DoneCount;

            Assert.That(m_Group.Do(SkeletonCommands.Find("Add Joint Row")).Done);

            Assert.That(Skeleton.JointsPerChain, Is.EqualTo(6));
            Assert.That(Left.JointsPerChain, Is.EqualTo(6));
            Assert.That(Undo.DoneCount, Is.EqualTo(steps + 1));
            Undo.Undo();
            Assert.That(SkeletonText.Of(Skeleton), Is.EqualTo(right));
            Assert.That(SkeletonText.Of(Left), Is.EqualTo(left));
        }

        [Test]
        public void SkeletonsWithoutASelection_StayAsTheyAre()
        {
            m_Other.Select(new[] { new JointIndex(2, 2) });
            m_Group.Active = Editing;

            m_Group.Do(SkeletonCommands.Find("Add Chain Behind"));

            Assert.That(Skeleton.ChainCount, Is.EqualTo(5));
            Assert.That(Left.ChainCount, Is.EqualTo(6));
        }

        [Test]
        public void WithNothingSelected_TheActiveOneIsChanged()
        {
            m_Group.Active = m_Other;
            string right = SkeletonText.Of(Skeleton), left = SkeletonText.Of(Left);

            m_Group.Do(SkeletonCommands.Find("Reverse Chains"));

            Assert.That(SkeletonText.Of(Skeleton), Is.EqualTo(right));
            Assert.That(SkeletonText.Of(Left), Is.Not.EqualTo(left));
        }

        [Test]
        public void OneRefusal_IsTold_AndTheOthersAreDone()
        {
            Select((1, 0));
            m_Other.Select(new[] { new JointIndex(2, 2) });

            EditOutcome outcome = m_Group.Do(SkeletonCommands.Find("Remove Joint Row"));

            Assert.That(outcome.Message, Does.StartWith("The roots cannot be removed"));
            Assert.That(Skeleton.JointsPerChain, Is.EqualTo(5));
            Assert.That(Left.JointsPerChain, Is.EqualTo(4));
        }

        [Test]
        public void SelectingInOne_UnselectsInTheOthers_UnlessAdding()
        {
            Select((1, 1));
            m_Group.Select(m_Other, new[] { new JointIndex(0, 0) }, adds: true);
            Assert.That(m_Group.SelectedCount, Is.EqualTo(2));

            m_Group.Select(m_Other, new[] { new JointIndex(3, 3) }, adds: false);
            Assert.That(m_Group.SelectedCount, Is.EqualTo(1));
            Assert.That(m_Other.Selection.Contains(new JointIndex(3, 3)));
        }

        [Test]
        public void Everything_IsSelectedEverywhere()
        {
            m_Group.SelectAll();

            Assert.That(m_Group.SelectedCount, Is.EqualTo(50));
        }

        [Test]
        public void Clicks_FindTheSkeletonUnderThem()
        {
            View view = View.FromAbove;
            Vector2 pixel = view.Project(Left.GetJoint(2, 3));

            Assert.That(m_Group.TryNearest(view.Project, pixel, 10f, out SkeletonEditing found, out JointIndex joint));

            Assert.That(found, Is.SameAs(m_Other));
            Assert.That(joint, Is.EqualTo(new JointIndex(2, 3)));
        }

        [Test]
        public void SymmetricPair_SelectedOnBothSides_IsChangedOnce()
        {
            Pair();
            Select((1, 1));
            m_Other.Select(new[] { new JointIndex(1, 1) });
            m_Group.Active = m_Other;

            Assert.That(m_Group.Acting(), Is.EqualTo(new[] { m_Other }));
            Assert.That(m_Group.Do(SkeletonCommands.Find("Add Chain Behind")).Done);

            Assert.That(Skeleton.ChainCount, Is.EqualTo(6));
            Assert.That(Left.ChainCount, Is.EqualTo(6));
            MirrorTests.AssertMirrored(Left, Skeleton, SkeletonMirror.AcrossX);
        }

        [Test]
        public void SymmetricDrag_OfBothSides_MirrorsTheMotion()
        {
            Pair();
            Select((2, 2));
            m_Other.Select(new[] { new JointIndex(2, 2) });
            View view = View.FromAbove;
            var pointer = new SkeletonPointer(m_Group, Undo);
            Vector2 pixel = view.Project(Skeleton.GetJoint(2, 2));

            pointer.Press(view.Project, pixel, adds: false);
            pointer.Move(pixel + new Vector2(30f, 10f), view.Through(pixel + new Vector2(30f, 10f)), DragMode.WingPlane);
            pointer.Release();

            MirrorTests.AssertMirrored(Left, Skeleton, SkeletonMirror.AcrossX);
        }

        [Test]
        public void LockedSkeleton_IsNotChanged_NotEvenAsATwin()
        {
            Editing.Lock = "It lies in a package.";
            Select((1, 1));
            Assert.That(Do("Add Chain Behind").Message, Is.EqualTo("It lies in a package."));

            m_Other.Twin = new SkeletonTwin(Skeleton, SkeletonMirror.AcrossX) { Lock = Editing.Lock };
            m_Other.IsSymmetric = true;
            m_Other.Select(new[] { new JointIndex(1, 1) });
            Assert.That(SkeletonCommands.Find("Add Chain Behind").Run(m_Other).Message, Is.EqualTo("It lies in a package."));
            Assert.That(SkeletonCommands.Find("Mirror Onto Other Side").Run(m_Other).Message, Is.EqualTo("It lies in a package."));
            Assert.That(Skeleton.ChainCount, Is.EqualTo(5));
            Assert.That(Left.ChainCount, Is.EqualTo(5));
        }

        [Test]
        public void Delete_RemovesWholeChains_ElseRows()
        {
            Select((1, 0), (1, 1), (1, 2), (1, 3), (1, 4));
            Assert.That(SkeletonCommands.ForDelete(Editing).Name, Is.EqualTo("Remove Chain"));

            Select((1, 1), (1, 2), (2, 2));
            Assert.That(SkeletonCommands.ForDelete(Editing).Name, Is.EqualTo("Remove Joint Row"));
        }

        [Test]
        public void Delete_MeansOfEachSkeleton_WhatIsSelectedThere()
        {
            Editing.Select(SelectCommands.Chains(Skeleton, new[] { new JointIndex(1, 0) }));
            m_Other.Select(new[] { new JointIndex(1, 2) });

            Assert.That(m_Group.Do(SkeletonCommands.Delete).Done);

            Assert.That((Skeleton.ChainCount, Skeleton.JointsPerChain), Is.EqualTo((4, 5)));
            Assert.That((Left.ChainCount, Left.JointsPerChain), Is.EqualTo((5, 4)));
        }

        private void Pair()
        {
            m_Other.Twin = new SkeletonTwin(Skeleton, SkeletonMirror.AcrossX);
            Editing.IsSymmetric = m_Other.IsSymmetric = true;
        }

        [Test]
        public void EmptyGroup_RefusesCommands()
        {
            var none = new EditingGroup(new SkeletonEditing[0], Undo);

            Assert.That(none.Do(SkeletonCommands.Find("Smooth")).Message, Is.EqualTo("There is no skeleton to edit."));
            Assert.That(none.Active, Is.Null);
        }
    }
}
