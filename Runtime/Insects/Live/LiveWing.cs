using UnityEngine;

namespace Alate
{
    /// <summary>One wing while it lives: its place in the world of the simulation, and what it was last told.</summary>
    internal sealed class LiveWing
    {
        public readonly Wing wing;
        public readonly WingRig rig;

        /// <summary>What it was built of.</summary>
        public readonly TemplateKey.WingKey key;
        public readonly MeshRenderer renderer;
        public readonly Transform transform;

        /// <summary>First vertex in the deformed mesh.</summary>
        public readonly int start;

        public WingHandle handle;
        public PlacedWing placed;

        /// <summary>Current values of its preset.</summary>
        public SpeciesValues values;

        private int m_Stamp;
        private float m_Amplitude, m_Lead;
        private int m_Substeps;

        public LiveWing(Wing wing, in TemplateKey.WingKey key, MeshTemplate template, int shape)
        {
            this.wing = wing;
            this.key = key;
            renderer = wing.Renderer;
            rig = template.Shapes[shape].Rig;
            start = template.Starts[shape];
            transform = renderer.transform;
        }

        /// <summary>Looks where the wing is in the world.</summary>
        public void Place()
        {
            if (transform != null)
                placed = new PlacedWing(transform.localToWorldMatrix, rig.Frame);
        }

        /// <summary>What the wing feels of the body's flight, where it was last placed.</summary>
        public WingSurroundings Surroundings(in BodyFlight flight) =>
            placed.isValid ? flight.Around(placed, values.wingLength, values.gravityShare) : default;

        /// <summary>Takes over preset and sliders.</summary>
        /// <param name="species">The presets in use.</param>
        /// <param name="preset">The insect's own.</param>
        /// <param name="substeps">Substeps of a beat, 0 for the preset's.</param>
        /// <param name="fade">Factor on the amplitude, for coming to rest.</param>
        /// <param name="parameters">What the wing is to be stepped with.</param>
        /// <returns>Whether anything changed since the last call.</returns>
        public bool Tune(SpeciesWatch species, WingSpecies preset, int substeps, float fade, out WingParameters parameters)
        {
            SpeciesValues now = species.Of(wing.Species == null ? preset : wing.Species);
            float amplitude = wing.AmplitudeScale * fade, lead = Mathf.Deg2Rad * wing.PhaseLead;
            bool same = now == values && now.Stamp == m_Stamp && amplitude == m_Amplitude && lead == m_Lead && substeps == m_Substeps;
            values = now;
            m_Stamp = now.Stamp;
            m_Amplitude = amplitude;
            m_Lead = lead;
            m_Substeps = substeps;
            if (same)
            {
                parameters = default;
                return false;
            }

            parameters = now.parameters;
            parameters.amplitudeScale *= amplitude;
            parameters.phaseLead += lead;
            if (substeps > 0)
                parameters.substepsPerBeat = substeps;
            parameters = parameters.Clamped();
            return true;
        }
    }
}
