using UnityEngine.Scripting.APIUpdating;

namespace Alate.Catalogue
{
    /// <summary>
    /// Set of numbers that a preset takes from a species. The reading of the paper's equations is chosen separately, by <see
    /// cref="ModelReading"/>.
    /// </summary>
    [MovedFrom(true, "Alate", "Alate", "SpeciesVariant")]
    public enum InsectVariant
    {
        /// <summary>
        /// Numbers of the paper's Tables 1 and 2 where they have the species, and similar numbers where they do not. Every species has this
        /// variant.
        /// </summary>
        Standard,

        /// <summary>Beat as measured on real animals, where measurements exist.</summary>
        Biological,

        /// <summary>
        /// Softer wing with a larger lag, chosen by eye: tips cup and membranes flutter, and the surface still stretches by less than 8 %.
        /// </summary>
        Expressive,

        /// <summary>
        /// Numbers with which the wings carry the insect: masses, lengths and frequencies of real animals where those of the paper do not
        /// fly.
        /// </summary>
        Flight,
    }
}
