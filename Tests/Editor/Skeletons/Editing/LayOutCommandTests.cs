using System;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    public sealed class LayOutCommandTests : EditingFixture
    {
        [Test]
        public void EmptySkeleton_GetsOneThatFits_AndUndoEmptiesItAgain()
        {
            Skeleton.Chains = null;

            Assert.That(Do("Lay Out Again").Done);

            Assert.That(Skeleton.Validate(), Is.Empty);
            Assert.That(RigInspection.TryMake(Skeleton, Surface(), 0, out _).Misfit, Is.Null);
            Undo.Undo();
            Assert.That(Skeleton.ChainCount, Is.Zero);
        }

        [Test]
        public void Counts_StayWhatTheyAre()
        {
            Editing.Do("Set Counts", (draft, selected) => ResampleCommands.ToCounts(draft, 7, 4));

            Assert.That(Do("Lay Out Again").Done);

            Assert.That(Skeleton.ChainCount, Is.EqualTo(7));
            Assert.That(Skeleton.JointsPerChain, Is.EqualTo(4));
        }

        [Test]
        public void LayingOut_NeedsAMesh_ThatIsAWing()
        {
            Editing.Surface = null;
            Assert.That(Do("Lay Out Again").Message, Is.EqualTo("There is no mesh to lay the skeleton out on."));

            Editing.Surface = new SnapSurface(
                new SurfaceMesh { name = "dot", positions = new[] { Vector3.zero }, triangles = new[] { 0, 0, 0 } });
            string before = SkeletonText.Of(Skeleton);
            EditOutcome outcome = Do("Lay Out Again");
            Assert.That(outcome.Message, Does.Contain("dot"));
            Assert.That(outcome.Message.Split(new[] { Environment.NewLine }, StringSplitOptions.None), Has.Length.EqualTo(1));
            Assert.That(SkeletonText.Of(Skeleton), Is.EqualTo(before));
        }
    }
}
