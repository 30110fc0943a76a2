using Alate.Catalogue;
using UnityEngine;

namespace Alate.Samples
{
    /// <summary>One species in its place: made again for each variant, in flight at two thirds of its full drive.</summary>
    internal sealed class ShownInsect
    {
        private const float k_Size = 1.6f, k_ShareOfFullSpeed = 0.65f;

        private readonly InsectDefinition m_Species;
        private readonly Transform m_Place;
        private InsectWings m_Insect;

        /// <param name="species">What is shown.</param>
        /// <param name="parent">Of its place.</param>
        /// <param name="place">Below the parent.</param>
        public ShownInsect(InsectDefinition species, Transform parent, Vector3 place)
        {
            m_Species = species;
            m_Place = new GameObject(species.DisplayName).transform;
            m_Place.SetParent(parent, false);
            m_Place.localPosition = place;
        }

        /// <summary>Position of the insect, world units.</summary>
        public Vector3 Place => m_Place.position;

        /// <summary>Name, variant and frequency.</summary>
        public string Label { get; private set; } = "";

        /// <summary>Shows a variant; the standard one where the species does not have it.</summary>
        public void Show(InsectVariant variant)
        {
            if (m_Insect != null)
                Object.Destroy(m_Insect.gameObject);
            InsectVariant shown = Has(variant) ? variant : InsectVariant.Standard;
            m_Insect = InsectFactory.Create(m_Species, shown);
            m_Insect.transform.SetParent(m_Place, false);
            float scale = k_Size / Size();
            m_Insect.transform.localScale = scale * Vector3.one;

            // It stands still and is told how fast it flies, in the units of the large insect that is drawn.
            m_Insect.Motion.source = VelocitySource.Script;
            m_Insect.Velocity =
                k_ShareOfFullSpeed * m_Insect.Preset.Beat.maxSpeed * InsectDefinition.UnitsPerMetre * scale * m_Place.forward;
            m_Insect.UpdateMode = WingUpdateMode.Manual;
            Label = $"{m_Species.DisplayName}\n{shown}, {m_Insect.Preset.Beat.maxFrequency:0.#} Hz";
        }

        /// <summary>Lets its time go by, seconds.</summary>
        public void Step(float dt) => m_Insect.Step(dt);

        // World units from tip to tip, or from head to tail of what is longer than that.
        private float Size()
        {
            float size = 2f * m_Insect.Preset.WingLength * InsectDefinition.UnitsPerMetre;
            foreach (MeshFilter part in m_Insect.GetComponentsInChildren<MeshFilter>())
                size = Mathf.Max(size, part.sharedMesh.bounds.size.z);
            return size;
        }

        private bool Has(InsectVariant variant)
        {
            foreach (InsectVariant known in m_Species.Variants)
            {
                if (known == variant)
                    return true;
            }

            return false;
        }
    }
}
