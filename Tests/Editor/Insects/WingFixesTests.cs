using System.Linq;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor.Tests
{
    /// <summary>Changes by the fixes of the list of wings, and their undo.</summary>
    public sealed class WingFixesTests : InsectFixture
    {
        [Test]
        public void FindWings_FillsAnEmptyList_AndUndoEmptiesIt()
        {
            InsectWings insect = Without(Bare());

            FixOutcome outcome = Apply(new FindWingsFix(), insect);

            Assert.That(outcome.IsDone, Is.True);
            Assert.That(insect.Wings.Select(wing => wing.Side), Is.EqualTo(new[] { WingSide.Right, WingSide.Left }));
            Assert.That(InsectStatus.Of(insect).IsShown, Is.False);

            Undo.PerformUndo();
            Assert.That(insect.Wings, Is.Empty);
        }

        [Test]
        public void FindWings_KeepsSettings_AndDropsBrokenEntries()
        {
            InsectWings insect = Insect();
            insect.Wings[1].AmplitudeScale = 0.5f;
            WingSkeleton skeleton = insect.Wings[1].Skeleton;
            insect.Wings.Insert(0, new Wing());

            Apply(new FindWingsFix(), insect);

            Assert.That(insect.Wings, Has.Count.EqualTo(2));
            Wing left = insect.Wings.Single(wing => wing.Side == WingSide.Left);
            Assert.That(left.AmplitudeScale, Is.EqualTo(0.5f));
            Assert.That(left.Skeleton, Is.SameAs(skeleton));
        }

        [Test]
        public void FindWings_WhereThereIsNothing_SaysWhy_AndChangesNothing()
        {
            InsectWings insect = Without(Keep(new GameObject("stone")));

            FixOutcome outcome = Apply(new FindWingsFix(), insect);

            Assert.That(outcome.IsDone, Is.False);
            Assert.That(outcome.Message, Does.Contain("stone").And.Contain("MeshRenderer"));
            Assert.That(insect.Wings, Is.Empty);
        }

        [Test]
        public void RemoveWing_TakesTheBrokenOneOff_AndUndoBringsItBack()
        {
            InsectWings insect = Insect();
            insect.Wings[0].Renderer = null;
            MeshRenderer left = insect.Wings[1].Renderer;

            FixOutcome outcome = new RemoveWingFix().Apply(insect, insect.FindProblem());

            Assert.That(outcome.IsDone, Is.True);
            Assert.That(insect.Wings.Single().Renderer, Is.SameAs(left));

            Undo.PerformUndo();
            Assert.That(insect.Wings, Has.Count.EqualTo(2));
            Assert.That(insect.Wings[0].Renderer == null, Is.True);
        }

        [Test]
        public void RemoveWing_ThatIsNotThereAnyMore_IsRefused()
        {
            InsectWings insect = Insect();

            FixOutcome outcome = new RemoveWingFix().Apply(insect, new InsectProblem(InsectState.NoMesh, 7, ""));

            Assert.That(outcome.IsDone, Is.False);
            Assert.That(outcome.Message, Does.Contain("7"));
            Assert.That(insect.Wings, Has.Count.EqualTo(2));
        }

        [Test]
        public void StaticBatching_IsTurnedOffOnAllWings_OtherFlagsStay_AndUndoTurnsItOn()
        {
            InsectWings insect = Insect();
            StaticEditorFlags flags = StaticEditorFlags.BatchingStatic | StaticEditorFlags.OccludeeStatic;
            foreach (Wing wing in insect.Wings)
                GameObjectUtility.SetStaticEditorFlags(wing.Renderer.gameObject, flags);

            FixOutcome outcome = Apply(new StaticBatchingFix(), insect);

            Assert.That(outcome.IsDone, Is.True);
            foreach (Wing wing in insect.Wings)
                Assert.That(GameObjectUtility.GetStaticEditorFlags(wing.Renderer.gameObject), Is.EqualTo(StaticEditorFlags.OccludeeStatic));

            Undo.PerformUndo();
            foreach (Wing wing in insect.Wings)
                Assert.That(GameObjectUtility.GetStaticEditorFlags(wing.Renderer.gameObject), Is.EqualTo(flags));
        }

        [Test]
        public void StaticBatching_WithoutTheFlag_NamesTheOtherCause()
        {
            FixOutcome outcome = Apply(new StaticBatchingFix(), Insect());

            Assert.That(outcome.IsDone, Is.False);
            Assert.That(outcome.Message, Does.Contain("StaticBatchingUtility"));
        }

        [Test]
        public void OpenSkeleton_SelectsIt()
        {
            InsectWings insect = Insect();
            Selection.activeObject = insect.gameObject;

            new OpenSkeletonFix().Apply(insect, new InsectProblem(InsectState.SkeletonInvalid, 1, ""));

            Assert.That(Selection.activeObject, Is.SameAs(insect.Wings[1].Skeleton));
        }

        [Test]
        public void OpenSkeleton_WithoutOne_IsNotOffered()
        {
            InsectWings insect = Insect();
            insect.Wings[0].Skeleton = null;

            Assert.That(new OpenSkeletonFix().FindObstacle(insect, new InsectProblem(InsectState.SkeletonInvalid, 0, "")), Is.Not.Null);
            Assert.That(new OpenSkeletonFix().FindObstacle(insect, new InsectProblem(InsectState.SkeletonInvalid, 1, "")), Is.Null);
            foreach (int wing in new[] { -1, 2, 7 })
            {
                var problem = new InsectProblem(InsectState.SkeletonInvalid, wing, "");
                Assert.That(new OpenSkeletonFix().FindObstacle(insect, problem), Is.EqualTo("The wing has no skeleton."), $"wing {wing}");
                Assert.That(new OpenSkeletonFix().Apply(insect, problem).IsDone, Is.False, $"wing {wing}");
            }

            insect.Wings[1] = null;
            Assert.That(new OpenSkeletonFix().FindObstacle(insect, new InsectProblem(InsectState.SkeletonInvalid, 1, "")), Is.Not.Null);
        }

        private static FixOutcome Apply(InsectFix fix, InsectWings insect) => fix.Apply(insect, InsectProblem.None);
    }
}
