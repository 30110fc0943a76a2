using System.Collections;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>A clone of a living insect is an insect of its own, of the meshes that were authored.</summary>
    public sealed class CloneTests : FlockFixture
    {
        [UnityTest]
        public IEnumerator AClone_LivesOnItsOwn_AndGivesTheAuthoredMeshBack()
        {
            InsectWings original = Hatch();
            yield return Frames(10);

            InsectWings clone = Clone(original);
            yield return Frames(3);

            Assert.That(clone.State, Is.EqualTo(InsectState.Ready));
            Assert.That(Shown(clone, 0), Is.Not.SameAs(Shown(original, 0)));
            Assert.That(Shown(clone, 0), Is.Not.SameAs(WingMesh));
            Assert.That(clone.Wings[0].Renderer.transform.parent, Is.SameAs(clone.transform));
            clone.enabled = false;
            Assert.That(Shown(clone, 0), Is.SameAs(WingMesh));
            Assert.That(original.State, Is.EqualTo(InsectState.Ready));
        }

        [UnityTest]
        public IEnumerator AClone_OutlivesItsOriginal([Values(0, 1, 5)] int framesLater)
        {
            InsectWings original = Hatch();
            yield return Frames(10);

            InsectWings clone = Clone(original);
            yield return Frames(framesLater);
            Object.DestroyImmediate(original.gameObject);
            yield return Frames(3);

            Assert.That(clone.State, Is.EqualTo(InsectState.Ready));
            clone.enabled = false;
            Assert.That(Shown(clone, 0), Is.SameAs(WingMesh));
        }

        [UnityTest]
        public IEnumerator AnInactiveCloneOfALivingInsect_AwakesWhenTheOriginalIsLongGone()
        {
            InsectWings original = Hatch();
            yield return Frames(10);
            GameObject shelter = Keep(new GameObject("shelter"));
            shelter.SetActive(false);

            InsectWings clone = Object.Instantiate(original, shelter.transform);
            Object.Destroy(original.gameObject);
            yield return Frames(5);
            clone.transform.SetParent(null);
            Keep(clone.gameObject);
            yield return Frames(3);

            Assert.That(clone.State, Is.EqualTo(InsectState.Ready));
            clone.enabled = false;
            Assert.That(Shown(clone, 0), Is.SameAs(WingMesh));
        }

        [UnityTest]
        public IEnumerator ACloneSwitchedOffAtOnce_ShowsTheAuthoredMesh()
        {
            InsectWings original = Hatch();
            yield return Frames(10);

            InsectWings clone = Clone(original);
            clone.enabled = false;

            Assert.That(Shown(clone, 0), Is.SameAs(WingMesh));
            Object.Destroy(original.gameObject);
            yield return Frames(3);
            Assert.That(Shown(clone, 0), Is.SameAs(WingMesh));
        }

        [UnityTest]
        public IEnumerator ClonesOfClones_ShareOneTemplate()
        {
            InsectWings last = Hatch();
            for (int generation = 0; generation < 5; generation++)
            {
                yield return Frames(2);
                InsectWings next = Clone(last);
                if (generation % 2 == 1)
                    Object.Destroy(last.gameObject);
                last = next;
            }

            yield return Frames(3);
            Assert.That(last.State, Is.EqualTo(InsectState.Ready));
            Assert.That(
                last.Live.meshes[0].template, Is.SameAs(last.Live.meshes[1].template), "one mesh and skeleton, and yet two templates");
            Assert.That(last.Live.meshes[0].template.Source, Is.SameAs(WingMesh));
        }

        [UnityTest]
        public IEnumerator ACloneOfABrokenInsect_IsBrokenByItself_AndMendedByItself()
        {
            InsectWings original = Hatch(made => made.Wings[1].Renderer = null);
            yield return Frames(2);
            InsectWings clone = Clone(original);
            yield return Frames(2);
            Assert.That(clone.State, Is.EqualTo(InsectState.NoRenderer));

            clone.Wings.RemoveAt(1);
            yield return Frames(2);
            Assert.That(clone.State, Is.EqualTo(InsectState.Ready));
            Assert.That(original.State, Is.EqualTo(InsectState.NoRenderer));
        }

        [UnityTest]
        public IEnumerator AClone_ListensToItsOwnRigidbody()
        {
            InsectWings original = Hatch(made => made.Motion.source = VelocitySource.Rigidbody);
            Rigidbody first = Carrier(original, new Vector3(0f, 0f, 3f)), second;
            yield return Frames(10);
            Assert.That(original.Live.flight.velocity.z, Is.EqualTo(3f).Within(0.1f));

            InsectWings clone = Clone(original);
            second = Carrier(clone, new Vector3(0f, 0f, 7f));
            yield return Frames(10);

            Assert.That(original.Live.flight.velocity.z, Is.EqualTo(3f).Within(0.1f));
            Assert.That(clone.Live.flight.velocity.z, Is.EqualTo(7f).Within(0.1f));
            Assert.That(first, Is.Not.SameAs(second));
        }

        private Rigidbody Carrier(InsectWings insect, Vector3 velocity)
        {
            Rigidbody body = Keep(new GameObject("carrier")).AddComponent<Rigidbody>();
            body.useGravity = false;
            insect.transform.SetParent(body.transform, false);
            body.AddForce(velocity, ForceMode.VelocityChange);
            return body;
        }

        private InsectWings Clone(InsectWings original)
        {
            InsectWings clone = Object.Instantiate(original);
            Keep(clone.gameObject);
            return clone;
        }
    }
}
