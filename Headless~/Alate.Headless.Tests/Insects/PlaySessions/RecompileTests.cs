using System.Collections;
using System.Linq;
using Alate.Catalogue;
using NUnit.Framework;
using Unity.StandIns;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.PlaySessions
{
    /// <summary>Scripts that are compiled again during play: static fields are lost, objects stay.</summary>
    public sealed class RecompileTests
    {
        [TearDown]
        public void LeavePlay()
        {
            if (PlayerLoop.IsPlaying)
                PlayerLoop.ExitPlayMode();
        }

        [UnityTest]
        public IEnumerator AnInsectFromBefore_DoesNotFree_WhatANewOneUses()
        {
            yield return new EnterPlayMode(false);
            int before = Count();
            InsectWings old = InsectFactory.Create("monarch");
            yield return null;
            DomainReload.Run();
            InsectWings young = InsectFactory.Create("monarch");
            yield return null;

            Assert.That(BodyOf(young), Is.SameAs(BodyOf(old)), "the parts were made twice");
            Object.Destroy(old.gameObject);
            yield return null;
            yield return null;
            Assert.That(BodyOf(young) != null, Is.True, "the body's mesh went with the old insect");
            Assert.That(young.Preset != null, Is.True, "the preset went with the old insect");
            Assert.That(young.State, Is.EqualTo(InsectState.Ready), young.Problem.Message);

            Object.Destroy(young.gameObject);
            yield return null;
            yield return null;
            Assert.That(GeneratedAssets.InUse, Is.Empty);
            Assert.That(Count(), Is.EqualTo(before));
            yield return new ExitPlayMode();
        }

        [UnityTest]
        public IEnumerator WithTheLastInsectFromBefore_AllThatItWasMadeOfGoes()
        {
            yield return new EnterPlayMode(false);
            int before = Count();
            InsectWings one = InsectFactory.Create("fishfly"), two = InsectFactory.Create("fishfly", InsectVariant.Expressive);
            yield return null;
            DomainReload.Run();
            yield return null;
            Assert.That(one.State, Is.EqualTo(InsectState.Ready), one.Problem.Message);

            Object.Destroy(one.gameObject);
            yield return null;
            yield return null;
            Assert.That(BodyOf(two) != null, Is.True, "the body's mesh went with the first of two");
            Object.Destroy(two.gameObject);
            yield return null;
            yield return null;
            Assert.That(Count(), Is.EqualTo(before));
            yield return new ExitPlayMode();
        }

        private static Mesh BodyOf(InsectWings insect) => insect.transform.Find("Body").GetComponent<MeshFilter>().sharedMesh;

        // Living meshes come and go with the frames.
        private static int Count() =>
            Resources.FindObjectsOfTypeAll<Mesh>().Count(mesh => !mesh.name.Contains("(living)"))
            + Resources.FindObjectsOfTypeAll<Material>().Length
            + Resources.FindObjectsOfTypeAll<Texture2D>().Length + Resources.FindObjectsOfTypeAll<WingSkeleton>().Length
            + Resources.FindObjectsOfTypeAll<ScriptableObject>().Length;
    }
}
