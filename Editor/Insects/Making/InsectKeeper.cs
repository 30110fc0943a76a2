using System;
using System.Collections.Generic;
using Alate.Catalogue;
using Alate.Flight;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Alate.Editor
{
    /// <summary>
    /// Makes the parts of an insect and its prefabs: one that beats on the spot and, where it flies, one that flies about. Where they are
    /// kept is for those who derive to say.
    /// </summary>
    internal abstract class InsectKeeper
    {
        /// <summary>Makes and keeps an insect.</summary>
        /// <exception cref="InvalidOperationException">No shader was found.</exception>
        protected void Keep(InsectDefinition species)
        {
            var parts = InsectParts.Make(species, keepPixels: true);
            parts.BodyMesh = Keep(parts.BodyMesh, "body mesh");
            if (parts.AbdomenMesh != null)
                parts.AbdomenMesh = Keep(parts.AbdomenMesh, "abdomen mesh");
            parts.BodyMaterial = KeepMaterial(parts.BodyMaterial, "body material");
            foreach (GeneratedWing wing in parts.Wings)
            {
                string name = wing.kind.Name;
                wing.mesh = Keep(wing.mesh, name + " mesh");
                wing.skeleton = Keep(wing.skeleton, name + " skeleton");
                wing.material = KeepMaterial(wing.material, name + " material");
            }

            // The presets that no prefab has lie beside them, to be dragged into the field Preset.
            var presets = new Dictionary<InsectVariant, WingPreset[]>();
            foreach (InsectVariant variant in species.Variants)
                presets.Add(variant, KeepPresets(parts, variant));
            KeepPrefab(parts.Assemble(presets[InsectVariant.Standard]), species, flies: false);
            if (!CatalogueFlight.Flies(species))
                return;
            GameObject flying = parts.Assemble(presets[InsectVariant.Flight]);
            CatalogueFlight.AddTo(flying.GetComponent<InsectWings>(), species, Keep(CatalogueFlight.CreateTrims(species), "flight trims"));
            flying.AddComponent<WanderPilot>().StayAroundStart();
            KeepPrefab(flying, species, flies: true);
        }

        /// <summary>Keeps a part.</summary>
        /// <param name="made">New; nobody else's.</param>
        /// <param name="key">Name that stays where that of the insect changes.</param>
        /// <returns>What is kept in its place.</returns>
        protected abstract T Keep<T>(T made, string key) where T : Object;

        /// <summary>Keeps a material and its picture, which can be read.</summary>
        /// <inheritdoc cref="Keep{T}(T, string)"/>
        protected abstract Material KeepMaterial(Material made, string key);

        /// <summary>Keeps an insect of the parts that were kept.</summary>
        /// <param name="made">Inactive; nobody else's.</param>
        /// <param name="species">The insect.</param>
        /// <param name="flies">Whether it flies about.</param>
        protected abstract void KeepPrefab(GameObject made, InsectDefinition species, bool flies);

        private WingPreset[] KeepPresets(InsectParts parts, InsectVariant variant)
        {
            WingPreset[] made = parts.CreatePresets(variant, ModelReading.Physical);
            for (int k = 0; k < made.Length; k++)
                made[k] = Keep(made[k], $"{parts.Wings[k].kind.Name} preset {variant.ToString().ToLowerInvariant()}");
            return made;
        }
    }
}
