using Unity.Mathematics;

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
            Take(PresetDefaults.MonarchSize);
            Refresh();
        }

        /// <summary>Parameters of the model.</summary>
        public WingParameters parameters;

        /// <summary>Wing length, metres.</summary>
        public float wingLength;

        /// <summary>Mass of a wing and of the insect, kilograms.</summary>
        public float wingMass, insectMass;

        /// <summary>Share of gravity that the wing feels, 0 to 1.</summary>
        public float gravityShare;

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
            Take(m_Preset.Size);
            WingParameters now = m_Preset.ToParameters();
            if (now.SameAs(parameters))
                return;
            parameters = now;
            m_Stamp++;
        }

        private void Take(in PresetSize size)
        {
            wingLength = math.clamp(size.wingLength, 5e-4f, 1f);
            wingMass = math.clamp(size.wingMass, 1e-9f, 1f);
            insectMass = math.clamp(size.insectMass, 1e-8f, 10f);
            gravityShare = math.saturate(size.gravityShare);
        }
    }
}
