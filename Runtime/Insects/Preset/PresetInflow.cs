using System;
using Unity.Mathematics;
using UnityEngine;

namespace Alate
{
    /// <summary>
    /// Air that the wake has set moving at the wing, over the beat: v(t) = mean + Σ cosine_k cos(2πk t/T) + sine_k sin(2πk t/T), metres a
    /// second along the axes of a right wing's insect: X right, Y up, Z ahead. The command <c>wake</c> computes it.
    /// </summary>
    [Serializable]
    public struct PresetInflow
    {
        /// <summary>Largest speed along an axis, m/s, either way.</summary>
        internal const float MostSpeed = 100f;

        /// <summary>Mean over the beat, m/s, each axis −100 to 100.</summary>
        [Tooltip("Metres a second, mean over the beat: X outwards along a right wing, Y up, Z ahead. 0 is air that no wake has moved.")]
        public Vector3 mean;

        /// <summary>Part that goes with the cosine of the phase, m/s, each axis −100 to 100.</summary>
        [Tooltip("Metres a second that go with the cosine of the phase; the phase is 0 where a beat begins.")]
        public Vector3 cosine1;

        /// <summary>Part that goes with the sine of the phase, m/s, each axis −100 to 100.</summary>
        [Tooltip("Metres a second that go with the sine of the phase.")]
        public Vector3 sine1;

        /// <summary>Part that goes with the cosine of twice the phase, m/s, each axis −100 to 100.</summary>
        [Tooltip("Metres a second that go with the cosine of twice the phase.")]
        public Vector3 cosine2;

        /// <summary>Part that goes with the sine of twice the phase, m/s, each axis −100 to 100.</summary>
        [Tooltip("Metres a second that go with the sine of twice the phase.")]
        public Vector3 sine2;

        /// <summary>The inflow in the units of the model.</summary>
        /// <param name="wingLength">Metres from hinge to tip.</param>
        internal readonly WingInflow ToInflow(float wingLength)
        {
            PresetInflow own = Clamped();
            var speeds = new WingInflow
            {
                mean = own.mean,
                cosine1 = own.cosine1,
                sine1 = own.sine1,
                cosine2 = own.cosine2,
                sine2 = own.sine2,
            };
            return speeds * (1f / wingLength);
        }

        /// <summary>A copy with every number in its range.</summary>
        internal readonly PresetInflow Clamped() => new PresetInflow
        {
            mean = Speed(mean),
            cosine1 = Speed(cosine1),
            sine1 = Speed(sine1),
            cosine2 = Speed(cosine2),
            sine2 = Speed(sine2),
        };

        private static float3 Speed(float3 speed) => math.clamp(math.select(speed, 0f, math.isnan(speed)), -MostSpeed, MostSpeed);
    }
}
