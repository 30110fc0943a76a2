using System;
using Alate.Catalogue;
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
        /// <exception cref="ArgumentException">There is no such species.</exception>
        public GameObject Place(string species, GameObject parent)
        {
            InsectDefinition definition = InsectCatalogue.Find(species);
            GameObject made = Application.isPlaying ? InsectFactory.Create(definition).gameObject : Instance(definition);
            Undo.RegisterCreatedObjectUndo(made, "Create " + definition.DisplayName);
            ObjectFactory.PlaceGameObject(made, parent);
            Selection.activeGameObject = made;
            return made;
        }

        private GameObject Instance(InsectDefinition species)
        {
            var assets = new InsectAssets($"{m_Home}/{species.DisplayName}");
            GameObject prefab = assets.FindOrSave(species);
            if (!IsOpen(assets.PrefabPath(species)))
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
