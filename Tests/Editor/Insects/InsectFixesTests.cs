using System.Linq;
using NUnit.Framework;

namespace Alate.Editor.Tests
{
    /// <summary>Buttons for each state.</summary>
    public sealed class InsectFixesTests : InsectFixture
    {
        [TestCase(InsectState.NoWings, "Find Wings")]
        [TestCase(InsectState.SkinnedWings, "Convert Skinned Wings…")]
        [TestCase(InsectState.NoRenderer, "Remove Wing")]
        [TestCase(InsectState.NoMesh, "Remove Wing")]
        [TestCase(InsectState.MeshNotReadable, "Make Mesh Readable")]
        [TestCase(InsectState.StaticBatch, "Turn Off Batching Static")]
        [TestCase(InsectState.SkeletonInvalid, "Open Skeleton", "Lay Out Skeleton…")]
        [TestCase(InsectState.SkeletonDoesNotFit, "Lay Out Skeleton…", "Open Skeleton")]
        public void State_HasItsFixes(InsectState state, params string[] labels)
        {
            Assert.That(LabelsFor(Insect(), state), Is.EqualTo(labels));
        }

        [TestCase(InsectState.Inactive)]
        [TestCase(InsectState.Waiting)]
        [TestCase(InsectState.Ready)]
        [TestCase(InsectState.NoSuchPart)]
        [TestCase(InsectState.NoSkeleton)]
        [TestCase(InsectState.ZeroScale)]
        public void State_ThatOnlyTheUserCanMend_HasNone(InsectState state)
        {
            Assert.That(LabelsFor(Insect(), state), Is.Empty);
        }

        [Test]
        public void OverlappingWings_CanBeRemoved_OnlyWhereTheyAreTheSame()
        {
            InsectWings insect = Insect();
            Assert.That(LabelsFor(insect, InsectState.WingsOverlap), Is.Empty);

            insect.Wings[1].Renderer = insect.Wings[0].Renderer;

            Assert.That(LabelsFor(insect, InsectState.WingsOverlap), Is.EqualTo(new[] { "Remove Wing" }));
        }

        [Test]
        public void EveryFix_SaysWhatItDoes()
        {
            InsectWings insect = Insect();
            foreach (InsectState state in System.Enum.GetValues(typeof(InsectState)))
            {
                foreach (InsectFix fix in InsectFixes.For(insect, new InsectProblem(state, 1, "problem")))
                    Assert.That(fix.Tooltip, Does.EndWith(".").And.Length.GreaterThan(30), fix.Label);
            }
        }

        private static string[] LabelsFor(InsectWings insect, InsectState state) =>
            InsectFixes.For(insect, new InsectProblem(state, 1, "problem")).Select(fix => fix.Label).ToArray();
    }
}
