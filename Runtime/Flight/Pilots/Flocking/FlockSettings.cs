using System;
using UnityEngine;

namespace Alate.Flight
{
    /// <summary>Settings of an insect's flight among others. Distances in wing lengths, so that one setting suits every species; all numbers are chosen for the eye.</summary>
    [Serializable]
    public struct FlockSettings
    {
        /// <summary>Only insects with the same number flock together; all keep apart.</summary>
        [Tooltip("Insects with the same number flock together; all keep apart.")]
        public int group;

        /// <summary>Speed without a pilot below, m/s, 0.05 to 5; 0.9.</summary>
        [Range(0.05f, 5f)]
        [Tooltip("Metres per second where no pilot stands below this one, 0.05 to 5; 0.9.")]
        public float speed;

        /// <summary>Distance up to which neighbours count, wing lengths, 1 to 200; 20.</summary>
        [Range(1f, 200f)]
        [Tooltip("Wing lengths up to which others are neighbours, 1 to 200; 20.")]
        public float sight;

        /// <summary>Distance to keep, wing lengths, 0.5 to 100; 5.</summary>
        [Range(0.5f, 100f)]
        [Tooltip("Wing lengths to keep from others, 0.5 to 100; 5.")]
        public float room;

        /// <summary>Weight of keeping apart, 0 to 4; 1.5.</summary>
        [Range(0f, 4f)]
        [Tooltip("How much the insect keeps apart, 0 to 4; 1.5.")]
        public float separation;

        /// <summary>Weight of flying as the neighbours fly, 0 to 1; 0.4.</summary>
        [Range(0f, 1f)]
        [Tooltip("How much the insect flies as its neighbours fly, 0 to 1; 0.4.")]
        public float alignment;

        /// <summary>Weight of flying to the middle of the neighbours, 0 to 2; 0.3.</summary>
        [Range(0f, 2f)]
        [Tooltip("How much the insect flies to the middle of its neighbours, 0 to 2; 0.3.")]
        public float cohesion;

        /// <summary>A loose swarm.</summary>
        public static FlockSettings Default => new FlockSettings
        {
            speed = 0.9f,
            sight = 20f,
            room = 5f,
            separation = 1.5f,
            alignment = 0.4f,
            cohesion = 0.3f,
        };

        /// <summary>Settings with every value moved into its range; what is no number is the default.</summary>
        internal FlockSettings Clamped()
        {
            FlockSettings none = Default, clamped = this;
            clamped.speed = NumberRange.Clamp(speed, 0.05f, 5f, none.speed);
            clamped.sight = NumberRange.Clamp(sight, 1f, 200f, none.sight);
            clamped.room = NumberRange.Clamp(room, 0.5f, 100f, none.room);
            clamped.separation = NumberRange.Clamp(separation, 0f, 4f, none.separation);
            clamped.alignment = NumberRange.Clamp(alignment, 0f, 1f, none.alignment);
            clamped.cohesion = NumberRange.Clamp(cohesion, 0f, 2f, none.cohesion);
            return clamped;
        }
    }
}
