using Alate.Authoring;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    public sealed class ImportCommandTests : EditingFixture
    {
        [Test]
        public void ExportedSkeleton_IsImportedToTheSameNumbers_AndUndone()
        {
            string text = SkeletonJson.Write(Skeleton), before = SkeletonText.Of(Left);
            SkeletonEditing editing = Edit(Left);
            editing.Start(out EditStart start);

            Assert.That(editing.Commit("Import", start, ImportCommand.Make(text)).Done);

            Left.name = Skeleton.name;
            Assert.That(SkeletonText.Of(Left), Is.EqualTo(SkeletonText.Of(Skeleton)));
            Undo.Undo();
            Left.name = "Left Wing";
            Assert.That(SkeletonText.Of(Left), Is.EqualTo(before));
        }

        [TestCase("", "expected")]
        [TestCase("{\"version\": 1", "expected")]
        [TestCase("{\"version\": 99}", "version")]
        public void BrokenTexts_AreRefusedInOneLine(string json, string says)
        {
            string refusal = ImportCommand.Make(json).Refusal;

            Assert.That(refusal, Does.Contain(says));
            Assert.That(refusal, Does.Not.Contain("\n"));
        }

        [Test]
        public void TooManyChains_AreRefused()
        {
            WingSkeleton skeleton = Keep(ScriptableObject.CreateInstance<WingSkeleton>());
            skeleton.Chains = new JointChain[17];
            for (int i = 0; i < 17; i++)
                skeleton.Chains[i] = new JointChain(new Vector3(0f, 0f, -i), new Vector3(1f, 0f, -i), new Vector3(2f, 0f, -i));
            Editing.Start(out EditStart start);

            EditOutcome outcome = Editing.Commit("Import", start, ImportCommand.Make(SkeletonJson.Write(skeleton)));

            Assert.That(outcome.Message, Is.EqualTo("A wing has 3 to 16 chains, not 17."));
        }
    }
}
