using UnityEngine;

namespace Alate
{
    /// <summary>
    /// Settings of an insect that hold for all its wings: preset, steering, substeps, and the factor by which its beat fades.
    /// </summary>
    internal readonly struct InsectTuning
    {
        public readonly WingPreset preset;
        private readonly InsectSteering m_Steering;
        private readonly int m_Substeps;

        /// <param name="insect">Whose.</param>
        /// <param name="fade">Factor on the amplitudes: 0 while the wings are to come to rest.</param>
        public InsectTuning(InsectWings insect, float fade)
        {
            preset = insect.Preset;
            m_Substeps = insect.SubstepsPerBeat;
            m_Steering = insect.Steering.Clamped();
            m_Steering.amplitudeScale *= fade;
            Fold = m_Steering.fold;
            m_Steering.fold = 0f;
        }

        /// <summary>Share to which the wings are folded, 0 to 1; a command, no parameter changes.</summary>
        public float Fold { get; }

        /// <summary>Returns true where two change parameters alike.</summary>
        public bool SameAs(in InsectTuning other) => m_Substeps == other.m_Substeps && m_Steering.Equals(other.m_Steering);

        /// <summary>Parameters of a wing: the preset's, changed by its own sliders and by these settings, in their ranges.</summary>
        public WingParameters ParametersOf(PresetValues values, Wing wing)
        {
            WingParameters parameters = values.parameters;
            parameters.amplitudeScale *= wing.AmplitudeScale;
            parameters.phaseLead += Mathf.Deg2Rad * wing.PhaseLead;
            m_Steering.Apply(ref parameters);
            if (m_Substeps > 0)
                parameters.substepsPerBeat = m_Substeps;
            return parameters.Clamped();
        }
    }
}
