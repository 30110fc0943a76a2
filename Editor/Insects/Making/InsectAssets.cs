using System;
using Alate.Catalogue;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Alate.Editor
{
    /// <summary>
    /// Saves an insect of the catalogue into the user's project: a prefab, and beside it its meshes, skeletons, presets of all variants,
    /// materials and pictures. Existing assets stay unchanged, so that the user's changes are kept.
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

        /// <summary>Path of the prefab of a species.</summary>
        public string PrefabPath(InsectDefinition species) => $"{m_Folder}/{species.DisplayName}.prefab";

        /// <summary>Finds the prefab, or saves a new one.</summary>
        public GameObject FindOrSave(InsectDefinition species)
        {
            GameObject existing = AssetDatabase.LoadAssetAtPath<GameObject>(PrefabPath(species));
            return existing != null ? existing : Save(species);
        }

        private GameObject Save(InsectDefinition species)
        {
            AssetFolder.Ensure(m_Folder);
            var kit = InsectParts.Make(species, keepPixels: true);
            kit.BodyMesh = Keep(kit.BodyMesh);
            kit.BodyMaterial = Keep(kit.BodyMaterial);
            foreach (GeneratedWing wing in kit.Wings)
            {
                wing.mesh = Keep(wing.mesh);
                wing.skeleton = Keep(wing.skeleton);
                wing.material = Keep(wing.material);
            }

            GameObject root = kit.Assemble(KeepPresets(kit, species));
            root.SetActive(true);
            GameObject prefab = PrefabUtility.SaveAsPrefabAsset(root, PrefabPath(species));
            Object.DestroyImmediate(root);
            AssetDatabase.SaveAssets();
            return prefab;
        }

        // Those of the standard variant; the others lie beside them, to be dragged into the field Preset.
        private WingPreset[] KeepPresets(InsectParts kit, InsectDefinition species)
        {
            WingPreset[] standard = null;
            foreach (InsectVariant variant in species.Variants)
            {
                WingPreset[] kept = Array.ConvertAll(kit.CreatePresets(variant, ModelReading.Physical), Keep);
                standard = standard ?? kept;
            }

            return standard;
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
