using Unity.Mathematics;
using UnityEngine;

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

        /// <summary>Posture of the insect that sits, degrees.</summary>
        private PresetRest m_Rest = PresetRest.Default;

        /// <summary>Number of changes of <see cref="parameters"/> and of the folded wing.</summary>
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
            PresetRest rest = m_Preset.Rest;
            if (now.SameAs(parameters) && rest.Equals(m_Rest))
                return;
            parameters = now;
            m_Rest = rest;
            m_Stamp++;
        }

        /// <summary>Middle of the feet from the insect's origin, metres.</summary>
        public Vector3 Feet => m_Rest.feet;

        /// <summary>Drive of a wing that is held still, folded to a share.</summary>
        public WingDrive Folded(float fold)
        {
            var rest = new float4(m_Rest.flap, m_Rest.sweep, m_Rest.feather, m_Rest.tilt);
            rest = math.radians(math.clamp(math.select(rest, 0f, math.isnan(rest)), -PresetRest.MostAngle, PresetRest.MostAngle));
            return new WingDrive
            {
                frequency = parameters.maxFrequency,
                meanFlap = fold * (rest.x - parameters.meanFlap),
                meanSweep = fold * rest.y,
                meanFeather = fold * rest.z,
                tilt = fold * (rest.w - parameters.tilt),
            };
        }
    }
}
