using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    public sealed class JointPickingTests : EditingFixture
    {
        private static readonly View s_View = View.FromAbove;

        [Test]
        public void EveryJoint_IsFound_AtItsOwnPixel()
        {
            foreach (JointIndex joint in JointPicking.All(Skeleton))
            {
                Assert.That(TryPick(Pixel(joint), 5f, out JointIndex found), joint.ToString());
                Assert.That(found, Is.EqualTo(joint));
            }
        }

        [Test]
        public void NearestJoint_IsTheOneThatIsSeenNearest()
        {
            var random = new System.Random(22);
            for (int trial = 0; trial < 30; trial++)
            {
                var pixel = new Vector2(-100f + 800f * (float)random.NextDouble(), -300f + 500f * (float)random.NextDouble());

                Assert.That(TryPick(pixel, 1e6f, out JointIndex found), pixel.ToString());

                float least = JointPicking.All(Skeleton).Min(joint => Vector2.Distance(Pixel(joint), pixel));
                Assert.That(Vector2.Distance(Pixel(found), pixel), Is.LessThan(least + 2.01f), pixel.ToString());
            }
        }

        [Test]
        public void BeyondTheRadius_NothingIsFound()
        {
            var tip = new JointIndex(0, 4);

            Assert.That(TryPick(Pixel(tip) + new Vector2(20f, 0f), 19f, out _), Is.False);
            Assert.That(TryPick(Pixel(tip) + new Vector2(20f, 0f), 21f, out _), Is.True);
        }

        [Test]
        public void OfJointsInOnePlace_TheNearerOneIsFound()
        {
            Skeleton.Chains[3].joints[3] = Skeleton.GetJoint(1, 2) + new Vector3(0f, 0.5f, 0f);
            Assert.That(TryPick(Pixel(new JointIndex(1, 2)), 5f, out JointIndex above));
            Assert.That(above, Is.EqualTo(new JointIndex(3, 3)));

            Skeleton.Chains[3].joints[3] = Skeleton.GetJoint(1, 2) - new Vector3(0f, 0.5f, 0f);
            Assert.That(TryPick(Pixel(new JointIndex(1, 2)), 5f, out JointIndex below));
            Assert.That(below, Is.EqualTo(new JointIndex(1, 2)));
        }

        // Joints within two pixels of one another lie in one place, and the nearer hides the farther.
        [TestCase(1.9f, true)]
        [TestCase(2.1f, false)]
        public void OfTwoJointsThatAreSeenApart_TheNearerHidesTheOther_WithinTwoPixels(float apart, bool hides)
        {
            foreach ((JointIndex far, JointIndex near) in new[]
            {
                (new JointIndex(1, 1), new JointIndex(3, 2)), (new JointIndex(3, 2), new JointIndex(1, 1)),
            })
            {
                Vector3 Project(Vector3 world) => world == Skeleton.GetJoint(far.chain, far.joint) ? new Vector3(0f, 0f, 5f)
                    : world == Skeleton.GetJoint(near.chain, near.joint) ? new Vector3(apart, 0f, 1f)
                    : new Vector3(0f, 0f, -1f);
                Assert.That(JointPicking.TryNearest(Editing, Project, Vector2.zero, 12f, out JointIndex found, out float distance),
                    Is.True);
                Assert.That((found, distance), Is.EqualTo((hides ? near : far, hides ? apart : 0f)));
                Assert.That(JointPicking.TryNearest(Editing, Project, new Vector2(-12f, 0f), 12f, out found, out _), Is.True);
                Assert.That(found, Is.EqualTo(far), "at the rim of the radius");
                Assert.That(JointPicking.TryNearest(Editing, Project, new Vector2(-12.1f, 0f), 12f, out _, out _), Is.False);
            }
        }

        [Test]
        public void JointsBehindTheEye_AreNotFound()
        {
            Skeleton.Chains[2].joints[2] = new Vector3(0.2f, 5f, 0.4f);

            Assert.That(TryPick(Pixel(new JointIndex(2, 2)), 5f, out _), Is.False);
            Assert.That(JointPicking.Inside(Editing, s_View.Project, Everywhere), Has.None.EqualTo(new JointIndex(2, 2)));
        }

        [Test]
        public void Rays_FindJointsByAngle()
        {
            Vector3 eye = new Vector3(0.3f, 1f, 0.1f), sight = Skeleton.GetJoint(2, 3) - eye;

            Assert.That(JointPicking.TryNearest(Editing, new Ray(eye, Quaternion.Euler(0.3f, 0f, 0f) * sight), 1f, out JointIndex found));
            Assert.That(found, Is.EqualTo(new JointIndex(2, 3)));
            Assert.That(JointPicking.TryNearest(Editing, new Ray(eye, Vector3.up), 1f, out _), Is.False);
        }

        [Test]
        public void PlacedWings_ArePickedWhereTheyAre()
        {
            Editing.LocalToWorld = Matrix4x4.TRS(new Vector3(0.3f, -0.5f, 0.2f), Quaternion.Euler(10f, 40f, 5f), new Vector3(-2f, 2f, 2f));

            foreach (JointIndex joint in JointPicking.All(Skeleton))
            {
                Assert.That(TryPick(Pixel(joint), 5f, out JointIndex found));
                Assert.That(found, Is.EqualTo(joint));
            }
        }

        [Test]
        public void Boxes_HoldTheJointsSeenInThem()
        {
            var box = new Rect(100f, -150f, 250f, 200f);

            JointIndex[] expected = JointPicking.All(Skeleton).Where(joint => box.Contains(Pixel(joint))).ToArray();

            Assert.That(expected.Length, Is.InRange(3, 20));
            Assert.That(JointPicking.Inside(Editing, s_View.Project, box), Is.EqualTo(expected));
            Assert.That(JointPicking.Inside(Editing, s_View.Project, Everywhere), Has.Count.EqualTo(25));
        }

        private static Rect Everywhere => new Rect(-1e6f, -1e6f, 2e6f, 2e6f);

        private bool TryPick(Vector2 pixel, float radius, out JointIndex found) =>
            JointPicking.TryNearest(Editing, s_View.Project, pixel, radius, out found, out _);

        private Vector2 Pixel(JointIndex joint) =>
            s_View.Project(Editing.LocalToWorld.MultiplyPoint3x4(Skeleton.GetJoint(joint.chain, joint.joint)));
    }
}
