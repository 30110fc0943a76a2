using System.Collections;
using System.Collections.Generic;
using Alate.Catalogue;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Alate.Tests.Play
{
    public sealed class FactoryTests : PlayFixture
    {
        private static IEnumerable<string> Names => InsectCatalogue.Names;

        [UnityTest]
        public IEnumerator EverySpecies_ComesReady_WithAllItsWingsBeating([ValueSource(nameof(Names))] string name)
        {
            InsectDefinition species = InsectCatalogue.Find(name);
            InsectWings insect = Made(name);
            yield return Frames(2);
            Assert.That(insect.State, Is.EqualTo(InsectState.Ready), insect.Problem.Message);
            Assert.That(insect.Wings, Has.Count.EqualTo(2 * species.Wings.Count));

            Vector3[][] before = Tips(insect);
            yield return Frames(4);
            Vector3[][] after = Tips(insect);
            for (int wing = 0; wing < before.Length; wing++)
            {
                float moved = (after[wing][0] - before[wing][0]).magnitude;
                Assert.That(moved, Is.GreaterThan(1e-3f * BoundsSize(insect)), $"wing {wing} of the {name} is still");
            }
        }

        [UnityTest]
        public IEnumerator LeftAndRightWing_AreMirrorImages([Values("monarch", "fishfly")] string name) => AssertMirrored(name);

        [UnityTest]
        [Explicit]
        [Category("Long")]
        public IEnumerator LeftAndRightWing_OfAnyOtherSpecies_AreMirrorImages(
            [Values("swallowtail", "firefly", "painted-lichen-moth", "snailfish")] string name) => AssertMirrored(name);

        [Test]
        public void ForeWings_ComeFirst_AndHindWingsBehindThem_WithAPresetOfTheirOwn()
        {
            InsectWings insect = Made("dragonfly");
            Assert.That(insect.Wings.ConvertAll(wing => (wing.Pair, wing.Side)), Is.EqualTo(new[]
            {
                (WingPair.Fore, WingSide.Right), (WingPair.Fore, WingSide.Left),
                (WingPair.Hind, WingSide.Right), (WingPair.Hind, WingSide.Left),
            }));
            Assert.That(
                insect.Wings.ConvertAll(wing => wing.Preset == null), Is.EqualTo(new[] { true, true, false, false }), "the insect's");
        }

        [UnityTest]
        public IEnumerator InsectsOfTheUsersOwn_ShareAmongThemselvesAlone_WhateverTheirName()
        {
            InsectDefinition firefly = InsectCatalogue.Find("firefly");
            InsectDefinition Own() => new InsectDefinition("firefly", "Own", firefly.Wings, firefly.Body, firefly.Sources);
            InsectDefinition own = Own();
            InsectWings one = Made(own), two = Made(own), other = Made(Own()), known = Made("firefly");
            yield return Frames(2);

            Assert.That(one.State, Is.EqualTo(InsectState.Ready), one.Problem.Message);
            Assert.That(two.Wings[0].Skeleton, Is.SameAs(one.Wings[0].Skeleton));
            Assert.That(other.Wings[0].Skeleton, Is.Not.SameAs(one.Wings[0].Skeleton));
            Assert.That(known.Wings[0].Skeleton, Is.Not.SameAs(one.Wings[0].Skeleton));
            Assert.That(GeneratedAssets.InUse, Has.Count.EqualTo(3));
            Object.Destroy(one.gameObject);
            Object.Destroy(other.gameObject);
            yield return Frames(2);
            Assert.That(GeneratedAssets.InUse, Has.Count.EqualTo(2));
            InsectWings clone = Keep(Object.Instantiate(two.gameObject)).GetComponent<InsectWings>();
            Object.Destroy(two.gameObject);
            yield return Frames(2);
            Assert.That(clone.State, Is.EqualTo(InsectState.Ready), "its parts are still there");
            Assert.That(GeneratedAssets.InUse, Has.Count.EqualTo(2));
        }

        [UnityTest]
        public IEnumerator InsectsOfOneSpecies_ShareEverythingButTheirLivingMeshes()
        {
            InsectWings one = Made("swallowtail"), two = Made("swallowtail");
            Assert.That(GeneratedAssets.InUse, Has.Count.EqualTo(1));
            for (int wing = 0; wing < one.Wings.Count; wing++)
            {
                Assert.That(two.Wings[wing].Skeleton, Is.SameAs(one.Wings[wing].Skeleton));
                Assert.That(two.Wings[wing].Preset, Is.SameAs(one.Wings[wing].Preset));
                Assert.That(two.Wings[wing].Renderer.sharedMaterial, Is.SameAs(one.Wings[wing].Renderer.sharedMaterial));
            }

            Assert.That(BodyOf(two), Is.SameAs(BodyOf(one)));
            yield return Frames(2);
            Assert.That(Shown(two, 0), Is.Not.SameAs(Shown(one, 0)));
            two.enabled = one.enabled = false;
            Assert.That(Shown(two, 0), Is.SameAs(Shown(one, 0)));
        }

        [UnityTest]
        public IEnumerator WithTheLastInsect_AllThatItWasMadeOfGoes()
        {
            int before = Count();
            InsectWings one = Made("fishfly"), two = Made("fishfly"), other = Made("monarch");
            yield return Frames(3);
            Assert.That(Count(), Is.GreaterThan(before));

            Object.Destroy(one.gameObject);
            Object.Destroy(other.gameObject);
            yield return Frames(2);
            Assert.That(two.State, Is.EqualTo(InsectState.Ready));
            Assert.That(BodyOf(two) != null, Is.True, "the body's mesh went with the first of two");
            Object.Destroy(two.gameObject);
            yield return Frames(2);
            Assert.That(Count(), Is.EqualTo(before));
        }

        [UnityTest]
        public IEnumerator AClone_LivesOn_WhenTheOriginalIsGone()
        {
            InsectWings original = Made("monarch");
            yield return Frames(2);
            InsectWings clone = Keep(Object.Instantiate(original.gameObject)).GetComponent<InsectWings>();
            Object.Destroy(original.gameObject);
            yield return Frames(3);

            Assert.That(clone.State, Is.EqualTo(InsectState.Ready), clone.Problem.Message);
            Assert.That(clone.Frequency, Is.GreaterThan(0f));
        }

        [UnityTest]
        public IEnumerator APooledInsect_KeepsWhatItIsMadeOf()
        {
            InsectWings insect = Made("monarch");
            yield return Frames(2);
            insect.gameObject.SetActive(false);
            yield return Frames(2);
            insect.gameObject.SetActive(true);
            yield return Frames(2);
            Assert.That(insect.State, Is.EqualTo(InsectState.Ready), insect.Problem.Message);
        }

        [UnityTest]
        public IEnumerator ThePartsOfAnInsect_AreNeverSaved()
        {
            InsectWings insect = Made("firefly");
            yield return null;
            foreach (Object part
                in new Object[] { BodyOf(insect), insect.Preset, insect.Wings[0].Skeleton, insect.Wings[0].Renderer.sharedMaterial })
            {
                Assert.That(part.hideFlags, Is.EqualTo(HideFlags.HideAndDontSave), part.name);
            }
        }

        [UnityTest]
        public IEnumerator VariantAndPreset_AreThoseAskedFor()
        {
            InsectWings soft = Made("painted-lichen-moth", InsectVariant.Expressive);
            InsectWings printed = Made("painted-lichen-moth", InsectVariant.Standard, ModelReading.Paper);
            yield return null;
            Assert.That(soft.Preset.Stiffness.elasticity, Is.LessThan(printed.Preset.Stiffness.elasticity));
            Assert.That(printed.Preset.Wave.chordDelay, Is.EqualTo(1f));
            Assert.That(BodyOf(printed), Is.SameAs(BodyOf(soft)), "variants differ in their presets alone");
        }

        [Test]
        public void WhatIsNotInTheCatalogue_IsRefusedByName_AndNothingIsLeft()
        {
            int before = Count();
            Assert.That(() => InsectFactory.Create("dragon"), Throws.ArgumentException.With.Message.Contains("dragon").And.Message
                .Contains("monarch"));
            Assert.That(() => InsectFactory.Create("monarch", InsectVariant.Biological),
                Throws.ArgumentException.With.Message.Contains("Biological").And.Message.Contains("Standard"));
            Assert.That(() => InsectFactory.Create((InsectDefinition)null), Throws.ArgumentNullException);
            Assert.That(Count(), Is.EqualTo(before));
        }

        private IEnumerator AssertMirrored(string name)
        {
            InsectWings insect = Made(name);
            yield return Frames(7);

            Vector3[][] tips = Tips(insect);
            for (int wing = 0; wing < tips.Length; wing += 2)
            {
                Assert.That(insect.Wings[wing].Side, Is.EqualTo(WingSide.Right));
                Assert.That(insect.Wings[wing + 1].Side, Is.EqualTo(WingSide.Left));
                for (int chain = 0; chain < tips[wing].Length; chain++)
                {
                    Assert.That(tips[wing][chain].x, Is.GreaterThan(0f), "the right wing is on the left");
                    var mirrored = Vector3.Scale(tips[wing + 1][chain], new Vector3(-1f, 1f, 1f));
                    Assert.That((mirrored - tips[wing][chain]).magnitude, Is.LessThan(1e-3f * BoundsSize(insect)));
                }
            }
        }

        private InsectWings Made(
            string name, InsectVariant variant = InsectVariant.Standard, ModelReading reading = ModelReading.Physical) =>
            Kept(InsectFactory.Create(name, variant, reading));

        private InsectWings Made(InsectDefinition own) => Kept(InsectFactory.Create(own));

        private InsectWings Kept(InsectWings insect)
        {
            Keep(insect.gameObject);
            insect.Quality.culling = WingCulling.AlwaysSimulate;
            return insect;
        }

        // Where the ends of all chains are, wing by wing.
        private static Vector3[][] Tips(InsectWings insect)
        {
            var tips = new Vector3[insect.Wings.Count][];
            for (int wing = 0; wing < tips.Length; wing++)
            {
                WingSkeleton skeleton = insect.Wings[wing].Skeleton;
                tips[wing] = new Vector3[skeleton.Chains.Length];
                for (int chain = 0; chain < tips[wing].Length; chain++)
                    tips[wing][chain] = insect.JointPosition(wing, chain, skeleton.JointsPerChain - 1);
            }

            return tips;
        }

        private static float BoundsSize(InsectWings insect) => insect.BoundsOf(0).size.magnitude;

        private static Mesh BodyOf(InsectWings insect) => insect.transform.Find("Body").GetComponent<MeshFilter>().sharedMesh;

        private static int Count() =>
            Resources.FindObjectsOfTypeAll<Mesh>().Length + Resources.FindObjectsOfTypeAll<Material>().Length
            + Resources.FindObjectsOfTypeAll<Texture2D>().Length
            + Resources.FindObjectsOfTypeAll<WingSkeleton>().Length + Resources.FindObjectsOfTypeAll<WingPreset>().Length;
    }
}
