using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    public sealed class SlideCommandsTests : EditingFixture
    {
        [Test]
        public void InnerJoint_SlidesAlongItsBones_ByTheDistance()
        {
            var path = new JointPath(Skeleton.Chains[0].joints);
            Vector3 outer = Skeleton.GetJoint(0, 3), here = Skeleton.GetJoint(0, 2);
            float bone = Vector3.Distance(here, outer);
            Select((0, 2));

            Assert.That(Slide(0.4f * bone).Done);

            Vector3 slid = Skeleton.GetJoint(0, 2);
            Assert.That(Vector3.Distance(here, slid), Is.EqualTo(0.4f * bone).Within(1e-5f));
            Assert.That(Vector3.Distance(slid, outer), Is.EqualTo(0.6f * bone).Within(1e-5f), "on the bone");
            Assert.That(Vector3.Distance(slid, path.At(path.DistanceOf(2) + 0.4f * bone)), Is.LessThan(1e-6f));
        }

        [Test]
        public void InnerJoint_NeverPassesItsNeighbours([Values(-100f, 100f)] float far)
        {
            Vector3 inner = Skeleton.GetJoint(2, 1), outer = Skeleton.GetJoint(2, 3);
            Select((2, 2));

            Assert.That(Slide(far).Done);

            Vector3 slid = Skeleton.GetJoint(2, 2);
            Assert.That(Vector3.Distance(slid, far > 0f ? outer : inner), Is.GreaterThan(0f));
            Assert.That(Skeleton.Validate(), Is.Empty);
        }

        [Test]
        public void Neighbours_SlideTogether_AndKeepTheirOrder([Values(-100f, -0.02f, 0.02f, 100f)] float distance)
        {
            Select((2, 1), (2, 2), (2, 3));

            Assert.That(Slide(distance).Done);

            var path = new JointPath(Skeleton.Chains[2].joints);
            for (int j = 1; j < 5; j++)
                Assert.That(path.DistanceOf(j), Is.GreaterThan(path.DistanceOf(j - 1)));
            Assert.That(Skeleton.Validate(), Is.Empty);
        }

        [Test]
        public void JointsThatSlideTogether_AllGoTheWholeWay_WhereTheyHaveRoom()
        {
            var before = (Vector3[])Skeleton.Chains[2].joints.Clone();
            var path = new JointPath(before);
            float distance = path.DistanceOf(2) - path.DistanceOf(1);
            Select((2, 1), (2, 2), (2, 3), (2, 4));

            Assert.That(Slide(distance).Done);

            for (int j = 1; j < 5; j++)
                Assert.That(Vector3.Distance(Skeleton.GetJoint(2, j), path.At(path.DistanceOf(j) + distance)), Is.LessThan(1e-5f));
        }

        [Test]
        public void AJointBehindOneThatIsHeld_StopsShortOfIt_AndOneBehindItShortOfThat([Values(-1, 1)] int way)
        {
            // The outermost that slides stops 2 % of its bone before its neighbour, and so on inwards.
            var path = new JointPath((Vector3[])Skeleton.Chains[2].joints.Clone());
            Select((2, 1), (2, 2), (2, 3));
            int first = way > 0 ? 3 : 1, held = way > 0 ? 4 : 0, last = way > 0 ? 1 : 3;

            Assert.That(Slide(way * 100f).Done);

            float limit = path.DistanceOf(held) + SlideCommands.Gap * (path.DistanceOf(first) - path.DistanceOf(held));
            Assert.That(Vector3.Distance(Skeleton.GetJoint(2, first), path.At(limit)), Is.LessThan(1e-5f));
            limit += SlideCommands.Gap * (path.DistanceOf(2) - path.DistanceOf(first));
            Assert.That(Vector3.Distance(Skeleton.GetJoint(2, 2), path.At(limit)), Is.LessThan(1e-5f));
            limit += SlideCommands.Gap * (path.DistanceOf(last) - path.DistanceOf(2));
            Assert.That(Vector3.Distance(Skeleton.GetJoint(2, last), path.At(limit)), Is.LessThan(1e-5f));
        }

        [Test]
        public void AJointBehindOneThatSlidesFreely_GoesAsFarAsThatMakesWay()
        {
            // Joint 2 moves by half of its bone and frees that much; joint 1 asks for the same way and has it.
            var path = new JointPath((Vector3[])Skeleton.Chains[2].joints.Clone());
            float bone = path.DistanceOf(3) - path.DistanceOf(2), own = path.DistanceOf(2) - path.DistanceOf(1);
            float distance = 0.5f * bone;
            Select((2, 1), (2, 2));

            Assert.That(Slide(distance).Done);

            float way = Mathf.Min(distance, own + distance - SlideCommands.Gap * own);
            Assert.That(Vector3.Distance(Skeleton.GetJoint(2, 2), path.At(path.DistanceOf(2) + distance)), Is.LessThan(1e-5f));
            Assert.That(Vector3.Distance(Skeleton.GetJoint(2, 1), path.At(path.DistanceOf(1) + way)), Is.LessThan(1e-5f));
        }

        [Test]
        public void Tip_SlidesOnTheLineOfItsBone_BothWays([Values(-0.02f, 0.05f)] float distance)
        {
            Vector3 inner = Skeleton.GetJoint(0, 3), tip = Skeleton.GetJoint(0, 4);
            Vector3 outwards = (tip - inner).normalized;
            Select((0, 4));

            Slide(distance);

            Assert.That(Vector3.Distance(Skeleton.GetJoint(0, 4), tip + outwards * distance), Is.LessThan(1e-5f));
        }

        private EditOutcome Slide(float distance) => Editing.Do("Slide", (draft, selected) => SlideCommands.By(draft, selected, distance));
    }
}
