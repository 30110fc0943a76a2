using UnityEngine.Scripting.APIUpdating;

namespace Alate.Catalogue
{
    /// <summary>
    /// Which numbers of a species a preset takes. Whether the equations are read as printed or as resolved is another choice, <see cref="ModelReading"/>.
    /// </summary>
    [MovedFrom(true, "Alate", "Alate", "SpeciesVariant")]
    public enum InsectVariant
    {
        /// <summary>The paper's Tables 1 and 2 where they have the species, and numbers of that kind where they do not. Every species has it.</summary>
        Standard,

        /// <summary>The beat as it was measured on real animals, where it was.</summary>
        Biological,

        /// <summary>Softer and with a larger lag, for the eye: tips cup and membranes flutter, and the surface still stretches by less than 8 %.</summary>
        Expressive,
    }
}
