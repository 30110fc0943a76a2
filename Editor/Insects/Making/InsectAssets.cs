using System;
using System.Linq;
using Alate.Catalogue;
using Alate.Flight;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Alate.Editor
{
    /// <summary>
    /// Saves an insect of the catalogue into the user's project: a prefab that beats on the spot, one that flies about, and beside them
    /// their meshes, skeletons, presets of all variants, materials, pictures and trims. Existing assets stay unchanged, so that the user's
    /// changes are kept.
    /// </summary>
    internal sealed class InsectAssets
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
            var parts = InsectParts.Make(species, keepPixels: true);
            parts.BodyMesh = Keep(parts.BodyMesh);
            parts.BodyMaterial = Keep(parts.BodyMaterial);
            foreach (GeneratedWing wing in parts.Wings)
            {
                wing.mesh = Keep(wing.mesh);
                wing.skeleton = Keep(wing.skeleton);
                wing.material = Keep(wing.material);
            }

            // The presets that no prefab has lie beside them, to be dragged into the field Preset.
            var presets = species.Variants.ToDictionary(
                variant => variant, variant => Array.ConvertAll(parts.CreatePresets(variant, ModelReading.Physical), Keep));
            SavePrefab(parts.Assemble(presets[InsectVariant.Standard]), PrefabPath(species));
            if (CatalogueFlight.Flies(species))
            {
                GameObject flying = parts.Assemble(presets[InsectVariant.Flight]);
                CatalogueFlight.AddTo(flying.GetComponent<InsectWings>(), species, Keep(CatalogueFlight.CreateTrims(species)));
                flying.AddComponent<WanderPilot>().StayAroundStart();
                SavePrefab(flying, PrefabPath(species, true));
            }

            AssetDatabase.SaveAssets();
        }

        private static void SavePrefab(GameObject made, string path)
        {
            if (AssetDatabase.LoadAssetAtPath<GameObject>(path) == null)
            {
                made.SetActive(true);
                PrefabUtility.SaveAsPrefabAsset(made, path);
            }

            Object.DestroyImmediate(made);
        }

        private Material Keep(Material made)
        {
            var painted = (Texture2D)made.SurfaceTexture();
            string name = made.name;
            Material kept = Keep<Material>(made);
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
        private T Keep<T>(T made) where T : Object
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
