using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    public sealed class ShapeCommandsTests : EditingFixture
    {
        [Test]
        public void ASingleChain_IsRepeated_AndOthersSpreadOverTheFan()
        {
            var single = new SkeletonDraft(1, 3);
            single.SetChain(0, new[] { Vector3.zero, Vector3.right, new Vector3(2f, 0f, 1f) });
            SkeletonDraft repeated = ResampleCommands.ToCounts(single, 4, 3).Draft;
            var pair = new SkeletonDraft(2, 3);
            for (int j = 0; j < 3; j++)
                (pair[0, j], pair[1, j]) = (new Vector3(j, 0f, 0f), new Vector3(j, 0f, -3f));
            SkeletonDraft spread = ResampleCommands.ToCounts(pair, 4, 3).Draft;

            for (int i = 0; i < 4; i++)
            {
                Assert.That(repeated.Chain(i), Is.EqualTo(single.Chain(0)));
                for (int j = 0; j < 3; j++)
                    Assert.That((spread[i, j] - new Vector3(j, 0f, -i)).magnitude, Is.LessThan(1e-5f));
            }
        }

        [Test]
        public void EvenlySpacedChain_HasBonesOfOneLength_ItsOldEnds_AndItsOldLine()
        {
            Bend((1, 1), new Vector3(0.01f, 0f, 0.01f));
            var old = new JointPath((Vector3[])Skeleton.Chains[1].joints.Clone());
            Select((1, 3));

            Assert.That(Do("Space Evenly").Done);

            Vector3[] joints = Skeleton.Chains[1].joints;
            for (int j = 0; j < 5; j++)
                Assert.That(Vector3.Distance(joints[j], old.At(old.Length * j / 4f)), Is.LessThan(1e-6f));
            Assert.That(joints[0], Is.EqualTo(old.At(0f)));
        }

        [Test]
        public void EvenSpacing_DoesTheSelectedChains_OrAll()
        {
            Editing.Do(
                "Disturb", (draft, selected) => SlideCommands.By(draft, new[] { new JointIndex(0, 1), new JointIndex(3, 2) }, 0.01f));
            Select((3, 0));
            Do("Space Evenly");

            Assert.That(Unevenness(3), Is.LessThan(1e-5f));
            Assert.That(Unevenness(0), Is.GreaterThan(0.05f));

            Select();
            Do("Space Evenly");
            Assert.That(Enumerable.Range(1, 4).Max(Unevenness), Is.LessThan(1e-5f));
            Assert.That(Unevenness(0), Is.LessThan(0.002f), "bent at its joints, so spaced along its old line");
        }

        [Test]
        public void OtherCounts_KeepTheFan([Values(3, 5, 7, 16)] int chains, [Values(3, 5, 9, 16)] int joints)
        {
            Vector3 hinge = Skeleton.Hinge, tip = Skeleton.GetJoint(0, 4), last = Skeleton.GetJoint(4, 4), root = Skeleton.GetJoint(4, 0);

            Assert.That(Editing.Do("Set Counts", (draft, selected) => ResampleCommands.ToCounts(draft, chains, joints)).Done);

            Assert.That(Skeleton.ChainCount, Is.EqualTo(chains));
            Assert.That(Skeleton.JointsPerChain, Is.EqualTo(joints));
            Assert.That(Skeleton.Hinge, Is.EqualTo(hinge));
            Assert.That(Skeleton.GetJoint(0, joints - 1), Is.EqualTo(tip));
            Assert.That(Skeleton.GetJoint(chains - 1, joints - 1), Is.EqualTo(last));
            Assert.That(Skeleton.GetJoint(chains - 1, 0), Is.EqualTo(root));
            Assert.That(Skeleton.Validate(), Is.Empty);
        }

        [TestCase(2, 5, "A wing has 3 to 16 chains, not 2.")]
        [TestCase(17, 5, "A wing has 3 to 16 chains, not 17.")]
        [TestCase(5, 2, "A chain has 3 to 16 joints, not 2.")]
        [TestCase(5, 17, "A chain has 3 to 16 joints, not 17.")]
        public void CountsOutOfRange_AreRefused(int chains, int joints, string why)
        {
            EditOutcome outcome = Editing.Do("Set Counts", (draft, selected) => ResampleCommands.ToCounts(draft, chains, joints));

            Assert.That(outcome.Message, Is.EqualTo(why));
            Assert.That(Skeleton.ChainCount, Is.EqualTo(5));
        }

        [Test]
        public void StraightenedChain_IsALine_BetweenItsOldEnds()
        {
            Bend((1, 2), new Vector3(0f, 0.03f, 0.02f));
            Vector3 root = Skeleton.GetJoint(1, 0), tip = Skeleton.GetJoint(1, 4);
            Select((1, 2));

            Assert.That(Do("Straighten").Done);

            var path = new JointPath(Skeleton.Chains[1].joints);
            Assert.That(path.Length, Is.EqualTo(Vector3.Distance(root, tip)).Within(1e-6f));
            Assert.That(Skeleton.GetJoint(1, 0), Is.EqualTo(root));
            Assert.That(Skeleton.GetJoint(1, 4), Is.EqualTo(tip));
        }

        [Test]
        public void ThreeSelectedJoints_StraightenTheRunBetweenThemOnly()
        {
            Bend((0, 2), new Vector3(0f, 0.03f, 0f));
            Bend((0, 3), new Vector3(0f, 0.01f, 0f));
            Vector3 beyond = Skeleton.GetJoint(0, 3);
            Select((0, 1), (0, 2), (0, 3));

            Do("Straighten");

            Vector3 a = Skeleton.GetJoint(0, 1), b = Skeleton.GetJoint(0, 2), c = Skeleton.GetJoint(0, 3);
            Assert.That(Vector3.Distance(a, b) + Vector3.Distance(b, c), Is.EqualTo(Vector3.Distance(a, c)).Within(1e-6f));
            Assert.That(c, Is.EqualTo(beyond));
        }

        [Test]
        public void WithoutASelection_AllChainsAreStraightened_WithOneOnlyItsOwn()
        {
            for (int chain = 0; chain < 5; chain++)
                Bend((chain, 2), new Vector3(0f, 0.03f, 0.02f));
            float[] shares = Enumerable.Range(0, 5).Select(ShareOfTheSecond).ToArray();
            Select((3, 1));
            Assert.That(Do("Straighten").Done);
            Assert.That(Enumerable.Range(0, 5).Select(IsStraight), Is.EqualTo(new[] { false, false, false, true, false }));

            Select();
            Assert.That(Do("Straighten").Done);
            Assert.That(Enumerable.Range(0, 5).Select(IsStraight), Is.All.True);
            Assert.That(Enumerable.Range(0, 5).Select(ShareOfTheSecond), Is.EqualTo(shares).Within(1e-4f), "the same shares of the way");
        }

        [Test]
        public void WithoutASelection_AllInnerJointsAreSmoothed_HalfWayToThoseAround()
        {
            Bend((2, 2), new Vector3(0.01f, 0.04f, 0f));
            Vector3[][] before = Enumerable.Range(0, 5).Select(chain => (Vector3[])Skeleton.Chains[chain].joints.Clone()).ToArray();
            Select();

            Assert.That(Do("Smooth").Done);

            for (int i = 0; i < 5; i++)
            {
                for (int j = 0; j < 5; j++)
                {
                    Vector3 wanted = before[i][j];
                    if (j % 4 > 0)
                    {
                        Vector3 mean = (before[i][j - 1] + before[i][j + 1]) / 2f;
                        if (i % 4 > 0)
                            mean = (mean + (before[i - 1][j] + before[i + 1][j]) / 2f) / 2f;
                        wanted = (wanted + mean) / 2f;
                    }

                    Assert.That((Skeleton.GetJoint(i, j) - wanted).magnitude, Is.LessThan(1e-6f), $"{i}, {j}");
                }
            }
        }

        [Test]
        public void Smoothing_HalvesASpike_AndLeavesRootsAndTips()
        {
            var spike = new Vector3(0f, 0.04f, 0f);
            Bend((2, 2), spike);
            Select((2, 2));

            Assert.That(Do("Smooth").Done);
            Assert.That(Skeleton.GetJoint(2, 2).y, Is.EqualTo(0.02f).Within(1e-6f));

            Select((2, 0), (2, 4));
            Assert.That(Do("Smooth").Message, Is.EqualTo("Roots and tips are not smoothed; select joints between them."));
        }

        [Test]
        public void Smoothing_LeavesTheOutermostChainsOnTheirLines([Values(0, 4)] int chain)
        {
            Select((chain, 1), (chain, 2), (chain, 3));
            Do("Straighten");
            Do("Space Evenly");
            Vector3 before = Skeleton.GetJoint(chain, 2);

            Do("Smooth");

            Assert.That(Vector3.Distance(Skeleton.GetJoint(chain, 2), before),
                Is.LessThan(0.05f * Vector3.Distance(before, Skeleton.GetJoint(chain, 1))));
        }

        private float Unevenness(int chain)
        {
            Vector3[] joints = Skeleton.Chains[chain].joints;
            float[] bones = Enumerable.Range(0, 4).Select(j => Vector3.Distance(joints[j], joints[j + 1])).ToArray();
            return bones.Max() / bones.Min() - 1f;
        }

        private bool IsStraight(int chain) =>
            new JointPath(Skeleton.Chains[chain].joints).Length - Vector3.Distance(Skeleton.GetJoint(chain, 0), Skeleton.GetJoint(chain, 4))
            < 1e-6f;

        private float ShareOfTheSecond(int chain)
        {
            var path = new JointPath(Skeleton.Chains[chain].joints);
            return path.DistanceOf(2) / path.Length;
        }

        private void Bend((int chain, int joint) at, Vector3 by) => Skeleton.Chains[at.chain].joints[at.joint] += by;
    }
}
