using System;
using Alate.Catalogue;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Alate.Editor
{
    /// <summary>
    /// Saves an insect into the user's project: a prefab that beats on the spot, one that flies about, and beside them
    /// their meshes, skeletons, presets of all variants, materials, pictures and trims. Existing assets stay unchanged, so that the user's
    /// changes are kept.
    /// </summary>
    internal sealed class InsectAssets : InsectKeeper
    {
        private readonly string m_Folder;

        /// <param name="folder">Below Assets; made where it is not there.</param>
        /// <exception cref="ArgumentException">The folder is not in Assets.</exception>
        public InsectAssets(string folder)
        {
            string problem = AssetFolder.FindProblem(folder);
            if (problem != null)
                throw new ArgumentException(problem, nameof(folder));
            m_Folder = folder;
        }

        /// <summary>Path of a prefab of a species.</summary>
        /// <param name="species">The insect.</param>
        /// <param name="flies">Whether it flies about, or beats on the spot.</param>
        public string PrefabPath(InsectDefinition species, bool flies = false) =>
            $"{m_Folder}/{(flies ? "Flying " : "")}{species.DisplayName}.prefab";

        /// <summary>Finds a prefab, or saves new ones of both kinds where there are none.</summary>
        /// <exception cref="ArgumentException">The species does not fly.</exception>
        public GameObject FindOrSave(InsectDefinition species, bool flies = false)
        {
            if (flies && !CatalogueFlight.Flies(species))
                throw new ArgumentException($"The {species.DisplayName} does not fly.", nameof(flies));
            GameObject existing = Find(species, flies);
            if (existing != null)
                return existing;
            Save(species);
            return Find(species, flies);
        }

        private GameObject Find(InsectDefinition species, bool flies) =>
            AssetDatabase.LoadAssetAtPath<GameObject>(PrefabPath(species, flies));

        private void Save(InsectDefinition species)
        {
            AssetFolder.Ensure(m_Folder);
            Keep(species);
            AssetDatabase.SaveAssets();
        }

        protected override void KeepPrefab(GameObject made, InsectDefinition species, bool flies)
        {
            string path = PrefabPath(species, flies);
            if (AssetDatabase.LoadAssetAtPath<GameObject>(path) == null)
            {
                made.SetActive(true);
                PrefabUtility.SaveAsPrefabAsset(made, path);
            }

            Object.DestroyImmediate(made);
        }

        protected override Material KeepMaterial(Material made, string key)
        {
            var painted = (Texture2D)made.SurfaceTexture();
            string name = made.name;
            Material kept = Keep(made, key);
            if (painted == null)
                return kept;
            if (ReferenceEquals(kept, made))
            {
                kept.SetSurfaceTexture(PictureAsset.Save(painted, $"{m_Folder}/{name}.png"));
                EditorUtility.SetDirty(kept);
            }

            Object.DestroyImmediate(painted);
            return kept;
        }

        // The asset of this name that is there, or this object as a new one.
        protected override T Keep<T>(T made, string key)
        {
            string path = $"{m_Folder}/{made.name}{(made is Material ? ".mat" : ".asset")}";
            T existing = AssetDatabase.LoadAssetAtPath<T>(path);
            if (existing == null)
            {
                AssetDatabase.CreateAsset(made, path);
                return made;
            }

            Object.DestroyImmediate(made);
            return existing;
        }
    }
}
