namespace Alate
{
    /// <summary>Values of a preset in the units of the model; compared once a step, however many insects share the preset.</summary>
    internal sealed class PresetValues : WatchedValue
    {
        private readonly WingPreset m_Preset;
        private int m_Stamp;

        /// <param name="preset">Null stands for a monarch.</param>
        public PresetValues(WingPreset preset)
        {
            m_Preset = preset;
            parameters = WingParameters.Default;
            Refresh();
        }

        /// <summary>Parameters of the model.</summary>
        public WingParameters parameters;

        /// <summary>The preset's sizes, in their ranges.</summary>
        public PresetSize size = PresetSize.Default;

        /// <summary>Number of changes of <see cref="parameters"/>.</summary>
        public int Stamp
        {
            get
            {
                Use();
                return m_Stamp;
            }
        }

        /// <inheritdoc/>
        public override void Refresh()
        {
            if (m_Preset == null)
                return;
            size = m_Preset.Size.Clamped();
            WingParameters now = m_Preset.ToParameters();
            if (now.SameAs(parameters))
                return;
            parameters = now;
            m_Stamp++;
        }
    }
}
