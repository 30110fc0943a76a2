using System;
using UnityEngine;

namespace Alate
{
    /// <summary>
    /// Motion of a wing that is prescribed, as measured kinematics are published, in place of Beat's ranges and frequency.
    /// </summary>
    [Serializable]
    public struct PresetKinematics
    {
        /// <summary>True where the motion below drives the wing.</summary>
        [Tooltip("Drives the wing by the series below in place of the ranges, phases and frequency of Beat.")]
        public bool prescribed;

        /// <summary>True where the delays of Wave act on the prescribed angles.</summary>
        [Tooltip("The delays of Wave run over the prescribed motion too. Off drives the whole wing at once.")]
        public bool waves;

        /// <summary>Frequency of the beat, hertz, 0.1 to 1000.</summary>
        [Tooltip("Hertz at any speed, 0.1 to 1000.")]
        public float frequency;

        /// <summary>Flap in the stroke plane, up positive.</summary>
        [Tooltip("In the stroke plane, up positive.")]
        public AngleSeries flap;

        /// <summary>Sweep out of the stroke plane, ahead positive; a coning angle is a constant sweep.</summary>
        [Tooltip("Out of the stroke plane, ahead positive. A coning angle is a constant.")]
        public AngleSeries sweep;

        /// <summary>Feather about the leading edge, nose down positive.</summary>
        [Tooltip("About the leading edge, nose down positive.")]
        public AngleSeries feather;

        /// <summary>Tilt of the stroke plane, nose up positive; 0 is upright, 90° less the inclination from the horizontal.</summary>
        [Tooltip("Of the stroke plane, nose up positive; 0 is upright, 90 horizontal.")]
        public AngleSeries tilt;

        /// <summary>The motion in the units of the model.</summary>
        internal readonly WingKinematics ToKinematics()
        {
            WingKinematics kinematics = default;
            if (!prescribed)
                return kinematics;
            kinematics.frequency = frequency;
            kinematics.waves = waves;
            flap.WriteTo(ref kinematics, DrivenAngle.Flap);
            sweep.WriteTo(ref kinematics, DrivenAngle.Sweep);
            feather.WriteTo(ref kinematics, DrivenAngle.Feather);
            tilt.WriteTo(ref kinematics, DrivenAngle.Tilt);
            return kinematics;
        }

        /// <summary>A copy with every number in its range.</summary>
        internal readonly PresetKinematics Clamped()
        {
            PresetKinematics clamped = this;
            if (prescribed)
            {
                clamped.frequency = frequency >= WingBounds.MaxFrequency.Min
                    ? Mathf.Min(frequency, WingBounds.MaxFrequency.Max)
                    : WingBounds.MaxFrequency.Min;
            }
            clamped.flap = flap.Clamped();
            clamped.sweep = sweep.Clamped();
            clamped.feather = feather.Clamped();
            clamped.tilt = tilt.Clamped();
            return clamped;
        }
    }
}
