using UnityEngine.Scripting.APIUpdating;

namespace Alate.Catalogue
{
    /// <summary>Where one number of a species comes from.</summary>
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

        /// <summary>What the number is, such as "wing length".</summary>
        public string Quantity { get; }

        /// <summary>The number with its unit.</summary>
        public string Value { get; }

        /// <summary>The table, the paper, the measurement, or "assumed" with the reason.</summary>
        public string Source { get; }

        /// <summary>The variant that has this number; what the standard one has goes for the others too, unless they have a number of their own.</summary>
        public InsectVariant Variant { get; }

        /// <summary>All in one line.</summary>
        public override string ToString()
        {
            var variant = Variant == InsectVariant.Standard ? "" : $", {Variant.ToString().ToLowerInvariant()}";
            return $"{Quantity}{variant}: {Value} ({Source})";
        }
    }
}
