using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
using Alate.Flight;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor.Tests
{
    /// <summary>The menu GameObject > Alate.</summary>
    public sealed class InsectPlacingTests
    {
        private const string k_Home = "Assets/Alate Test Insects";

        private readonly List<GameObject> m_Made = new List<GameObject>();

        [TearDown]
        public void TakeAllAway()
        {
            foreach (GameObject made in m_Made)
            {
                if (made != null)
                    Object.DestroyImmediate(made);
            }

            m_Made.Clear();
            Selection.activeObject = null;
            AssetDatabase.DeleteAsset(k_Home);
            Undo.ClearAll();
        }

        [TestCase("monarch", Explicit = true, Category = "Long")]
        [TestCase("swallowtail", Explicit = true, Category = "Long")]
        [TestCase("firefly", Explicit = true, Category = "Long")]
        [TestCase("fishfly", Explicit = true, Category = "Long")]
        [TestCase("painted-lichen-moth", Explicit = true, Category = "Long")]
        [TestCase("snailfish")]
        [TestCase("dragonfly", Explicit = true, Category = "Long")]
        public void EverySpecies_IsAnInstanceOfAPrefab_WhosePartsAreAllSaved(string name)
        {
            GameObject insect = Place(name);
            InsectDefinition species = InsectCatalogue.Find(name);
            Assert.That(PrefabUtility.IsPartOfPrefabInstance(insect), Is.True);
            Assert.That(insect.activeSelf, Is.True);
            Assert.That(
                AssetDatabase.LoadAssetAtPath<GameObject>($"{k_Home}/{species.DisplayName}/{species.DisplayName}.prefab") != null, Is.True);

            InsectWings wings = insect.GetComponent<InsectWings>();
            Assert.That(wings.Wings, Has.Count.EqualTo(2 * species.Wings.Count));
            Assert.That(InsectStatus.Of(wings).Problem.IsProblem, Is.False, InsectStatus.Of(wings).Problem.Message);
            foreach (Object part in PartsOf(insect))
                AssertIsSaved(part, name);
            foreach (Wing wing in wings.Wings)
                AssertIsSaved(wing.Skeleton, name);
            AssertIsSaved(wings.Preset, name);
        }

        [Test]
        public void PaintedWings_AreSavedAsPictures()
        {
            GameObject insect = Place("monarch");
            Texture picture = insect.GetComponent<InsectWings>().Wings[0].Renderer.sharedMaterial.mainTexture;
            Assert.That(AssetDatabase.GetAssetPath(picture), Does.EndWith(".png"));
            Assert.That(picture.width, Is.GreaterThan(16));
            Assert.That(picture.wrapMode, Is.EqualTo(TextureWrapMode.Clamp));
        }

        [Test]
        public void TheInsect_LiesUnderItsParent_WithANameOfItsOwn_AndIsSelected()
        {
            var parent = new GameObject("meadow") { layer = 5 };
            m_Made.Add(parent);
            parent.transform.position = new Vector3(1f, 2f, 3f);
            GameObject first = Place("firefly", parent), second = Place("firefly", parent);

            Assert.That(first.transform.parent, Is.SameAs(parent.transform));
            Assert.That(first.transform.localPosition, Is.EqualTo(Vector3.zero));
            Assert.That(first.layer, Is.EqualTo(5));
            Assert.That(second.name, Is.Not.EqualTo(first.name).And.StartsWith("Firefly"));
            Assert.That(Selection.activeGameObject, Is.SameAs(second));
        }

        [Test]
        public void Undo_TakesTheInsectAway_InOneStep_AndTheAssetsStay()
        {
            var before = new GameObject("before");
            m_Made.Add(before);
            GameObject insect = Place("firefly");
            Object part = PartsOf(insect).First();
            Undo.PerformUndo();

            Assert.That(insect == null, Is.True);
            Assert.That(before != null, Is.True);
            Assert.That(part != null, Is.True);
        }

        [Test]
        public void ASecondInsect_IsMadeOfTheSameAssets_AsTheUserLeftThem()
        {
            InsectWings first = Place("firefly").GetComponent<InsectWings>();
            first.Preset.Beat.maxFrequency = 33f;
            InsectWings second = Place("firefly").GetComponent<InsectWings>();

            Assert.That(second.Preset, Is.SameAs(first.Preset));
            Assert.That(second.Preset.Beat.maxFrequency, Is.EqualTo(33f));
            Assert.That(PartsOf(second.gameObject), Is.EqualTo(PartsOf(first.gameObject)));
        }

        [Test]
        public void WithoutThePrefab_WhatIsLeftOfTheAssets_IsUsedAgain()
        {
            WingPreset tuned = Place("firefly").GetComponent<InsectWings>().Preset;
            AssetDatabase.DeleteAsset($"{k_Home}/Firefly/Firefly.prefab");
            Assert.That(Place("firefly").GetComponent<InsectWings>().Preset, Is.SameAs(tuned));
        }

        [Test]
        public void PresetsOfAllVariants_AreSaved()
        {
            Place("firefly");
            foreach (string variant in new[] { "", " Biological", " Expressive", " Flight" })
            {
                string path = $"{k_Home}/Firefly/Firefly Hind Wing Preset{variant}.asset";
                Assert.That(AssetDatabase.LoadAssetAtPath<WingPreset>(path) != null, Is.True, path);
            }
        }

        [TestCase("monarch", Explicit = true, Category = "Long")]
        [TestCase("swallowtail", Explicit = true, Category = "Long")]
        [TestCase("firefly")]
        [TestCase("fishfly", Explicit = true, Category = "Long")]
        [TestCase("painted-lichen-moth", Explicit = true, Category = "Long")]
        [TestCase("snailfish", Explicit = true, Category = "Long")]
        [TestCase("dragonfly", Explicit = true, Category = "Long")]
        public void AFlyingInsect_IsAnInstanceOfItsOwnPrefab_OfTheSameAssets(string name)
        {
            GameObject insect = Place(name, null, true), still = Place(name);
            InsectDefinition species = InsectCatalogue.Find(name);
            Assert.That(PrefabUtility.IsPartOfPrefabInstance(insect), Is.True);
            Assert.That(insect.name, Is.EqualTo("Flying " + species.DisplayName));
            Assert.That(PartsOf(insect), Is.EqualTo(PartsOf(still)));

            InsectFlight flight = insect.GetComponent<InsectFlight>();
            AssertIsSaved(flight.Trims, name);
            Assert.That(flight.Parts, Is.EqualTo(species.FlightParts));
            AssertIsSaved(insect.GetComponent<InsectWings>().Preset, name);
            Assert.That(insect.GetComponent<InsectWings>().Preset, Is.Not.SameAs(still.GetComponent<InsectWings>().Preset));
            Assert.That(insect.GetComponent<WanderPilot>().FromStart, Is.True);
            Assert.That(still.GetComponent<InsectFlight>() == null, Is.True);
        }

        [Test]
        public void AFlyingInsect_IsUndoneInOneStep()
        {
            GameObject insect = Place("firefly", null, true);
            Undo.PerformUndo();
            Assert.That(insect == null, Is.True);
        }

        [Test]
        public void WithTheStillPrefabOfTheUser_TheFlyingOneIsAdded()
        {
            Place("firefly");
            AssetDatabase.DeleteAsset($"{k_Home}/Firefly/Flying Firefly.prefab");
            GameObject still = AssetDatabase.LoadAssetAtPath<GameObject>($"{k_Home}/Firefly/Firefly.prefab");
            Assert.That(Place("firefly", null, true).GetComponent<InsectFlight>() != null, Is.True);
            Assert.That(AssetDatabase.LoadAssetAtPath<GameObject>($"{k_Home}/Firefly/Firefly.prefab"), Is.SameAs(still));
        }

        [Test]
        public void NothingIsSaved_OutsideOfAssets([Values("Packages/com.alate.insect-wings", "Library", "AssetsToo")] string folder)
        {
            Assert.That(
                () => new InsectAssets(folder), Throws.ArgumentException.With.Message.Contains(folder).And.Message.Contains("read-only"));
        }

        [Test]
        public void TheSelectedFolder_IsThatOfTheSelectedAsset_OrAssets()
        {
            GameObject insect = Place("firefly");
            Assert.That(AssetFolder.Of(PartsOf(insect).First()), Is.EqualTo(k_Home + "/Firefly"));
            Assert.That(AssetFolder.Of(insect), Is.EqualTo("Assets"));
            Assert.That(AssetFolder.Of(null), Is.EqualTo("Assets"));
        }

        private GameObject Place(string species, GameObject parent = null, bool flies = false)
        {
            GameObject made = new InsectPlacing(k_Home).Place(species, parent, flies);
            m_Made.Add(made);
            return made;
        }

        private static IEnumerable<Object> PartsOf(GameObject insect)
        {
            foreach (MeshFilter filter in insect.GetComponentsInChildren<MeshFilter>(true))
                yield return filter.sharedMesh;
            foreach (MeshRenderer renderer in insect.GetComponentsInChildren<MeshRenderer>(true))
                yield return renderer.sharedMaterial;
        }

        private static void AssertIsSaved(Object part, string name)
        {
            Assert.That(part != null, Is.True, "a part of the " + name + " is missing");
            Assert.That(AssetDatabase.GetAssetPath(part), Does.StartWith(k_Home + "/"), part.name);
        }
    }
}
