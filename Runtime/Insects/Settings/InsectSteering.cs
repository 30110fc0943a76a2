using System;
using Unity.Mathematics;
using UnityEngine;

namespace Alate
{
    /// <summary>
    /// Changes to the preset's beat that hold for all wings, for flight controllers; may be set in every step. Changes that differ from
    /// wing to wing are in <see cref="Wing"/>.
    /// </summary>
    [Serializable]
    public struct InsectSteering : IEquatable<InsectSteering>
    {
        private const float k_LeastFrequency = 0.1f, k_MostFrequency = 4f, k_MostTilt = 60f;

        /// <summary>Factor on the beat's frequency, 0.1 to 4; default 1. Takes effect with the next beat.</summary>
        [Range(k_LeastFrequency, k_MostFrequency)]
        [Tooltip("Factor on the frequency of the beat, 0.1 to 4; 1 is the preset's. Seen from the next beat on.")]
        public float frequencyScale;

        /// <summary>Factor on all amplitudes, 0 to 2; default 1. 0 holds the wings still: a glide. Followed over the next beats.</summary>
        [Range(0f, Wing.MostAmplitude)]
        [Tooltip(
            "Factor on the amplitudes of all wings, 0 to 2; 1 is the preset's. 0 holds them still in the middle of their stroke: a glide.")]
        public float amplitudeScale;

        /// <summary>Raise of the middle of the stroke, degrees, −60 to 60; default 0.</summary>
        [Range(-k_MostTilt, k_MostTilt)]
        [Tooltip("Degrees by which the middle of the stroke is raised, -60 to 60; 0 is the preset's. Raised wings make a glide steady.")]
        public float meanFlap;

        /// <summary>Tilt of the stroke plane, degrees, nose up positive, −60 to 60; default 0.</summary>
        [Range(-k_MostTilt, k_MostTilt)]
        [Tooltip("Degrees by which the plane of the stroke is tilted, nose up positive, -60 to 60; 0 is the preset's. Tilts the force "
            + "forwards and back.")]
        public float tilt;

        /// <summary>
        /// Share to which the wings are folded, 0 to 1, default 0. 1 holds them still as the preset's rest has them. Followed over the next
        /// beats.
        /// </summary>
        [Range(0f, 1f)]
        [Tooltip("How far the wings are folded, 0 to 1; 0 beats. Above 0 they are held still, at 1 as the preset's rest has them.")]
        public float fold;

        /// <summary>Default steering: the preset's beat unchanged.</summary>
        public static InsectSteering Default => new InsectSteering { frequencyScale = 1f, amplitudeScale = 1f };

        /// <inheritdoc/>
        public bool Equals(InsectSteering other) =>
            frequencyScale == other.frequencyScale && amplitudeScale == other.amplitudeScale && meanFlap == other.meanFlap
            && tilt == other.tilt && fold == other.fold;

        /// <inheritdoc/>
        public override bool Equals(object other) => other is InsectSteering steering && Equals(steering);

        /// <inheritdoc/>
        public override int GetHashCode() => HashCode.Combine(frequencyScale, amplitudeScale, meanFlap, tilt, fold);

        /// <summary>Steering with every value moved into its range; a value that is no number becomes its default.</summary>
        internal InsectSteering Clamped()
        {
            InsectSteering none = Default;
            return new InsectSteering
            {
                frequencyScale = NumberRange.Clamp(frequencyScale, k_LeastFrequency, k_MostFrequency, none.frequencyScale),
                amplitudeScale = NumberRange.Clamp(amplitudeScale, 0f, Wing.MostAmplitude, none.amplitudeScale),
                meanFlap = NumberRange.Clamp(meanFlap, -k_MostTilt, k_MostTilt, none.meanFlap),
                tilt = NumberRange.Clamp(tilt, -k_MostTilt, k_MostTilt, none.tilt),
                fold = NumberRange.Clamp(fold, 0f, 1f, none.fold),
            };
        }

        /// <summary>Changes a preset's parameters.</summary>
        internal void Apply(ref WingParameters parameters)
        {
            parameters.maxFrequency *= frequencyScale;
            parameters.amplitudeScale *= amplitudeScale;
            parameters.meanFlap += math.radians(meanFlap);
            parameters.tilt += math.radians(tilt);
        }
    }
}
