using System;
using UnityEngine;

namespace Alate.Flight
{
    /// <summary>
    /// Numbers of an erratic track. Butterflies that look for food fly slow loops, at 1.6 m/s on average, and fast straight stretches between, at 2.9 m/s (Cant et al.
    /// 2005, by harmonic radar); a random walk that keeps part of its course and is drawn back to its ground describes both (Crone and Schultz 2008; Schtickzelle et al.
    /// 2007). Times and angles of turns differ with how often a track was sampled: ours are chosen.
    /// </summary>
    [Serializable]
    public struct WanderSettings
    {
        /// <summary>Mean speed, m/s, 0.05 to 5; 1. Limited by what the insect can do.</summary>
        [Range(0.05f, 5f)]
        [Tooltip("Metres per second on average, 0.05 to 5; 1. The insect's own limits hold besides.")]
        public float speed;

        /// <summary>Mean time between turns, seconds, 0.1 to 20; 0.7.</summary>
        [Range(0.1f, 20f)]
        [Tooltip("Seconds between two turns on average, 0.1 to 20; 0.7. More flies straighter.")]
        public float straightTime;

        /// <summary>Spread of the turns (standard deviation), degrees, 0 to 180; 55.</summary>
        [Range(0f, 180f)]
        [Tooltip("Degrees by which a turn differs from straight on (standard deviation), 0 to 180; 55. 0 flies straight on.")]
        public float turnSpread;

        /// <summary>Pull of the course towards the middle of the volume, 0 to 1; 0.25.</summary>
        [Range(0f, 1f)]
        [Tooltip("How much each turn favours the middle of the volume, 0 to 1; 0.25. 0 leaves it to the rim to turn the insect.")]
        public float homing;

        /// <summary>Climb and descent (standard deviation), m/s, 0 to 1; 0.25.</summary>
        [Range(0f, 1f)]
        [Tooltip("Metres per second of climbing and sinking (standard deviation), 0 to 1; 0.25.")]
        public float bob;

        /// <summary>Time in which climbing changes to sinking, seconds, 0.1 to 10; 0.6: several beats.</summary>
        [Range(0.1f, 10f)]
        [Tooltip("Seconds in which climbing turns into sinking, 0.1 to 10; 0.6.")]
        public float bobTime;

        /// <summary>A butterfly that looks for food.</summary>
        public static WanderSettings Default => new WanderSettings
        {
            speed = 1f,
            straightTime = 0.7f,
            turnSpread = 55f,
            homing = 0.25f,
            bob = 0.25f,
            bobTime = 0.6f,
        };

        /// <summary>Settings with every value moved into its range; what is no number is the default.</summary>
        internal WanderSettings Clamped() => new WanderSettings
        {
            speed = NumberRange.Clamp(speed, 0.05f, 5f, Default.speed),
            straightTime = NumberRange.Clamp(straightTime, 0.1f, 20f, Default.straightTime),
            turnSpread = NumberRange.Clamp(turnSpread, 0f, 180f, Default.turnSpread),
            homing = NumberRange.Clamp(homing, 0f, 1f, Default.homing),
            bob = NumberRange.Clamp(bob, 0f, 1f, Default.bob),
            bobTime = NumberRange.Clamp(bobTime, 0.1f, 10f, Default.bobTime),
        };
    }
}
