using System;
using UnityEngine;

namespace Alate
{
    /// <summary>
    /// Posture of an insect that sits: the place of its feet, and the angles of the folded wing. Angles of the drive, with no beat.
    /// </summary>
    [Serializable]
    public struct PresetRest : IEquatable<PresetRest>
    {
        /// <summary>Largest angle of the folded wing, degrees, either way.</summary>
        internal const float MostAngle = 90f;

        /// <summary>The middle of the feet, metres from the insect's origin: X right, Y up, Z ahead.</summary>
        [Tooltip("The middle of the feet, metres of the real insect from its origin: X right, Y up, Z ahead.")]
        public Vector3 feet;

        /// <summary>Flap of the folded wing, degrees above level, −90 to 90.</summary>
        [Range(-MostAngle, MostAngle)]
        [Tooltip("Degrees by which the folded wing is raised above level, -90 to 90; butterflies close theirs above the back: 88.")]
        public float flap;

        /// <summary>Sweep of the folded wing, degrees ahead, −90 to 90.</summary>
        [Range(-MostAngle, MostAngle)]
        [Tooltip("Degrees by which the folded wing is swept ahead, -90 to 90; moths sweep theirs back: -85.")]
        public float sweep;

        /// <summary>Feather of the folded wing, degrees, −90 to 90.</summary>
        [Range(-MostAngle, MostAngle)]
        [Tooltip("Degrees by which the folded wing is turned about its leading edge, -90 to 90; the sides of a moth's roof: 60.")]
        public float feather;

        /// <summary>Tilt of the folded wing about the span of the body, degrees nose up, −90 to 90.</summary>
        [Range(-MostAngle, MostAngle)]
        [Tooltip("Degrees by which the folded wing is tilted nose up, -90 to 90; below 0 lifts the tip of a wing that is swept back.")]
        public float tilt;

        /// <summary>A monarch's.</summary>
        internal static PresetRest Default => new PresetRest { feet = new Vector3(0f, -6.1e-3f, 0f), flap = 88f, sweep = -10f };

        /// <inheritdoc/>
        public bool Equals(PresetRest other) =>
            feet.Equals(other.feet) && flap == other.flap && sweep == other.sweep && feather == other.feather && tilt == other.tilt;

        /// <inheritdoc/>
        public override bool Equals(object other) => other is PresetRest rest && Equals(rest);

        /// <inheritdoc/>
        public override int GetHashCode() => HashCode.Combine(feet, flap, sweep, feather, tilt);
    }
}
