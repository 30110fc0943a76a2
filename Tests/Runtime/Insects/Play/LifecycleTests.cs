using System;
using System.Collections;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Alate.Tests.Play
{
    /// <summary>Insects end at any time, by anybody's hand, and nobody else notices.</summary>
    public sealed class LifecycleTests : FlockFixture
    {
        /// <summary>Point of time of an act.</summary>
        public enum Moment
        {
            FixedUpdate,
            AfterTheStep,
            Update,
            LateUpdate,
            AfterTheDrawing,
            AnothersOnDisable,
            AnothersOnDestroy,
        }

        /// <summary>End of an insect.</summary>
        public enum Ending
        {
            Destroy,
            DestroyImmediate,
            DestroyComponent,
            DestroyWing,
            Disable,
            Deactivate,
        }

        [UnityTest]
        public IEnumerator AnEnd_AtAnyMoment_TroublesNobody([Values] Moment moment, [Values] Ending ending)
        {
            InsectWings before = Hatch(), ending1 = Hatch(), ending2 = Hatch(), after = Hatch(), twin = Hatch(Tune);
            MeshFilter filter = Filter(ending1, 0);
            yield return Frames(10);

            Do(moment, () =>
            {
                End(ending1, ending);
                End(ending2, ending);
            });
            yield return Frames(10);

            Assert.That(WingSystem.InsectCount, Is.EqualTo(3));
            if (filter != null)
                Assert.That(filter.sharedMesh, Is.SameAs(WingMesh));
            foreach (InsectWings other in new[] { before, after })
            {
                Assert.That(other.State, Is.EqualTo(InsectState.Ready));
                Assert.That(Farthest(Joints(other, 0), Joints(twin, 0)), Is.LessThan(1e-5f));
            }
        }

        [UnityTest]
        public IEnumerator TheLastEnd_AtAnyMoment_EndsTheSystem([Values] Moment moment, [Values] Ending ending)
        {
            InsectWings insect = Hatch();
            yield return Frames(10);
            Assert.That(WingSystem.Loop, Is.Not.Null);

            Do(moment, () => End(insect, ending));
            yield return Frames(4);

            Assert.That(WingSystem.InsectCount, Is.Zero);
            Assert.That(LivingMeshes.Count, Is.Zero);
            if (ending == Ending.DestroyWing)
                yield break;
            Assert.That(WingSystem.Loop, Is.Null);
            Assert.That(Object.FindAnyObjectByType<WingSystem>(), Is.Null);
        }

        [UnityTest]
        public IEnumerator ABirth_AtAnyMoment_IsABirth([Values] Moment moment)
        {
            InsectWings elder = Hatch(), younger = null;
            yield return Frames(10);

            Do(moment, () => younger = Hatch());
            yield return Frames(4);

            Assert.That(younger.State, Is.EqualTo(InsectState.Ready));
            Assert.That(elder.State, Is.EqualTo(InsectState.Ready));
        }

        [UnityTest]
        public IEnumerator SwitchedOffAndOnAtOnce_ItLives([Values] Moment moment)
        {
            InsectWings insect = Hatch();
            yield return Frames(10);

            Do(moment, () =>
            {
                for (int k = 0; k < 3; k++)
                {
                    insect.enabled = false;
                    Assert.That(Shown(insect, 0), Is.SameAs(WingMesh));
                    Assert.That(insect.State, Is.EqualTo(InsectState.Inactive));
                    insect.enabled = true;
                }
            });
            yield return Frames(4);

            Assert.That(insect.State, Is.EqualTo(InsectState.Ready));
            Assert.That(Shown(insect, 0), Is.Not.SameAs(WingMesh));
            Assert.That(WingSystem.InsectCount, Is.EqualTo(1));
        }

        [UnityTest]
        public IEnumerator BornAndGoneInOneFrame_ItLeavesNothing()
        {
            for (int k = 0; k < 5; k++)
                Object.DestroyImmediate(Hatch().gameObject);
            yield return Frames(4);
            Assert.That(WingSystem.Loop, Is.Null);
            Assert.That(Object.FindAnyObjectByType<WingSystem>(), Is.Null);
        }

        [UnityTest]
        public IEnumerator WhenTheSystemIsDestroyed_InsectsSaySo_AndLiveAgainWhenSwitchedOn()
        {
            InsectWings insect = Hatch(), broken = Hatch(made => made.Wings.Clear());
            yield return Frames(5);

            Object.Destroy(Object.FindAnyObjectByType<WingSystem>().gameObject);
            yield return Frames(3);
            Assert.That(insect.State, Is.EqualTo(InsectState.Inactive));
            Assert.That(broken.State, Is.EqualTo(InsectState.Inactive));
            Assert.That(Shown(insect, 0), Is.SameAs(WingMesh));
            Assert.That(() => insect.Read(0), Throws.InvalidOperationException.With.Message.Contains("Inactive"));

            insect.enabled = false;
            insect.enabled = true;
            yield return Frames(3);
            Assert.That(insect.State, Is.EqualTo(InsectState.Ready));
        }

        [UnityTest]
        public IEnumerator TwoComponentsOnOneObject_AreNotAllowed()
        {
            InsectWings insect = Hatch();
            yield return Frames(2);
            Assert.That(Attribute.IsDefined(typeof(InsectWings), typeof(DisallowMultipleComponent)), Is.True);
            Assert.That(insect.State, Is.EqualTo(InsectState.Ready));
        }

        private static void Tune(InsectWings insect) => insect.StartPhase = 0f;

        private void Do(Moment moment, Action deed)
        {
            GameObject doer = Keep(new GameObject("doer"));
            Deeds deeds = doer.AddComponent<Deeds>();
            LateDeeds late = doer.AddComponent<LateDeeds>();
            switch (moment)
            {
                case Moment.FixedUpdate: deeds.inFixedUpdate = deed; break;
                case Moment.AfterTheStep: late.inFixedUpdate = deed; break;
                case Moment.Update: deeds.inUpdate = deed; break;
                case Moment.LateUpdate: deeds.inLateUpdate = deed; break;
                case Moment.AfterTheDrawing: late.inLateUpdate = deed; break;
                case Moment.AnothersOnDisable:
                    deeds.whenDisabled = deed;
                    deeds.enabled = false;
                    break;
                default:
                    deeds.whenDestroyed = deed;
                    Object.Destroy(doer);
                    break;
            }
        }

        private static void End(InsectWings insect, Ending ending)
        {
            switch (ending)
            {
                case Ending.Destroy: Object.Destroy(insect.gameObject); break;
                case Ending.DestroyImmediate: Object.DestroyImmediate(insect.gameObject); break;
                case Ending.DestroyComponent: Object.Destroy(insect); break;
                case Ending.DestroyWing: Object.Destroy(insect.Wings[0].Renderer.gameObject); break;
                case Ending.Disable: insect.enabled = false; break;
                default: insect.gameObject.SetActive(false); break;
            }
        }
    }
}
