namespace Alate
{
    /// <summary>What an insect says of all its wings: preset, steering, substeps, and how far its beat has faded.</summary>
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
        }

        /// <summary>Whether two change parameters in the same way.</summary>
        public bool SameAs(in InsectTuning other) => m_Substeps == other.m_Substeps && m_Steering.Equals(other.m_Steering);

        /// <summary>Changes a preset's parameters.</summary>
        public void Apply(ref WingParameters parameters)
        {
            m_Steering.Apply(ref parameters);
            if (m_Substeps > 0)
                parameters.substepsPerBeat = m_Substeps;
        }
    }
}
