using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor.Tests
{
    public sealed class InsectStatusTests : InsectFixture
    {
        [Test]
        public void GoodInsect_HasNothingToSay()
        {
            Assert.That(InsectStatus.Of(Insect()).IsShown, Is.False);
        }

        [Test]
        public void FirstProblem_IsShownWithItsRemedy()
        {
            InsectWings insect = Insect();
            insect.Wings[1].Renderer = null;

            var status = InsectStatus.Of(insect);

            Assert.That(status.Kind, Is.EqualTo(MessageType.Error));
            Assert.That(status.Problem.State, Is.EqualTo(InsectState.NoRenderer));
            Assert.That(status.Message, Is.EqualTo(insect.FindProblem().Message));
        }

        [Test]
        public void BatchingStatic_IsFoundBeforePlayBegins()
        {
            InsectWings insect = Insect();
            GameObjectUtility.SetStaticEditorFlags(
                insect.Wings[1].Renderer.gameObject, StaticEditorFlags.BatchingStatic | StaticEditorFlags.OccludeeStatic);

            var status = InsectStatus.Of(insect);

            Assert.That(status.Problem.State, Is.EqualTo(InsectState.StaticBatch));
            Assert.That(status.Problem.Wing, Is.EqualTo(1));
            Assert.That(status.Message, Does.Contain("wing Left").And.Contain("Batching Static"));
        }

        [Test]
        public void OtherStaticFlags_AreNoProblem()
        {
            InsectWings insect = Insect();
            GameObjectUtility.SetStaticEditorFlags(
                insect.Wings[0].Renderer.gameObject, StaticEditorFlags.OccludeeStatic | StaticEditorFlags.ContributeGI);

            Assert.That(InsectStatus.Of(insect).IsShown, Is.False);
        }

        [Test]
        public void SeveralInsects_ShowTheFirstProblem_AndCountTheOthers()
        {
            InsectWings good = Insect(), broken = Insect(), empty = Insect();
            broken.Wings[0].Renderer = null;
            empty.Wings[0].Renderer = null;

            var one = InsectStatus.Of(new[] { good, broken });
            var two = InsectStatus.Of(new[] { good, broken, empty });

            Assert.That(one.Insect, Is.SameAs(broken));
            Assert.That(one.Message, Is.EqualTo(broken.FindProblem().Message));
            Assert.That(two.Message, Does.StartWith(one.Message).And.EndsWith("One more of the selected insects has a problem."));
        }

        [Test]
        public void DestroyedInsects_AreLeftOut()
        {
            InsectWings gone = Insect(), good = Insect();
            Object.DestroyImmediate(gone.gameObject);

            Assert.That(InsectStatus.Of(new[] { gone, good }).IsShown, Is.False);
        }
    }
}
