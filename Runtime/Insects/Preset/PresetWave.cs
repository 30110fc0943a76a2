using System;
using UnityEngine;
using UnityEngine.Scripting.APIUpdating;

namespace Alate
{
    /// <summary>Delays with which the drive runs over the wing as a wave (Eq. 2 and 3).</summary>
    [Serializable]
    [MovedFrom(true, null, null, "SpeciesWave")]
    public struct PresetWave
    {
        /// <summary>Largest delay λ of the trailing edge, half beats, 0 to 2; see <see cref="WingParameters.chordDelay"/>.</summary>
        [Range(WingBounds.ChordDelay.Min, WingBounds.ChordDelay.Max), Unit("half beats")]
        [Tooltip("Half beats by which the trailing edge follows the leading edge, less where neighbouring chains are too close to bear it; "
            + "0.15. 0 is a wing without a wave; 1 with Coupling One Way is the paper's print, where the trailing edge goes up while the "
            + "leading edge goes down.")]
        public float chordDelay;

        /// <summary>Delay μ from root to tip, half beats, 0 to 2.</summary>
        [Range(WingBounds.SpanDelay.Min, WingBounds.SpanDelay.Max), Unit("half beats")]
        [Tooltip("Half beats by which the tip follows the root; 0.1. 0 is the paper's.")]
        public float spanDelay;

        /// <summary>Share w_0 of the driven angle that the root turns, 0 to 1.</summary>
        [Range(WingBounds.RootShare.Min, WingBounds.RootShare.Max), Unit("")]
        [Tooltip("Share of the stroke that turns at the hinge; 0.8. 1 drives a flat wing from its root; 0 rolls the whole stroke out "
            + "along the span.")]
        public float rootShare;

        /// <summary>Factor κ_in of the beat's own inertia, 0 to 10.</summary>
        [Range(WingBounds.Inertia.Min, WingBounds.Inertia.Max), Unit("")]
        [Tooltip("Factor of the beat's own inertia; 1 is Newton's law, 2 the printed Eq. 5. 0 leaves the wing to air and gravity.")]
        public float inertia;

        /// <summary>A monarch's.</summary>
        internal static PresetWave Default
        {
            get
            {
                var wave = new PresetWave { rootShare = WingBounds.RootShare.Default };
                wave.Apply(ModelReading.Physical, WingBounds.ChordDelay.Default);
                return wave;
            }
        }

        /// <summary>Sets what the two readings of the paper differ in.</summary>
        internal void Apply(ModelReading reading, float chordDelay)
        {
            bool paper = reading == ModelReading.Paper;
            this.chordDelay = paper ? 1f : chordDelay;
            spanDelay = paper ? 0f : WingBounds.SpanDelay.Default;
            inertia = paper ? 2f : WingBounds.Inertia.Default;
        }

        /// <summary>Writes the wave in the units of the model.</summary>
        internal readonly void WriteTo(ref WingParameters parameters)
        {
            parameters.chordDelay = chordDelay;
            parameters.spanDelay = spanDelay;
            parameters.rootShare = rootShare;
            parameters.inertia = inertia;
        }
    }
}
