using System;
using UnityEngine;

namespace Alate
{
    /// <summary>
    /// Makes ready insects of the catalogue by code, without assets: body, wings, materials and a living <see cref="InsectWings"/>. All insects of one kind share
    /// their meshes, skeletons, presets and materials, which are hidden, are never saved, and go with the last of them.
    /// </summary>
    /// <remarks>
    /// To tune one insect alone give it a preset of its own: <c>insect.Species = Object.Instantiate(insect.Species)</c>, and likewise each
    /// <see cref="Wing.Species"/> of hind wings. Clones share as well; of clones that were never active keep the original.
    /// Outside of play nothing is shared: what is made belongs to the scene and is saved in it. The menu <i>GameObject > Alate</i> makes assets instead.
    /// </remarks>
    public static class InsectFactory
    {
        /// <summary>An active insect at the origin, X right, Y up, Z ahead, ten times life size (<see cref="SpeciesDefinition.UnitsPerMetre"/>).</summary>
        /// <param name="species">Its name in the catalogue, see <see cref="Species.Names"/>; capitals, spaces and hyphens do not matter.</param>
        /// <param name="variant">Which numbers of the species are taken.</param>
        /// <param name="preset">How the paper's equations are read.</param>
        /// <exception cref="ArgumentException">There is no such species or variant; the message lists those there are.</exception>
        /// <exception cref="InvalidOperationException">No shader was found; the message says how to put one into the build.</exception>
        public static InsectWings Create(
            string species, SpeciesVariant variant = SpeciesVariant.Standard, ModelPreset preset = ModelPreset.Physical)
        {
            return Create(Species.Find(species), variant, preset);
        }

        /// <inheritdoc cref="Create(string, SpeciesVariant, ModelPreset)"/>
        /// <exception cref="ArgumentNullException">The species is null.</exception>
        public static InsectWings Create(
            SpeciesDefinition species, SpeciesVariant variant = SpeciesVariant.Standard, ModelPreset preset = ModelPreset.Physical)
        {
            if (species == null)
                throw new ArgumentNullException(nameof(species));
            var kind = new InsectKind(species, variant, preset);
            return Application.isPlaying ? Share(kind) : Activated(InsectKit.Make(kind).Assemble());
        }

        private static InsectWings Share(in InsectKind kind)
        {
            GameObject made = InsectKits.Take(kind).Assemble();
            made.AddComponent<GeneratedInsect>().Kind = kind;
            InsectWings insect = Activated(made);
            InsectKits.Return(kind);
            return insect;
        }

        private static InsectWings Activated(GameObject made)
        {
            made.SetActive(true);
            return made.GetComponent<InsectWings>();
        }
    }
}
