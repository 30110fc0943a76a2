using NUnit.Framework;

namespace Alate.Editor.Tests
{
    public sealed class LayOutActTests : EditingFixture
    {
        [Test]
        public void LaidOutSkeleton_IsThatOfAWingWithoutOne_OrItsRefusalIsTold()
        {
            Skeleton.Chains = null;
            WingSkeleton expected = null;
            string refusal = null;
            try
            {
                expected = Keep(AutomaticSkeleton.Fit(Surface(), WingSide.Right));
                expected.name = Skeleton.name;
            }
            catch (System.ArgumentException refused)
            {
                refusal = refused.Message;
            }

            EditOutcome outcome = Do("Lay Out Anew");

            Assert.That(outcome.Message, Is.EqualTo(refusal));
            if (expected == null)
                return;
            Assert.That(SkeletonText.Of(Skeleton), Is.EqualTo(SkeletonText.Of(expected)));
            Assert.That(Skeleton.Validate(), Is.Empty);
            Undo.Undo();
            Assert.That(Skeleton.ChainCount, Is.Zero);
        }

        [Test]
        public void LayingOut_NeedsAMesh()
        {
            Editing.Surface = null;

            Assert.That(Do("Lay Out Anew").Message, Is.EqualTo("There is no mesh to lay the skeleton out on."));
        }
    }
}
