using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    public sealed class JointDragTests : EditingFixture
    {
        private static readonly JointIndex s_Joint = new JointIndex(2, 2);

        [Test]
        public void InThePlaneOfTheWing_TheJointFollowsThePointer_AtItsHeight([Values(0f, 35f)] float roll)
        {
            Editing.LocalToWorld = Matrix4x4.TRS(new Vector3(1f, 0f, 0f), Quaternion.Euler(roll, 10f, 0f), Vector3.one);
            Vector3 before = Local();
            JointDrag drag = Grab(s_Joint);
            Ray ray = Above(World() + new Vector3(0.03f, 0f, 0.02f));

            Assert.That(drag.Update(ray, DragMode.WingPlane).Done);
            drag.End();

            Assert.That(OffRay(ray), Is.LessThan(1e-5f));
            Assert.That(Local().y, Is.EqualTo(before.y).Within(1e-5f));
        }

        [Test]
        public void Freely_TheJointFollowsThePointer_InTheScreensPlane()
        {
            Vector3 before = World();
            var ray = new Ray(before + new Vector3(0.02f, 0.05f, -3f), Vector3.forward);
            JointDrag drag = Grab(s_Joint);

            drag.Update(ray, DragMode.Free);
            drag.End();

            Assert.That(Vector3.Distance(World(), before + new Vector3(0.02f, 0.05f, 0f)), Is.LessThan(1e-5f));
        }

        [Test]
        public void PlaneSeenEdgeOn_IsNotLeft_AndNothingFliesAway()
        {
            Vector3 before = World();
            var ray = new Ray(before + new Vector3(0.02f, 0.05f, -3f), new Vector3(0f, 0.001f, 1f));
            JointDrag drag = Grab(s_Joint);

            drag.Update(ray, DragMode.WingPlane);
            drag.End();

            Assert.That(Local().y, Is.EqualTo(before.y).Within(1e-6f));
            Assert.That(World().x - before.x, Is.EqualTo(0.02f).Within(1e-3f));
            Assert.That(Vector3.Distance(World(), before), Is.LessThan(0.1f));
        }

        [Test]
        public void OverTheSurface_TheJointLiesOnTheMeshUnderThePointer()
        {
            Skeleton.Chains[2].joints[2].y = 0.2f;
            Vector3 target = Skeleton.GetJoint(2, 1);
            var ray = new Ray(target + new Vector3(0.5f, 1f, 0.3f), -new Vector3(0.5f, 1f, 0.3f));
            JointDrag drag = Grab(s_Joint);

            drag.Update(ray, DragMode.Surface);
            drag.End();

            Assert.That(Vector3.Distance(Local(), target), Is.LessThan(1e-5f));
        }

        [Test]
        public void AlongTheChain_TheJointSlidesToThePointClosestToTheRay()
        {
            Vector3 inner = Skeleton.GetJoint(2, 1), outer = Skeleton.GetJoint(2, 2);
            Vector3 wanted = Vector3.Lerp(inner, outer, 0.3f), across = Vector3.Cross(outer - inner, Vector3.up).normalized;
            JointDrag drag = Grab(s_Joint);

            drag.Update(Above(wanted + 0.01f * across), DragMode.Chain);
            drag.End();

            Assert.That(Vector3.Distance(Local(), wanted), Is.LessThan(1e-5f));
        }

        [Test]
        public void WholeDrag_IsOneStep_AndGoingBackGoesBackExactly()
        {
            Editing.IsSymmetric = true;
            string before = SkeletonText.Of(Skeleton), left = SkeletonText.Of(Left);
            Select((2, 2), (2, 3));
            int steps = Undo.DoneCount;
            Ray start = Above(World());
            JointDrag drag = Grab(s_Joint);

            for (int k = 0; k < 20; k++)
                drag.Update(Above(World() + new Vector3(0.003f, 0f, 0.002f)), DragMode.WingPlane);
            string moved = SkeletonText.Of(Skeleton);
            drag.Update(start, DragMode.WingPlane);
            Vector3 image = SkeletonMirror.AcrossX.MultiplyPoint3x4(Local());
            Assert.That(Vector3.Distance(Left.GetJoint(2, 2), image), Is.LessThan(1e-6f), "the twin came back too");
            drag.End();

            Assert.That(moved, Is.Not.EqualTo(before));
            Assert.That(Undo.DoneCount, Is.EqualTo(steps + 1));
            Undo.Undo();
            Assert.That(SkeletonText.Of(Skeleton), Is.EqualTo(before));
            Assert.That(SkeletonText.Of(Left), Is.EqualTo(left));
        }

        [Test]
        public void CancelledDrag_PutsEverythingBack_AndLeavesNoStep()
        {
            string before = SkeletonText.Of(Skeleton);
            Select((2, 2));
            int steps = Undo.DoneCount;
            JointDrag drag = Grab(s_Joint);
            drag.Update(Above(World() + Vector3.right), DragMode.WingPlane);

            drag.Cancel();

            Assert.That(SkeletonText.Of(Skeleton), Is.EqualTo(before));
            Assert.That(Undo.DoneCount, Is.EqualTo(steps));
        }

        [Test]
        public void SeveralSkeletons_MoveByTheSameWayInTheWorld()
        {
            SkeletonEditing other = Edit(Left);
            other.LocalToWorld = Matrix4x4.TRS(new Vector3(5f, 0f, 0f), Quaternion.Euler(0f, 90f, 0f), 2f * Vector3.one);
            other.Select(new[] { s_Joint });
            Select((2, 2));
            Vector3 otherBefore = other.LocalToWorld.MultiplyPoint3x4(Left.GetJoint(2, 2)), before = World();
            var drag = new JointDrag(new[] { Editing, other }, Editing, s_Joint, Undo);

            drag.Update(Above(before + new Vector3(0.04f, 0f, 0.01f)), DragMode.WingPlane);
            drag.End();

            Vector3 by = other.LocalToWorld.MultiplyPoint3x4(Left.GetJoint(2, 2)) - otherBefore;
            Assert.That(Vector3.Distance(by, World() - before), Is.LessThan(1e-5f));
        }

        [Test]
        public void SeveralSkeletons_SlideByTheSameLengthInTheWorld()
        {
            SkeletonEditing other = Edit(Left);
            other.LocalToWorld = Matrix4x4.TRS(new Vector3(5f, 0f, 0f), Quaternion.Euler(0f, 90f, 0f), 2f * Vector3.one);
            other.Select(new[] { s_Joint });
            Select((2, 2));
            Vector3 inner = Skeleton.GetJoint(2, 1), outer = Skeleton.GetJoint(2, 2), otherBefore = Left.GetJoint(2, 2);
            var drag = new JointDrag(new[] { Editing, other }, Editing, s_Joint, Undo);

            drag.Update(Above(Vector3.Lerp(inner, outer, 0.7f)), DragMode.Chain);
            drag.End();

            float own = Vector3.Distance(Local(), outer), others = 2f * Vector3.Distance(Left.GetJoint(2, 2), otherBefore);
            Assert.That(own, Is.GreaterThan(0.02f));
            Assert.That(others, Is.EqualTo(own).Within(1e-4f));
        }

        [Test]
        public void InThePlaneOfTheWing_TheHeightStays_ThoughTheWingIsScaledUnevenly()
        {
            Editing.LocalToWorld =
                Matrix4x4.TRS(Vector3.one, Quaternion.Euler(20f, 30f, 40f), Vector3.one) * Matrix4x4.Scale(new Vector3(1f, 3f, 0.5f));
            Skeleton.UpAxis = new Vector3(0.2f, 1f, 0.4f);
            Assert.That(WingAxes.TryMake(Skeleton.SpanAxis, Skeleton.UpAxis, out Unity.Mathematics.float3x3 axes));
            Vector3 before = Local(), normal = axes.c1;
            JointDrag drag = Grab(s_Joint);

            drag.Update(Above(World() + new Vector3(0.03f, 0f, 0.02f)), DragMode.WingPlane);
            drag.End();

            Assert.That(Vector3.Distance(Local(), before), Is.GreaterThan(0.01f));
            Assert.That(Vector3.Dot(Local() - before, normal), Is.EqualTo(0f).Within(1e-5f));
        }

        [Test]
        public void FlattenedPlacement_RefusesOrStays_ButNothingBreaks()
        {
            Editing.LocalToWorld = Matrix4x4.Scale(new Vector3(1f, 0f, 0f));
            JointDrag drag = Grab(s_Joint);
            foreach (DragMode mode in System.Enum.GetValues(typeof(DragMode)))
                drag.Update(Above(new Vector3(0.3f, 0f, 0.1f)), mode);
            drag.End();

            Assert.That(Skeleton.Validate(), Is.Empty);
        }

        private JointDrag Grab(JointIndex joint)
        {
            if (!Editing.Selection.Contains(joint))
                Select((joint.chain, joint.joint));
            return new JointDrag(new[] { Editing }, Editing, joint, Undo);
        }

        private static Ray Above(Vector3 point) => new Ray(point + new Vector3(0f, 3f, 0f), Vector3.down);

        private float OffRay(Ray ray) => Vector3.Cross(World() - ray.origin, ray.direction).magnitude;

        private Vector3 Local() => Skeleton.GetJoint(s_Joint.chain, s_Joint.joint);

        private Vector3 World() => Editing.LocalToWorld.MultiplyPoint3x4(Local());
    }
}
