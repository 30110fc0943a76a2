using System;
using UnityEngine;

namespace Alate
{
    /// <summary>Which insect of the catalogue, with which numbers, by which reading of the paper: what generated insects that share everything have in common.</summary>
    [Serializable]
    internal struct InsectKind : IEquatable<InsectKind>
    {
        [SerializeField]
        string m_Species;

        [SerializeField]
        SpeciesVariant m_Variant;

        [SerializeField]
        ModelPreset m_Preset;

        /// <exception cref="ArgumentException">The species has no such variant.</exception>
        public InsectKind(SpeciesDefinition species, SpeciesVariant variant, ModelPreset preset)
        {
            bool isThere = false;
            foreach (SpeciesVariant known in species.Variants)
                isThere |= known == variant;
            if (!isThere)
                throw new ArgumentException($"There is no variant '{variant}' of {species.Name}. It has: {string.Join(", ", species.Variants)}.", nameof(variant));
            m_Species = species.Name;
            m_Variant = variant;
            m_Preset = preset;
        }

        /// <summary>Its place in the catalogue.</summary>
        public SpeciesDefinition Species => Alate.Species.Find(m_Species);

        /// <summary>Which numbers.</summary>
        public SpeciesVariant Variant => m_Variant;

        /// <summary>Which reading.</summary>
        public ModelPreset Preset => m_Preset;

        /// <inheritdoc/>
        public bool Equals(InsectKind other) => m_Species == other.m_Species && m_Variant == other.m_Variant && m_Preset == other.m_Preset;

        /// <inheritdoc/>
        public override bool Equals(object other) => other is InsectKind kind && Equals(kind);

        /// <inheritdoc/>
        public override int GetHashCode() => HashCode.Combine(m_Species, m_Variant, m_Preset);
    }
}
