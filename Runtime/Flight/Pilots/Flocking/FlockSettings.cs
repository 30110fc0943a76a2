using System;
using UnityEngine;

namespace Alate.Flight
{
    /// <summary>
    /// Settings of an insect's flight among others. Distances in wing lengths, so that one setting suits every species; all numbers are
    /// chosen for the eye.
    /// </summary>
    [Serializable]
    public struct FlockSettings
    {
        /// <summary>Only insects with the same number flock together; all keep apart.</summary>
        [Tooltip("Insects with the same number flock together; all keep apart.")]
        public int group;

        /// <summary>Speed without a pilot below, m/s, 0.05 to 5; 0.9.</summary>
        [Range(FlockBounds.Speed.Min, FlockBounds.Speed.Max)]
        [Tooltip("Metres per second where no pilot stands below this one; 0.9.")]
        public float speed;

        /// <summary>Distance up to which neighbours count, wing lengths, 1 to 200; 20.</summary>
        [Range(FlockBounds.Sight.Min, FlockBounds.Sight.Max)]
        [Tooltip("Wing lengths up to which others are neighbours; 20.")]
        public float sight;

        /// <summary>Distance to keep, wing lengths, 0.5 to 100; 5.</summary>
        [Range(FlockBounds.Room.Min, FlockBounds.Room.Max)]
        [Tooltip("Wing lengths to keep from others; 5.")]
        public float room;

        /// <summary>Weight of keeping apart, 0 to 4; 1.5.</summary>
        [Range(FlockBounds.Separation.Min, FlockBounds.Separation.Max)]
        [Tooltip("How much the insect keeps apart; 1.5.")]
        public float separation;

        /// <summary>Weight of flying as the neighbours fly, 0 to 1; 0.4.</summary>
        [Range(FlockBounds.Alignment.Min, FlockBounds.Alignment.Max)]
        [Tooltip("How much the insect flies as its neighbours fly; 0.4.")]
        public float alignment;

        /// <summary>Weight of flying to the middle of the neighbours, 0 to 2; 0.3.</summary>
        [Range(FlockBounds.Cohesion.Min, FlockBounds.Cohesion.Max)]
        [Tooltip("How much the insect flies to the middle of its neighbours; 0.3.")]
        public float cohesion;

        /// <summary>A loose swarm.</summary>
        public static FlockSettings Default => new FlockSettings
        {
            speed = FlockBounds.Speed.Default,
            sight = FlockBounds.Sight.Default,
            room = FlockBounds.Room.Default,
            separation = FlockBounds.Separation.Default,
            alignment = FlockBounds.Alignment.Default,
            cohesion = FlockBounds.Cohesion.Default,
        };

        /// <summary>Settings with every value moved into its range; what is no number is the default.</summary>
        internal FlockSettings Clamped()
        {
            FlockSettings none = Default, clamped = this;
            clamped.speed = NumberRange.Clamp(speed, FlockBounds.Speed.Min, FlockBounds.Speed.Max, none.speed);
            clamped.sight = NumberRange.Clamp(sight, FlockBounds.Sight.Min, FlockBounds.Sight.Max, none.sight);
            clamped.room = NumberRange.Clamp(room, FlockBounds.Room.Min, FlockBounds.Room.Max, none.room);
            clamped.separation = NumberRange.Clamp(separation, FlockBounds.Separation.Min, FlockBounds.Separation.Max, none.separation);
            clamped.alignment = NumberRange.Clamp(alignment, FlockBounds.Alignment.Min, FlockBounds.Alignment.Max, none.alignment);
            clamped.cohesion = NumberRange.Clamp(cohesion, FlockBounds.Cohesion.Min, FlockBounds.Cohesion.Max, none.cohesion);
            return clamped;
        }
    }

    /// <summary>Bounds and default of each number of <see cref="FlockSettings"/>, in its units.</summary>
    internal static class FlockBounds
    {
        public static class Speed { public const float Min = FlightPilot.LeastSpeed, Default = 0.9f, Max = FlightPilot.MostSpeed; }
        public static class Sight { public const float Min = 1f, Default = 20f, Max = 200f; }
        public static class Room { public const float Min = 0.5f, Default = 5f, Max = 100f; }
        public static class Separation { public const float Min = 0f, Default = 1.5f, Max = 4f; }
        public static class Alignment { public const float Min = 0f, Default = 0.4f, Max = 1f; }
        public static class Cohesion { public const float Min = 0f, Default = 0.3f, Max = 2f; }
    }
}
