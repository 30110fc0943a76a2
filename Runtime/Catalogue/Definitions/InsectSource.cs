using UnityEngine.Scripting.APIUpdating;

namespace Alate.Catalogue
{
    /// <summary>Source of one number of a species.</summary>
    [MovedFrom(true, "Alate", "Alate", "SpeciesSource")]
    public readonly struct InsectSource
    {
        /// <summary>Notes a number and its source.</summary>
        public InsectSource(string quantity, string value, string source, InsectVariant variant = InsectVariant.Standard)
        {
            Quantity = quantity;
            Value = value;
            Source = source;
            Variant = variant;
        }

        /// <summary>Name of the number, such as "wing length".</summary>
        public string Quantity { get; }

        /// <summary>The number with its unit.</summary>
        public string Value { get; }

        /// <summary>The table, the paper, the measurement, or "assumed" with the reason.</summary>
        public string Source { get; }

        /// <summary>
        /// Variant that has this number; numbers of the standard variant hold for the others too, unless they have their own.
        /// </summary>
        public InsectVariant Variant { get; }

        /// <summary>Quantity, value and source in one line.</summary>
        public override string ToString()
        {
            string variant = Variant == InsectVariant.Standard ? "" : $", {Variant.ToString().ToLowerInvariant()}";
            return $"{Quantity}{variant}: {Value} ({Source})";
        }
    }
}
