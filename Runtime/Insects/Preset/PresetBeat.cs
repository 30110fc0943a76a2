using System;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Scripting.APIUpdating;

namespace Alate
{
    /// <summary>Drive of the wing at its root (Eq. 1, 6 and 7), in degrees and hertz.</summary>
    [Serializable]
    [MovedFrom(true, null, null, "SpeciesBeat")]
    public struct PresetBeat
    {
        /// <summary>Largest frequency MAX_f of the beat, hertz, 0.1 to 1000.</summary>
        [Range(WingBounds.MaxFrequency.Min, WingBounds.MaxFrequency.Max), Unit("Hz")]
        [Tooltip(
            "Hertz at full speed; 11 in the paper. Small insects reach hundreds. Higher beats load the wing more, and stiffen it in step.")]
        public float maxFrequency;

        /// <summary>Speed u_max of the body at full drive, metres per second, 0.01 to 100.</summary>
        [Range(WingBounds.MaxSpeed.Min, WingBounds.MaxSpeed.Max), Unit("m/s")]
        [Tooltip("Metres per second at which the beat is at its fullest; 2. Half of it gives half the drive.")]
        public float maxSpeed;

        /// <summary>Least drive of the frequency, 0 to 1.</summary>
        [Range(WingBounds.FrequencyFloor.Min, WingBounds.FrequencyFloor.Max), Unit("")]
        [Tooltip("Share of the frequency kept at rest; 0.8. 0 lets a resting insect stop, as the paper has it; 1 beats at full "
            + "frequency always.")]
        public float frequencyFloor;

        /// <summary>Least drive of the amplitude, 0 to 1.</summary>
        [Range(WingBounds.AmplitudeFloor.Min, WingBounds.AmplitudeFloor.Max), Unit("")]
        [Tooltip("Share of the amplitude kept at rest; 0.5. 0 lets a resting insect hold still, as the paper has it; 1 beats at full "
            + "amplitude always.")]
        public float amplitudeFloor;

        /// <summary>Range MAX_a of flapping (Table 1), degrees from lowest to highest, 0 to 180.</summary>
        [Range(WingBounds.FlapRange.Min, WingBounds.FlapRange.Max), Unit("°")]
        [Tooltip("Degrees of flapping from lowest to highest position at full drive; a monarch's is 120. 0 holds the wing level.")]
        public float flapRange;

        /// <summary>Range MAX_a of feathering (Table 1), degrees from end to end, 0 to 180.</summary>
        [Range(WingBounds.FeatherRange.Min, WingBounds.FeatherRange.Max), Unit("°")]
        [Tooltip("Degrees of feathering (turning about the leading edge) from end to end at full drive; a monarch's is 24. 0 never turns "
            + "the wing into the flow.")]
        public float featherRange;

        /// <summary>Range MAX_a of sweeping (Table 1), degrees from end to end, 0 to 180.</summary>
        [Range(WingBounds.SweepRange.Min, WingBounds.SweepRange.Max), Unit("°")]
        [Tooltip("Degrees of sweeping fore and aft from end to end at full drive; a monarch's is 36. 0 keeps the stroke in one plane.")]
        public float sweepRange;

        /// <summary>Phase of flapping, degrees, −180 to 180.</summary>
        [Range(WingBounds.FlapPhase.Min, WingBounds.FlapPhase.Max), Unit("°")]
        [Tooltip("Degrees by which flapping is ahead of the beat; 0: the beat starts at the top.")]
        public float flapPhase;

        /// <summary>Phase of feathering, degrees, −180 to 180.</summary>
        [Range(WingBounds.FeatherPhase.Min, WingBounds.FeatherPhase.Max), Unit("°")]
        [Tooltip("Degrees by which feathering is ahead of the beat; -90 turns the nose down on the downstroke and up on the upstroke. 0 is "
            + "the paper's, +90 the wrong way round.")]
        public float featherPhase;

        /// <summary>Phase of sweeping, degrees, −180 to 180.</summary>
        [Range(WingBounds.SweepPhase.Min, WingBounds.SweepPhase.Max), Unit("°")]
        [Tooltip("Degrees by which sweeping is ahead of the beat; -90 sweeps forward during the downstroke. 0 is the paper's.")]
        public float sweepPhase;

        /// <summary>Middle of the flapping stroke, degrees above level, −90 to 90.</summary>
        [Range(WingBounds.MeanFlap.Min, WingBounds.MeanFlap.Max), Unit("°")]
        [Tooltip("Degrees of the middle of the stroke above level; 10. Raise it for butterflies that clap above the back.")]
        public float meanFlap;

        /// <summary>Tilt of the stroke plane about the span, degrees, −90 to 90.</summary>
        [Range(WingBounds.Tilt.Min, WingBounds.Tilt.Max), Unit("°")]
        [Tooltip("Degrees by which the stroke plane is turned about the span, nose up positive; 0 is upright. 90 beats fore and aft.")]
        public float tilt;

        /// <summary>Lead of this wing before the insect's beat, degrees, −180 to 180.</summary>
        [Range(WingBounds.PhaseLead.Min, WingBounds.PhaseLead.Max), Unit("°")]
        [Tooltip("Degrees by which this wing is ahead of the insect's beat; 0. Hind wings that follow their fore wings are below 0.")]
        public float phaseLead;

        /// <summary>A monarch's.</summary>
        internal static PresetBeat Default
        {
            get
            {
                var beat = new PresetBeat
                {
                    maxFrequency = WingBounds.MaxFrequency.Default,
                    maxSpeed = WingBounds.MaxSpeed.Default,
                    flapRange = WingBounds.FlapRange.Default,
                    featherRange = WingBounds.FeatherRange.Default,
                    sweepRange = WingBounds.SweepRange.Default,
                    meanFlap = WingBounds.MeanFlap.Default,
                };
                beat.Apply(ModelReading.Physical);
                return beat;
            }
        }

        /// <summary>Sets what the two readings of the paper differ in.</summary>
        internal void Apply(ModelReading reading)
        {
            bool paper = reading == ModelReading.Paper;
            frequencyFloor = paper ? 0f : WingBounds.FrequencyFloor.Default;
            amplitudeFloor = paper ? 0f : WingBounds.AmplitudeFloor.Default;
            flapPhase = WingBounds.FlapPhase.Default;
            featherPhase = paper ? 0f : WingBounds.FeatherPhase.Default;
            sweepPhase = paper ? 0f : WingBounds.SweepPhase.Default;
        }

        /// <summary>Writes the beat in the units of the model.</summary>
        internal readonly void WriteTo(ref WingParameters parameters)
        {
            parameters.maxFrequency = maxFrequency;
            parameters.maxSpeed = maxSpeed;
            parameters.frequencyFloor = frequencyFloor;
            parameters.amplitudeFloor = amplitudeFloor;
            parameters.amplitude = math.radians(0.5f * new float3(flapRange, sweepRange, featherRange));
            parameters.phase = math.radians(new float3(flapPhase, sweepPhase, featherPhase));
            parameters.meanFlap = math.radians(meanFlap);
            parameters.tilt = math.radians(tilt);
            parameters.phaseLead = math.radians(phaseLead);
        }
    }
}
