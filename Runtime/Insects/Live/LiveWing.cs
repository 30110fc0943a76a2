using UnityEngine;

namespace Alate
{
    /// <summary>One wing while it lives: its place in the world of the simulation, and what it was last told.</summary>
    internal sealed class LiveWing
    {
        public readonly WingRig rig;

        public readonly MeshRenderer renderer;
        public readonly Transform transform;

        /// <summary>First vertex in the deformed mesh.</summary>
        public readonly int start;

        public WingHandle handle;
        public PlacedWing placed;

        /// <summary>Current values of its preset.</summary>
        public PresetValues values;

        private Wing m_Wing;
        private WingPreset m_OwnPreset;
        private InsectTuning m_Tuning;
        private int m_Stamp;
        private float m_Amplitude, m_Lead;
        private readonly TemplateKey.WingKey m_Key;
        private readonly SkeletonValue m_Skeleton;

        public LiveWing(Wing wing, SkeletonValue skeleton, MeshTemplate template, int shape)
        {
            m_Wing = wing;
            m_Skeleton = skeleton;
            m_Key = new TemplateKey.WingKey(wing, skeleton.Hash);
            renderer = wing.Renderer;
            rig = template.Shapes[shape].Rig;
            start = template.Starts[shape];
            transform = renderer.transform;
        }

        /// <summary>Whether the wing in the list is still what this one was built of.</summary>
        public bool IsBuiltOf(Wing listed) =>
            listed != null && ReferenceEquals(listed.Renderer, renderer) && m_Key.Describes(listed, m_Skeleton.Hash);

        /// <summary>Follows another object of the list that says the same: the editor makes new ones when a slider is moved.</summary>
        public void Follow(Wing listed)
        {
            if (ReferenceEquals(listed, m_Wing))
                return;
            listed.Authored = m_Wing.Authored;
            m_Wing = listed;
        }

        /// <summary>The wing shows its authored mesh again.</summary>
        public void ForgetAuthored() => m_Wing.Authored = null;

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
        /// <param name="tuning">What the insect says of all its wings.</param>
        /// <param name="parameters">What the wing is to be stepped with.</param>
        /// <returns>Whether anything changed since the last call.</returns>
        public bool ApplyParameters(PresetWatch species, in InsectTuning tuning, out WingParameters parameters)
        {
            if (values == null || values.IsForgotten || !ReferenceEquals(m_OwnPreset, m_Wing.Preset) || !ReferenceEquals(m_Tuning.preset, tuning.preset))
            {
                m_OwnPreset = m_Wing.Preset;
                values = species.Of(m_OwnPreset == null ? tuning.preset : m_OwnPreset);
                m_Stamp = -1;
            }

            float amplitude = m_Wing.AmplitudeScale, lead = Mathf.Deg2Rad * m_Wing.PhaseLead;
            bool same = values.Stamp == m_Stamp && amplitude == m_Amplitude && lead == m_Lead && tuning.SameAs(m_Tuning);
            m_Stamp = values.Stamp;
            m_Amplitude = amplitude;
            m_Lead = lead;
            m_Tuning = tuning;
            if (same)
            {
                parameters = default;
                return false;
            }

            parameters = values.parameters;
            parameters.amplitudeScale *= amplitude;
            parameters.phaseLead += lead;
            tuning.Apply(ref parameters);
            parameters = parameters.Clamped();
            return true;
        }
    }
}
