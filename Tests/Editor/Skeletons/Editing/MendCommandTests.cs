using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    public sealed class MendCommandTests : EditingFixture
    {
        [Test]
        public void UnequalChains_GetTheCountOfMost_AndTheOthersKeepTheirJoints()
        {
            Vector3[] kept = Skeleton.Chains[3].joints;
            Skeleton.Chains[1].joints = Skeleton.Chains[1].joints.Take(3).ToArray();
            Assert.That(Kinds(), Does.Contain(SkeletonProblemKind.UnequalJointCounts));

            Assert.That(Do("Mend").Done);

            Assert.That(Skeleton.Validate(), Is.Empty);
            Assert.That(Skeleton.JointsPerChain, Is.EqualTo(5));
            Assert.That(Skeleton.Chains[3].joints, Is.EqualTo(kept));
        }

        [Test]
        public void CountOfMost_IsTaken_ThoughTheFirstChainHasAnother()
        {
            Skeleton.Chains[0].joints = Skeleton.Chains[0].joints.Take(3).ToArray();

            Assert.That(Do("Mend").Done);

            Assert.That(Skeleton.JointsPerChain, Is.EqualTo(5));
        }

        [Test]
        public void BrokenJoints_AreLaidOutAnew()
        {
            Skeleton.Chains[2].joints[3] = new Vector3(float.NaN, 0f, 0f);
            Skeleton.Hinge = Vector3.positiveInfinity;

            Assert.That(Do("Mend").Done);

            Assert.That(Skeleton.Validate(), Is.Empty);
            Assert.That(Skeleton.Hinge, Is.EqualTo(Skeleton.GetJoint(0, 0)));
        }

        [Test]
        public void ParallelAxes_AreFitted()
        {
            Skeleton.UpAxis = Skeleton.SpanAxis;

            Assert.That(Do("Mend").Done);

            Assert.That(Skeleton.Validate(), Is.Empty);
            Assert.That(Vector3.Angle(Skeleton.UpAxis, Vector3.up), Is.LessThan(0.1f));
        }

        [TestCase(2)]
        [TestCase(20)]
        public void ChainCountsOutOfRange_AreBroughtIntoIt(int chains)
        {
            SkeletonDraft.Read(Skeleton, out SkeletonDraft draft);
            var many = new JointChain[chains];
            for (int i = 0; i < chains; i++)
            {
                float place = 4f * i / (chains - 1);
                int before = Mathf.Min((int)place, 3);
                Vector3[] joints = Enumerable.Range(0, 5)
                    .Select(j => Vector3.Lerp(draft[before, j], draft[before + 1, j], place - before)).ToArray();
                many[i] = new JointChain(joints);
            }

            Skeleton.Chains = many;

            Assert.That(Do("Mend").Done);

            Assert.That(Skeleton.Validate(), Is.Empty);
            Assert.That(Skeleton.ChainCount, Is.EqualTo(Mathf.Clamp(chains, 3, 16)));
        }

        [Test]
        public void EmptySkeleton_IsRefused_AndStaysEmpty()
        {
            Skeleton.Chains = null;

            Assert.That(Do("Mend").Message, Is.EqualTo("Fewer than two chains have two usable joints; that is too little to mend."));
            Assert.That(Do("Smooth").Message, Is.EqualTo("The skeleton has no chains yet."));
            Assert.That(Skeleton.ChainCount, Is.Zero);
        }

        [Test]
        public void OtherCommands_AskToMendFirst()
        {
            Skeleton.Chains[1].joints = null;

            Assert.That(Do("Straighten").Message, Is.EqualTo("The chains have not the same number of joints: mend the skeleton first."));
        }

        [Test]
        public void Mending_IsUndone_ToTheBrokenSkeleton()
        {
            Skeleton.Chains[1].joints = Skeleton.Chains[1].joints.Take(4).ToArray();
            Skeleton.Chains[2].joints[1].x = float.NaN;
            string broken = SkeletonText.Of(Skeleton);
            Do("Mend");

            Undo.Undo();

            Assert.That(SkeletonText.Of(Skeleton), Is.EqualTo(broken));
        }

        private SkeletonProblemKind[] Kinds() => Skeleton.Validate().Select(problem => problem.Kind).ToArray();
    }
}
