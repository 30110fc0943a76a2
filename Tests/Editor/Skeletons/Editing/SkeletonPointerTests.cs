using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    public sealed class SkeletonPointerTests : EditingFixture
    {
        private readonly View m_View = View.FromAbove;
        private EditingGroup m_Group;
        private SkeletonPointer m_Pointer;

        [SetUp]
        public void Point()
        {
            m_Group = new EditingGroup(new[] { Editing }, Undo);
            m_Pointer = new SkeletonPointer(m_Group, Undo);
        }

        [Test]
        public void Click_SelectsTheJoint_AndNothingElse()
        {
            Click((1, 2));
            Click((3, 4));

            Assert.That(Selected(), Is.EqualTo(new[] { (3, 4) }));
        }

        [Test]
        public void AddingClick_Adds_AndTakesAwayWhatIsSelected()
        {
            Click((1, 2));
            Click((3, 4), adds: true);
            Assert.That(Selected(), Is.EqualTo(new[] { (1, 2), (3, 4) }));

            Click((1, 2), adds: true);
            Assert.That(Selected(), Is.EqualTo(new[] { (3, 4) }));
        }

        [Test]
        public void DoubleClick_SelectsTheChain()
        {
            Press(Pixel((2, 1)), clicks: 2);
            m_Pointer.Release();

            Assert.That(Selected(), Is.EqualTo(Enumerable.Range(0, 5).Select(j => (2, j))));
        }

        [Test]
        public void ClickOnNothing_SelectsNothing_UnlessAdding()
        {
            Click((1, 2));
            Press(new Vector2(-900f, 900f), adds: true);
            m_Pointer.Release();
            Assert.That(Selected(), Is.Not.Empty);

            Press(new Vector2(-900f, 900f));
            m_Pointer.Release();
            Assert.That(Selected(), Is.Empty);
        }

        [Test]
        public void DragFromNothing_SelectsTheJointsInTheBox()
        {
            Press(new Vector2(-900f, -900f));
            Move(new Vector2(900f, 900f));
            Assert.That(m_Pointer.Box, Is.EqualTo(new Rect(-900f, -900f, 1800f, 1800f)));
            m_Pointer.Release();

            Assert.That(Selected().Length, Is.EqualTo(25));
            Assert.That(m_Pointer.Box, Is.Null);
        }

        [TestCase(3.9f, false)]
        [TestCase(4.1f, true)]
        public void FromFourPixelsOn_AMovementIsADrag(float pixels, bool drags)
        {
            string before = SkeletonText.Of(Skeleton);
            Vector2 from = View.FromAbove.Project(Skeleton.GetJoint(2, 2)), to = from + new Vector2(0f, pixels);
            var pointer = new SkeletonPointer(new EditingGroup(new[] { Editing }, Undo), Undo);
            pointer.Press(View.FromAbove.Project, from, false);
            pointer.Move(to, View.FromAbove.Through(to), DragMode.WingPlane);
            Assert.That((pointer.IsMoving, SkeletonText.Of(Skeleton) != before), Is.EqualTo((drags, drags)));
            pointer.Move(from, View.FromAbove.Through(from), DragMode.WingPlane);
            Assert.That(pointer.IsMoving, Is.EqualTo(drags), "once dragged, also where it comes back");
            pointer.Release();
            Assert.That(pointer.IsDown, Is.False);
        }

        [TestCase(11.9f, 1)]
        [TestCase(12.1f, 0)]
        public void APress_TakesAJointWithinTwelvePixels(float pixels, int selected)
        {
            Vector2 at = View.FromAbove.Project(Skeleton.GetJoint(0, 4));
            Vector2 inwards = at - (Vector2)View.FromAbove.Project(Skeleton.GetJoint(2, 2));
            var group = new EditingGroup(new[] { Editing }, Undo);
            var pointer = new SkeletonPointer(group, Undo);
            pointer.Press(View.FromAbove.Project, at + pixels * inwards.normalized, false);
            pointer.Release();
            Assert.That(group.SelectedCount, Is.EqualTo(selected));
        }

        [Test]
        public void SmallMovement_IsStillAClick()
        {
            string before = SkeletonText.Of(Skeleton);
            Press(Pixel((2, 2)));
            Move(Pixel((2, 2)) + new Vector2(2f, 2f));
            m_Pointer.Release();

            Assert.That(SkeletonText.Of(Skeleton), Is.EqualTo(before));
        }

        [Test]
        public void DragFromASelectedJoint_MovesAllSelectedOnes_AndKeepsThemSelected()
        {
            Click((2, 2));
            Click((2, 3), adds: true);
            Vector3 first = Skeleton.GetJoint(2, 2), second = Skeleton.GetJoint(2, 3);

            Press(Pixel((2, 2)));
            Move(Pixel((2, 2)) + new Vector2(30f, -20f));
            Assert.That(m_Pointer.IsMoving);
            m_Pointer.Release();

            Assert.That(Vector3.Distance(Skeleton.GetJoint(2, 2) - first, new Vector3(0.03f, 0f, -0.02f)), Is.LessThan(1e-5f));
            Assert.That(Vector3.Distance(Skeleton.GetJoint(2, 3) - second, new Vector3(0.03f, 0f, -0.02f)), Is.LessThan(1e-5f));
            Assert.That(Selected(), Is.EqualTo(new[] { (2, 2), (2, 3) }));
        }

        [Test]
        public void DragFromAnotherJoint_SelectsAndMovesThatOneOnly()
        {
            Click((0, 4));
            Vector3 tip = Skeleton.GetJoint(0, 4);

            Press(Pixel((2, 2)));
            Move(Pixel((2, 2)) + new Vector2(10f, 0f));
            m_Pointer.Release();

            Assert.That(Selected(), Is.EqualTo(new[] { (2, 2) }));
            Assert.That(Skeleton.GetJoint(0, 4), Is.EqualTo(tip));
        }

        [Test]
        public void TheNextDrag_MovesWhatItTakes_AndNotWhatTheOneBeforeTook()
        {
            Press(Pixel((2, 2)));
            Move(Pixel((2, 2)) + new Vector2(10f, 0f));
            m_Pointer.Release();
            Vector3 moved = Skeleton.GetJoint(2, 2), tip = Skeleton.GetJoint(0, 4);
            Press(Pixel((0, 4)));
            Move(Pixel((0, 4)) + new Vector2(0f, 20f));
            m_Pointer.Release();

            Assert.That(Skeleton.GetJoint(2, 2), Is.EqualTo(moved));
            Assert.That(Vector3.Distance(Skeleton.GetJoint(0, 4) - tip, new Vector3(0f, 0f, 0.02f)), Is.LessThan(1e-5f));
        }

        [Test]
        public void Escape_TakesTheDragBack()
        {
            string before = SkeletonText.Of(Skeleton);
            Press(Pixel((2, 2)));
            Move(Pixel((2, 2)) + new Vector2(50f, 0f));
            Assert.That(SkeletonText.Of(Skeleton), Is.Not.EqualTo(before));

            m_Pointer.Cancel();
            m_Pointer.Release();

            Assert.That(SkeletonText.Of(Skeleton), Is.EqualTo(before));
            Assert.That(m_Pointer.IsDown, Is.False);
        }

        [Test]
        public void ClickOnOneOfSeveral_SelectsItAlone_WhenItWasNotDragged()
        {
            Click((2, 2));
            Click((2, 3), adds: true);

            Click((2, 3));

            Assert.That(Selected(), Is.EqualTo(new[] { (2, 3) }));
        }

        private void Click((int chain, int joint) at, bool adds = false)
        {
            Press(Pixel(at), adds);
            m_Pointer.Release();
        }

        private void Press(Vector2 pixel, bool adds = false, int clicks = 1) => m_Pointer.Press(m_View.Project, pixel, adds, clicks);

        private void Move(Vector2 pixel) => m_Pointer.Move(pixel, m_View.Through(pixel), DragMode.WingPlane);

        private Vector2 Pixel((int chain, int joint) at) => m_View.Project(Skeleton.GetJoint(at.chain, at.joint));

        private (int, int)[] Selected() => Editing.Selection.Living().Select(s => (s.chain, s.joint)).ToArray();
    }
}
