using System;
using Alate.Catalogue;
using Alate.Flight;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Alate.Editor
{
    /// <summary>
    /// Puts a ready insect where Unity's own GameObject menu would, undoable in one step, and selects it. Its parts are first saved into
    /// the user's project, once for all insects of a species: objects kept in the scene alone would be doubled in every scene and prefab,
    /// would be missing from prefabs made of the insect, and no two insects would share the work. Undo removes the insect; the assets stay.
    /// </summary>
    internal sealed class InsectPlacing
    {
        /// <summary>Folder above those of the species.</summary>
        public const string Home = "Assets/Alate";

        private readonly string m_Home;

        /// <param name="home">Of the folders of the species; <see cref="Home"/>.</param>
        public InsectPlacing(string home = Home)
        {
            m_Home = home;
        }

        /// <summary>Makes the insect.</summary>
        /// <param name="species">Its name in the catalogue.</param>
        /// <param name="parent">What was clicked on; null places it in the current stage.</param>
        /// <param name="flies">Whether it flies about, or beats on the spot.</param>
        /// <exception cref="ArgumentException">There is no such species, or it does not fly.</exception>
        public GameObject Place(string species, GameObject parent, bool flies = false)
        {
            InsectDefinition definition = InsectCatalogue.Find(species);
            GameObject made = Application.isPlaying ? Create(definition, flies) : Instance(definition, flies);
            Undo.RegisterCreatedObjectUndo(made, "Create " + made.name);
            ObjectFactory.PlaceGameObject(made, parent);
            Selection.activeGameObject = made;
            return made;
        }

        private static GameObject Create(InsectDefinition species, bool flies)
        {
            if (!flies)
                return InsectFactory.Create(species).gameObject;
            InsectFlight flight = CatalogueFlight.AddTo(InsectFactory.Create(species, InsectVariant.Flight), species);
            flight.gameObject.AddComponent<WanderPilot>().StayAroundStart();
            return flight.gameObject;
        }

        private GameObject Instance(InsectDefinition species, bool flies)
        {
            var assets = new InsectAssets($"{m_Home}/{species.DisplayName}");
            GameObject prefab = assets.FindOrSave(species, flies);
            if (!IsOpen(assets.PrefabPath(species, flies)))
                return (GameObject)PrefabUtility.InstantiatePrefab(prefab);

            // A prefab cannot contain itself: while it is open, a plain copy is put into it.
            GameObject copy = Object.Instantiate(prefab);
            copy.name = prefab.name;
            return copy;
        }

        private static bool IsOpen(string prefab)
        {
            PrefabStage stage = PrefabStageUtility.GetCurrentPrefabStage();
            return stage != null && Array.IndexOf(AssetDatabase.GetDependencies(prefab), stage.assetPath) >= 0;
        }
    }
}
