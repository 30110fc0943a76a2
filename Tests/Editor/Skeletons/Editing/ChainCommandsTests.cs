using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    public sealed class ChainCommandsTests : EditingFixture
    {
        [Test]
        public void ChainAddedBehind_LiesHalfwayToTheNext_AndIsSelected()
        {
            Vector3 before = Skeleton.GetJoint(1, 3), behind = Skeleton.GetJoint(2, 3);
            Select((1, 0));

            Assert.That(Do("Add Chain Behind").Done);

            Assert.That(Skeleton.ChainCount, Is.EqualTo(6));
            Assert.That(Vector3.Distance(Skeleton.GetJoint(2, 3), 0.5f * (before + behind)), Is.LessThan(1e-6f));
            Assert.That(Skeleton.GetJoint(1, 3), Is.EqualTo(before));
            Assert.That(Skeleton.GetJoint(3, 3), Is.EqualTo(behind));
            Assert.That(Editing.Selection.Living(), Is.EqualTo(Enumerable.Range(0, 5).Select(j => new JointIndex(2, j))));
            Assert.That(Skeleton.Validate(), Is.Empty);
        }

        [Test]
        public void ChainAddedBehindTheLast_LiesBeyondIt()
        {
            Vector3 inner = Skeleton.GetJoint(3, 2), last = Skeleton.GetJoint(4, 2);
            Select((4, 1));

            Assert.That(Do("Add Chain Behind").Done);

            Vector3 beyond = Skeleton.GetJoint(5, 2) - last;
            Assert.That(Vector3.Distance(beyond, 0.5f * (last - inner)), Is.LessThan(1e-6f));
        }

        [Test]
        public void ChainAddedBeforeTheFirst_BecomesThePrincipalChain_AndTheHingeGoesWithTheFirstRoot()
        {
            JointChain old = Skeleton.Chains[0];
            Select((0, 2));

            Assert.That(Do("Add Chain Before").Done);

            Assert.That(Skeleton.Chains[1].joints, Is.EqualTo(old.joints));
            Assert.That(Skeleton.Hinge, Is.EqualTo(Skeleton.GetJoint(0, 0)));
        }

        [Test]
        public void MeasuredStiffness_StaysWithItsChain()
        {
            Skeleton.Chains[1].flexuralStiffness = new[] { 1e-6f };
            Select((0, 1));
            Assert.That(Do("Add Chain Before").Done);
            Assert.That(Measured(), Is.EqualTo("..1..."));
            Assert.That(Do("Remove Chain").Done);
            Assert.That(Measured(), Is.EqualTo(".1..."));
            Select((2, 1));
            Assert.That(Do("Add Joint Row").Done);
            Assert.That(Do("Reverse Chains").Done);
            Assert.That(Measured(), Is.EqualTo("...1."));
        }

        private string Measured() =>
            string.Concat(Skeleton.Chains.Select(chain => ChainValues.AreGiven(chain.flexuralStiffness) ? "1" : "."));

        [Test]
        public void ChainAddedBetween_IsTheSame_FromEitherSide()
        {
            Select((1, 0));
            Do("Add Chain Behind");
            string behind = SkeletonText.Of(Skeleton);
            Undo.Undo();
            Select((2, 4));
            Do("Add Chain Before");

            Assert.That(SkeletonText.Of(Skeleton), Is.EqualTo(behind));
        }

        [Test]
        public void SeveralChains_AreAddedAtOnce()
        {
            Select((0, 0), (0, 3), (2, 1), (4, 4));

            Assert.That(Do("Add Chain Behind").Done);

            Assert.That(Skeleton.ChainCount, Is.EqualTo(8));
            Assert.That(Editing.Selection.Living().Select(s => s.chain).Distinct(), Is.EqualTo(new[] { 1, 4, 7 }));
        }

        [Test]
        public void RemovedChains_AreGone_AndTheOthersStayAsTheyWere()
        {
            Vector3[] first = Skeleton.Chains[0].joints, third = Skeleton.Chains[2].joints, last = Skeleton.Chains[4].joints;
            Select((1, 2), (3, 0));

            Assert.That(Do("Remove Chain").Done);

            Assert.That(Skeleton.Chains.Select(chain => chain.joints), Is.EqualTo(new[] { first, third, last }));
            Assert.That(Editing.Selection.Living(), Is.Empty);
        }

        [Test]
        public void ThirdLastChain_IsNotRemoved()
        {
            Select((0, 0), (1, 0), (2, 0));
            string before = SkeletonText.Of(Skeleton);

            EditOutcome outcome = Do("Remove Chain");

            Assert.That(outcome.Message, Is.EqualTo("2 chains would be left; a wing needs at least 3."));
            Assert.That(SkeletonText.Of(Skeleton), Is.EqualTo(before));
        }

        [Test]
        public void SeventeenthChain_IsRefused()
        {
            for (int count = 6; count <= WingSkeleton.MaxChains; count++)
            {
                Select((count / 2, 0));
                Assert.That(Do("Add Chain Behind").Done, $"{count} chains");
            }

            Select((3, 0));
            Assert.That(Do("Add Chain Before").Message, Is.EqualTo("There would be 17 chains; a wing has at most 16."));
            Assert.That(Skeleton.ChainCount, Is.EqualTo(16));
        }

        [Test]
        public void ReversedChains_AreInTheOtherOrder_AndTheSelectionGoesWithThem()
        {
            Vector3[][] old = Skeleton.Chains.Select(chain => chain.joints).ToArray();
            Select((0, 3));

            Assert.That(Do("Reverse Chains").Done);

            Assert.That(Skeleton.Chains.Select(chain => chain.joints), Is.EqualTo(old.Reverse()));
            Assert.That(Editing.Selection.Living(), Is.EqualTo(new[] { new JointIndex(4, 3) }));
        }

        [TestCase("Add Chain Behind")]
        [TestCase("Add Chain Before")]
        [TestCase("Remove Chain")]
        public void NothingSelected_IsRefused(string command) =>
            Assert.That(Do(command).Message, Does.StartWith("Select a joint of the chain"));
    }
}
