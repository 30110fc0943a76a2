using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    public sealed class RowCommandsTests : EditingFixture
    {
        [Test]
        public void AddedRow_LiesInTheMiddleOfTheBonesBeyond_InEveryChain()
        {
            Vector3[] inner = Skeleton.Chains.Select(chain => chain.joints[2]).ToArray();
            Vector3[] outer = Skeleton.Chains.Select(chain => chain.joints[3]).ToArray();
            Select((4, 2));

            Assert.That(Do("Add Joint Row").Done);

            for (int i = 0; i < 5; i++)
            {
                Assert.That(Skeleton.Chains[i].Length, Is.EqualTo(6));
                Assert.That(Vector3.Distance(Skeleton.GetJoint(i, 3), 0.5f * (inner[i] + outer[i])), Is.LessThan(1e-6f));
                Assert.That(Skeleton.GetJoint(i, 4), Is.EqualTo(outer[i]));
            }

            Assert.That(Editing.Selection.Living(), Is.EqualTo(Enumerable.Range(0, 5).Select(i => new JointIndex(i, 3))));
            Assert.That(Skeleton.Validate(), Is.Empty);
        }

        [Test]
        public void RowAddedAtTheTips_LiesBeforeThem()
        {
            Vector3 tip = Skeleton.GetJoint(2, 4);
            Select((2, 4));

            Assert.That(Do("Add Joint Row").Done);

            Assert.That(Skeleton.GetJoint(2, 5), Is.EqualTo(tip));
        }

        [Test]
        public void RemovedRow_IsGoneFromEveryChain()
        {
            Vector3[][] old = Skeleton.Chains.Select(chain => chain.joints).ToArray();
            Select((1, 3), (4, 1));

            Assert.That(Do("Remove Joint Row").Done);

            for (int i = 0; i < 5; i++)
                Assert.That(Skeleton.Chains[i].joints, Is.EqualTo(new[] { old[i][0], old[i][2], old[i][4] }));
        }

        [Test]
        public void RowAddedAndRemoved_LeavesTheSameSkeleton()
        {
            string before = SkeletonText.Of(Skeleton);
            Select((0, 1));
            Do("Add Joint Row");

            Assert.That(Do("Remove Joint Row").Done);

            Assert.That(SkeletonText.Of(Skeleton), Is.EqualTo(before));
        }

        [Test]
        public void Roots_AreNotRemoved()
        {
            Select((3, 0));

            Assert.That(Do("Remove Joint Row").Message, Is.EqualTo("The roots cannot be removed; select joints farther out."));
        }

        [Test]
        public void ThirdJoint_IsNotRemoved()
        {
            Select((0, 1), (0, 2), (0, 3));

            Assert.That(Do("Remove Joint Row").Message, Is.EqualTo("2 joints would be left in a chain; it needs at least 3."));
        }

        [Test]
        public void SeventeenthJoint_IsRefused()
        {
            Editing.Do("Fill", (draft, selected) => ResampleCommands.ToCounts(draft, 5, 16));
            Select((0, 4));

            Assert.That(Do("Add Joint Row").Message, Is.EqualTo("There would be 17 joints in a chain; it has at most 16."));
            Assert.That(Skeleton.JointsPerChain, Is.EqualTo(16));
        }

        [TestCase("Add Joint Row")]
        [TestCase("Remove Joint Row")]
        public void NothingSelected_IsRefused(string command) =>
            Assert.That(Do(command).Message, Does.StartWith("Select a joint of the row"));
    }
}
