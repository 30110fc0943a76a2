using System;
using UnityEngine;

namespace Alate.Flight
{
    /// <summary>
    /// Numbers of an erratic track. Butterflies that look for food fly slow loops, at 1.6 m/s on average, and fast straight stretches
    /// between, at 2.9 m/s (Cant et al. 2005, by harmonic radar); a random walk that keeps part of its course and is drawn back to its
    /// ground describes both (Crone and Schultz 2008; Schtickzelle et al. 2007). Times and angles of turns differ with how often a track
    /// was sampled: ours are chosen.
    /// </summary>
    [Serializable]
    public struct WanderSettings
    {
        /// <summary>Mean speed, m/s, 0.05 to 5; 1. Limited by what the insect can do.</summary>
        [Range(WanderBounds.Speed.Min, WanderBounds.Speed.Max)]
        [Tooltip("Metres per second on average; 1. The insect's own limits hold besides.")]
        public float speed;

        /// <summary>Mean time between turns, seconds, 0.1 to 20; 0.7.</summary>
        [Range(WanderBounds.StraightTime.Min, WanderBounds.StraightTime.Max)]
        [Tooltip("Seconds between two turns on average; 0.7. More flies straighter.")]
        public float straightTime;

        /// <summary>Spread of the turns (standard deviation), degrees, 0 to 180; 55.</summary>
        [Range(WanderBounds.TurnSpread.Min, WanderBounds.TurnSpread.Max)]
        [Tooltip("Degrees by which a turn differs from straight on (standard deviation); 55. 0 flies straight on.")]
        public float turnSpread;

        /// <summary>Pull of the course towards the middle of the volume, 0 to 1; 0.25.</summary>
        [Range(WanderBounds.Homing.Min, WanderBounds.Homing.Max)]
        [Tooltip("How much each turn favours the middle of the volume; 0.25. 0 leaves it to the rim to turn the insect.")]
        public float homing;

        /// <summary>Climb and descent (standard deviation), m/s, 0 to 1; 0.25.</summary>
        [Range(WanderBounds.Bob.Min, WanderBounds.Bob.Max)]
        [Tooltip("Metres per second of climbing and sinking (standard deviation); 0.25.")]
        public float bob;

        /// <summary>Time in which climbing changes to sinking, seconds, 0.1 to 10; 0.6: several beats.</summary>
        [Range(WanderBounds.BobTime.Min, WanderBounds.BobTime.Max)]
        [Tooltip("Seconds in which climbing turns into sinking; 0.6.")]
        public float bobTime;

        /// <summary>
        /// Liveliness of the track, 0 to 1; 0. At 1 the insect turns as fast as it can, after half the time and by 1.3 times the spread,
        /// and changes its speed all the time: butterflies pay for it with a fifth of their power and more.
        /// </summary>
        [Range(WanderBounds.Erratic.Min, WanderBounds.Erratic.Max)]
        [Tooltip("0 is calm, the default. 1 turns as fast as the insect can, twice as often, and changes speed all the time.")]
        public float erratic;

        /// <summary>A butterfly that looks for food.</summary>
        public static WanderSettings Default => new WanderSettings
        {
            speed = WanderBounds.Speed.Default,
            straightTime = WanderBounds.StraightTime.Default,
            turnSpread = WanderBounds.TurnSpread.Default,
            homing = WanderBounds.Homing.Default,
            bob = WanderBounds.Bob.Default,
            bobTime = WanderBounds.BobTime.Default,
            erratic = WanderBounds.Erratic.Default,
        };

        /// <summary>Settings with every value moved into its range; what is no number is the default.</summary>
        internal WanderSettings Clamped() => new WanderSettings
        {
            speed = NumberRange.Clamp(speed, WanderBounds.Speed.Min, WanderBounds.Speed.Max, Default.speed),
            straightTime = NumberRange.Clamp(
                straightTime, WanderBounds.StraightTime.Min, WanderBounds.StraightTime.Max, Default.straightTime),
            turnSpread = NumberRange.Clamp(turnSpread, WanderBounds.TurnSpread.Min, WanderBounds.TurnSpread.Max, Default.turnSpread),
            homing = NumberRange.Clamp(homing, WanderBounds.Homing.Min, WanderBounds.Homing.Max, Default.homing),
            bob = NumberRange.Clamp(bob, WanderBounds.Bob.Min, WanderBounds.Bob.Max, Default.bob),
            bobTime = NumberRange.Clamp(bobTime, WanderBounds.BobTime.Min, WanderBounds.BobTime.Max, Default.bobTime),
            erratic = NumberRange.Clamp(erratic, WanderBounds.Erratic.Min, WanderBounds.Erratic.Max, Default.erratic),
        };
    }

    /// <summary>Bounds and default of each number of <see cref="WanderSettings"/>, in its units.</summary>
    internal static class WanderBounds
    {
        public static class Speed { public const float Min = FlightPilot.LeastSpeed, Default = 1f, Max = FlightPilot.MostSpeed; }
        public static class StraightTime { public const float Min = 0.1f, Default = 0.7f, Max = 20f; }
        public static class TurnSpread { public const float Min = 0f, Default = 55f, Max = 180f; }
        public static class Homing { public const float Min = 0f, Default = 0.25f, Max = 1f; }
        public static class Bob { public const float Min = 0f, Default = 0.25f, Max = 1f; }
        public static class BobTime { public const float Min = 0.1f, Default = 0.6f, Max = 10f; }
        public static class Erratic { public const float Min = 0f, Default = 0f, Max = 1f; }
    }
}
