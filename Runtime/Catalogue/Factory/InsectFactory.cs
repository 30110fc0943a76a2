using System;
using System.Linq;
using UnityEngine;
using UnityEngine.Scripting.APIUpdating;

namespace Alate.Catalogue
{
    /// <summary>
    /// Makes ready insects of the catalogue by code, without assets: body, wings, materials and a living <see cref="InsectWings"/>. All
    /// insects of one species share their meshes, skeletons and materials, those of one variant also their presets, which are hidden, are
    /// never saved, and go with the last of them.
    /// </summary>
    /// <remarks>
    /// To tune one insect alone give it a preset of its own: <c>insect.Preset = Object.Instantiate(insect.Preset)</c>, and likewise each
    /// <see cref="Wing.Preset"/> of hind wings. Clones share as well; of clones that were never active keep the original.
    /// Outside of play nothing is shared: what is made belongs to the scene and is saved in it. The menu <i>GameObject > Alate</i> makes
    /// assets instead.
    /// </remarks>
    [MovedFrom(true, "Alate", "Alate")]
    public static class InsectFactory
    {
        /// <summary>
        /// An active insect at the origin, X right, Y up, Z ahead, ten times life size (<see cref="InsectDefinition.UnitsPerMetre"/>).
        /// </summary>
        /// <param name="species">Its name in the catalogue, see <see cref="InsectCatalogue.Names"/>; capitals, spaces and hyphens do not
        /// matter.</param>
        /// <param name="variant">Which numbers of the species are taken.</param>
        /// <param name="reading">How the paper's equations are read.</param>
        /// <exception cref="ArgumentException">There is no such species or variant; the message lists those there are.</exception>
        /// <exception cref="InvalidOperationException">No shader was found; the message says how to put one into the build.</exception>
        public static InsectWings Create(
            string species, InsectVariant variant = InsectVariant.Standard, ModelReading reading = ModelReading.Physical) =>
            Create(InsectCatalogue.Find(species), variant, reading);

        /// <inheritdoc cref="Create(string, InsectVariant, ModelReading)"/>
        /// <exception cref="ArgumentNullException">The species is null.</exception>
        public static InsectWings Create(
            InsectDefinition species, InsectVariant variant = InsectVariant.Standard, ModelReading reading = ModelReading.Physical)
        {
            if (species == null)
                throw new ArgumentNullException(nameof(species));
            if (!species.Variants.Contains(variant))
            {
                throw new ArgumentException(
                    $"There is no variant '{variant}' of {species.Name}. It has: {string.Join(", ", species.Variants)}.", nameof(variant));
            }
            if (Application.isPlaying)
                return CreateShared(species, variant, reading);
            var parts = InsectParts.Make(species);
            return Activated(parts.Assemble(parts.CreatePresets(variant, reading)));
        }

        private static InsectWings CreateShared(InsectDefinition species, InsectVariant variant, ModelReading reading)
        {
            SharedAssets assets = GeneratedAssets.Acquire(species);
            GameObject made = assets.Assemble(variant, reading);
            made.AddComponent<GeneratedInsect>().Parts = assets.Key;
            InsectWings insect = Activated(made);
            GeneratedAssets.Return(assets.Key);
            return insect;
        }

        private static InsectWings Activated(GameObject made)
        {
            made.SetActive(true);
            return made.GetComponent<InsectWings>();
        }
    }
}
