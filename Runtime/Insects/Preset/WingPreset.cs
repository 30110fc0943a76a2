using System;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Scripting.APIUpdating;

namespace Alate
{
    /// <summary>
    /// A preset of one kind of wing, as it is authored: degrees, hertz, metres, kilograms. A new asset is a monarch's wing.
    /// <see cref="ToParameters"/> turns it into what the model computes with.
    /// </summary>
    [CreateAssetMenu(fileName = "Wing Preset", menuName = "Alate/Wing Preset", order = 311)]
    [MovedFrom(true, null, null, "WingSpecies")]
    public sealed class WingPreset : ScriptableObject
    {
        /// <summary>
        /// Least speed of the wing tip that the reference frequency counts with, as a share of u_max: a wing that hardly flaps stays finite
        /// in stiffness.
        /// </summary>
        private const float k_LeastTipSpeed = 0.1f;

        [SerializeField]
        private PresetSize m_Size = PresetSize.Default;

        [SerializeField]
        private PresetBeat m_Beat = PresetBeat.Default;

        [SerializeField]
        private PresetWave m_Wave = PresetWave.Default;

        [SerializeField]
        private PresetStiffness m_Stiffness = PresetStiffness.Default;

        [SerializeField]
        private PresetKinematics m_Kinematics;

        [SerializeField]
        private PresetInflow m_Inflow;

        [SerializeField]
        [Range(WingParameters.MinSubsteps, WingParameters.MaxSubsteps)]
        [Tooltip("Substeps of one beat; 16. 12 is the cheapest, 480 for measurements; in fast air there are more by themselves.")]
        private int m_SubstepsPerBeat = WingParameters.DefaultSubsteps;

        [SerializeField]
        private PresetRest m_Rest = PresetRest.Default;

        [SerializeField]
        private ModelOptions m_Options = ModelOptions.Physical;

        /// <summary>Sizes and masses of the real insect, and the fluid.</summary>
        public ref PresetSize Size => ref m_Size;

        /// <summary>The drive at the root.</summary>
        public ref PresetBeat Beat => ref m_Beat;

        /// <summary>The wave over the wing.</summary>
        public ref PresetWave Wave => ref m_Wave;

        /// <summary>The resistance to bending.</summary>
        public ref PresetStiffness Stiffness => ref m_Stiffness;

        /// <summary>A motion that is prescribed in place of the drive; by default none.</summary>
        public ref PresetKinematics Kinematics => ref m_Kinematics;

        /// <summary>Air that the wake has set moving at the wing; by default none.</summary>
        public ref PresetInflow Inflow => ref m_Inflow;

        /// <summary>Posture of the insect that sits, with its wings folded.</summary>
        public ref PresetRest Rest => ref m_Rest;

        /// <summary>Substeps of one beat, 12 to 480.</summary>
        public ref int SubstepsPerBeat => ref m_SubstepsPerBeat;

        /// <summary>The choices the paper leaves open.</summary>
        public ref ModelOptions Options => ref m_Options;

        /// <summary>Wing length L: metres from hinge to tip of the real wing.</summary>
        public float WingLength => m_Size.wingLength;

        /// <summary>
        /// f_ref = MAX_f √(1 + (u_max / v_tip)²) with v_tip = 2π MAX_f (MAX_a,flap / 2) L: the beat, corrected for the speed of flight,
        /// hertz.
        /// </summary>
        public float ReferenceFrequency
        {
            get
            {
                float tipSpeed = 2f * math.PI * m_Beat.maxFrequency * math.radians(0.5f * m_Beat.flapRange) * m_Size.wingLength;
                float ratio = m_Beat.maxSpeed / math.max(tipSpeed, k_LeastTipSpeed * m_Beat.maxSpeed);
                return m_Beat.maxFrequency * math.sqrt(1f + ratio * ratio);
            }
        }

        /// <summary>
        /// Converts the preset to the units of the model, every value in its range; a prescribed motion with a number out of its range is
        /// left out whole. Allocates nothing where no such number is.
        /// </summary>
        public WingParameters ToParameters()
        {
            var parameters = new WingParameters
            {
                airDensity = m_Size.RelativeDensity,
                referenceFrequency = ReferenceFrequency,
                stiffnessUnit = m_Size.StiffnessUnit,
                substepsPerBeat = m_SubstepsPerBeat,
                amplitudeScale = 1f,
                options = m_Options,
                kinematics = m_Kinematics.ToKinematics(),
                inflow = m_Inflow.ToInflow(m_Size.Clamped().wingLength),
            };
            m_Beat.WriteTo(ref parameters);
            m_Wave.WriteTo(ref parameters);
            m_Stiffness.WriteTo(ref parameters);
            return parameters.Clamped();
        }

        /// <summary>
        /// Sets everything in which the two readings of the paper differ: phases, delays, floors, the factor of inertia and the options.
        /// What belongs to the insect (sizes, ranges, frequency, stiffness) stays.
        /// </summary>
        /// <param name="reading">The reading to follow.</param>
        /// <param name="chordDelay">λ for <see cref="ModelReading.Physical"/>; the printed reading has 1.</param>
        public void ApplyReading(ModelReading reading, float chordDelay = WingBounds.ChordDelay.Default)
        {
            m_Beat.Apply(reading);
            m_Wave.Apply(reading, chordDelay);
            m_Options = reading == ModelReading.Paper ? ModelOptions.Paper : ModelOptions.Physical;
        }

        private void OnValidate()
        {
            m_Size = m_Size.Clamped();
            m_Stiffness = m_Stiffness.Clamped();
            m_Kinematics = m_Kinematics.Clamped();
            m_Inflow = m_Inflow.Clamped();
        }
    }
}
