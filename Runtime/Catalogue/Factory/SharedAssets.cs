using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>
    /// Parts that all insects of one species share in play, with the number of insects that use them. A hidden asset holds them because
    /// assets survive a recompile during play, and static fields do not.
    /// </summary>
    internal sealed class SharedAssets : ScriptableObject
    {
        [SerializeField] private string m_Key = "";
        [SerializeField] private string m_Name = "";
        [SerializeField] private int m_Users;
        [SerializeField] private Mesh m_BodyMesh;
        [SerializeField] private Mesh m_AbdomenMesh;
        [SerializeField] private Material m_BodyMaterial;
        [SerializeField] private List<GeneratedWing> m_Wings = new List<GeneratedWing>();
        [SerializeField] private List<Presets> m_Presets = new List<Presets>();

        // Lost in a recompile, after which nobody can ask for more insects of it: who does has another definition.
        private InsectDefinition m_Definition;

        /// <summary>Name of the species in the catalogue, or key of an insect of the user's own.</summary>
        public string Key => m_Key;

        /// <summary>Number of insects that use the parts.</summary>
        public int Users
        {
            get => m_Users;
            set => m_Users = value;
        }

        /// <summary>Makes the parts of a species, without users yet.</summary>
        /// <param name="species">The insect.</param>
        /// <param name="key">By which its parts are found.</param>
        /// <exception cref="InvalidOperationException">No shader was found.</exception>
        public static SharedAssets Make(InsectDefinition species, string key)
        {
            var parts = InsectParts.Make(species);
            parts.Hide();
            SharedAssets assets = CreateInstance<SharedAssets>();
            assets.name = parts.Name + " Assets";
            assets.hideFlags = HideFlags.HideAndDontSave;
            assets.m_Key = key;
            assets.m_Name = parts.Name;
            assets.m_Definition = species;
            assets.m_BodyMesh = parts.BodyMesh;
            assets.m_AbdomenMesh = parts.AbdomenMesh;
            assets.m_BodyMaterial = parts.BodyMaterial;
            assets.m_Wings.AddRange(parts.Wings);
            return assets;
        }

        /// <summary>Puts an insect together, inactive, with presets that are shared and hidden as the other parts are.</summary>
        public GameObject Assemble(InsectVariant variant, ModelReading reading)
        {
            InsectParts parts = Parts(InsectParts.Of(m_Definition ?? InsectCatalogue.Find(m_Key), m_Wings));
            return parts.Assemble(PresetsOf(parts, variant, reading));
        }

        /// <summary>Frees all parts and this asset itself.</summary>
        public void Free()
        {
            foreach (Presets presets in m_Presets)
            {
                foreach (WingPreset made in presets.wings)
                    ObjectEnd.Destroy(made);
            }

            Parts(new InsectParts(m_Name, m_Wings)).Destroy();
            ObjectEnd.Destroy(this);
        }

        // Called after a recompile as well; one that is being made has no species yet.
        private void OnEnable()
        {
            if (!string.IsNullOrEmpty(m_Key))
                GeneratedAssets.Remember(this);
        }

        private InsectParts Parts(InsectParts parts)
        {
            parts.BodyMesh = m_BodyMesh;
            parts.AbdomenMesh = m_AbdomenMesh;
            parts.BodyMaterial = m_BodyMaterial;
            return parts;
        }

        private WingPreset[] PresetsOf(InsectParts parts, InsectVariant variant, ModelReading reading)
        {
            foreach (Presets known in m_Presets)
            {
                if (known.variant == variant && known.reading == reading)
                    return known.wings;
            }

            WingPreset[] made = parts.CreatePresets(variant, reading);
            foreach (WingPreset wing in made)
                wing.hideFlags = HideFlags.HideAndDontSave;
            m_Presets.Add(new Presets { variant = variant, reading = reading, wings = made });
            return made;
        }

        [Serializable]
        private struct Presets
        {
            public InsectVariant variant;
            public ModelReading reading;
            public WingPreset[] wings;
        }
    }
}
