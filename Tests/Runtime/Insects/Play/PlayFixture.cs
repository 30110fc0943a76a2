using System.Collections;
using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>Play-mode tests of insects: makes them, and takes everything away afterwards.</summary>
    public abstract class PlayFixture
    {
        private readonly List<Object> m_Made = new List<Object>();
        private readonly List<string> m_Kept = new List<string>();

        /// <summary>
        /// True where the parts of generated insects stay from one test of the class to the next: making them takes longer than most tests
        /// of insects.
        /// </summary>
        protected virtual bool KeepsParts => false;

        /// <summary>Gravity of the scene before the test, which comes back after it.</summary>
        protected Vector3 Gravity { get; private set; }

        [SetUp]
        public void UseFixedFrames()
        {
            Time.timeScale = 1f;
            Time.captureDeltaTime = 1f / 60f;
            WingSystem.DetailCameras.Clear();
            WingSystem.Patience = 0f;
            Gravity = Physics.gravity;
        }

        [OneTimeTearDown]
        public void GiveBackParts()
        {
            foreach (string species in m_Kept)
                GeneratedAssets.Return(species);
            m_Kept.Clear();
        }

        [UnityTearDown]
        public IEnumerator TakeAllAway()
        {
            KeepParts();
            foreach (Object made in m_Made)
            {
                if (made != null)
                    Object.Destroy(made);
            }

            m_Made.Clear();
            Time.timeScale = 1f;
            Time.captureDeltaTime = 0f;
            Physics.gravity = Gravity;
            yield return Frames(3);
            Assert.That(WingSystem.Loop, Is.Null, "the system has outlived its insects");
            Assert.That(LivingMeshes.Count, Is.Zero, "living meshes were left behind");
            Assert.That(
                GeneratedAssets.InUse.Select(assets => (assets.Key, assets.Users)),
                Is.EquivalentTo(m_Kept.Select(species => (species, 1))), "parts of generated insects were left behind");
            Assert.That(Resources.FindObjectsOfTypeAll<Mesh>(), Has.None.Property("name").Contains("(living)"));
            Assert.That(Resources.FindObjectsOfTypeAll<Mesh>(), Has.None.Property("name").Contains("(joints)"));
            Assert.That(SkinMaterials.LivingCount, Is.Zero, "copies of materials were left behind");
        }

        /// <summary>Destroyed at the end of the test.</summary>
        protected T Keep<T>(T made) where T : Object
        {
            m_Made.Add(made);
            return made;
        }

        /// <summary>A monarch of two wings, each with mesh and skeleton of its own, under a root without the component.</summary>
        protected GameObject Bare(float unitsPerMetre = InsectDefinition.UnitsPerMetre)
        {
            WingDefinition kind = InsectCatalogue.Find("monarch").Wings[0];
            GameObject root = Keep(new GameObject("insect"));
            foreach (WingSide side in new[] { WingSide.Right, WingSide.Left })
            {
                var wing = new GameObject("wing " + side);
                wing.transform.SetParent(root.transform, false);
                wing.transform.localPosition = kind.HingeOn(side, unitsPerMetre);
                wing.AddComponent<MeshFilter>().sharedMesh = Keep(Specimens.Mesh(kind, side, unitsPerMetre));
                wing.AddComponent<MeshRenderer>();
            }

            return root;
        }

        /// <summary>Living insect, computed also out of the sight of cameras.</summary>
        protected InsectWings Insect(float unitsPerMetre = InsectDefinition.UnitsPerMetre)
        {
            WingDefinition kind = InsectCatalogue.Find("monarch").Wings[0];
            GameObject root = Bare(unitsPerMetre);
            root.SetActive(false);
            InsectWings insect = root.AddComponent<InsectWings>();
            insect.Wings.Clear();
            foreach (MeshRenderer renderer in root.GetComponentsInChildren<MeshRenderer>(true))
            {
                WingSide side = renderer.name.EndsWith("Left") ? WingSide.Left : WingSide.Right;
                insect.Wings.Add(new Wing { Renderer = renderer, Side = side, Skeleton = Keep(kind.CreateSkeleton(side, unitsPerMetre)) });
            }

            insect.Quality.culling = WingCulling.AlwaysSimulate;
            root.SetActive(true);
            return insect;
        }

        /// <summary>Waits for a number of frames.</summary>
        protected static IEnumerator Frames(int count)
        {
            for (int frame = 0; frame < count; frame++)
                yield return null;
        }

        /// <summary>The mesh that a wing shows.</summary>
        protected static Mesh Shown(InsectWings insect, int wing) => insect.Wings[wing].Renderer.GetComponent<MeshFilter>().sharedMesh;

        /// <summary>[vertex of a wing, as the living mesh has them] The authored mesh's.</summary>
        protected static int[] Order(InsectWings insect, int wing)
        {
            LiveWing live = insect.Live.wings[wing];
            LiveMesh mesh = insect.Live.meshes.Find(shown => shown.wings.Contains(live));
            return mesh.template.Shapes[System.Array.IndexOf(mesh.wings, live)].Selection.vertices;
        }

        /// <summary>Makes the fixture one more user of the parts, so that the last insect of a test does not free them.</summary>
        protected void KeepParts()
        {
            if (!KeepsParts)
                return;
            foreach (string species in GeneratedAssets.InUse.Select(assets => assets.Key).Except(m_Kept).ToList())
            {
                GeneratedAssets.Acquire(species);
                m_Kept.Add(species);
            }
        }
    }
}
