using System;
using UnityEngine;

namespace Alate.Flight
{
    /// <summary>
    /// Settings of when an insect lands, how long it stays, and what it does there. Times are chosen; each stay and flight lasts between
    /// half and one and a half times as long.
    /// </summary>
    [Serializable]
    public struct PerchSettings
    {
        /// <summary>Mean time between landings, seconds, 0 to 600; 10.</summary>
        [Range(PerchBounds.FlightTime.Min, PerchBounds.FlightTime.Max)]
        [Tooltip("Seconds of flight between landings on average; 10.")]
        public float flightTime;

        /// <summary>Mean time on a spot, seconds, 0.5 to 600; 8.</summary>
        [Range(PerchBounds.StayTime.Min, PerchBounds.StayTime.Max)]
        [Tooltip("Seconds on a spot on average; 8.")]
        public float stayTime;

        /// <summary>Seconds to fold the wings, 0.1 to 5; 0.5.</summary>
        [Range(PerchBounds.FoldTime.Min, PerchBounds.FoldTime.Max)]
        [Tooltip("Seconds to fold the wings, or to open them wholly while basking; 0.5.")]
        public float foldTime;

        /// <summary>Share of the fold that the wings open while the insect basks, 0 to 1; 0.7. 0 keeps them folded.</summary>
        [Range(PerchBounds.Bask.Min, PerchBounds.Bask.Max)]
        [Tooltip("How far the wings open while the insect basks; 0.7. 0 keeps them folded.")]
        public float bask;

        /// <summary>Openings a minute, 0 to 60; 12. 0 keeps the wings still: folded, or open where the insect basks.</summary>
        [Range(PerchBounds.FanRate.Min, PerchBounds.FanRate.Max)]
        [Tooltip("How often a minute the wings open and close slowly; 12. 0 keeps them still.")]
        public float fanRate;

        /// <summary>Distance within which a spot is looked for, world units, 0.1 to 1000; 30.</summary>
        [Range(PerchBounds.SearchDistance.Min, PerchBounds.SearchDistance.Max)]
        [Tooltip("World units within which spots are looked for; 30.")]
        public float searchDistance;

        /// <summary>True where surfaces below are spots too, beside marked ones; needs colliders.</summary>
        [Tooltip("Whether the insect lands on colliders below it too, beside marked spots.")]
        public bool landsOnSurfaces;

        /// <summary>Layers of the colliders to land on.</summary>
        [Tooltip("Layers of the colliders to land on.")]
        public LayerMask surfaces;

        /// <summary>Steepest surface to land on, degrees, 0 to 90; 45.</summary>
        [Range(PerchBounds.Steepest.Min, PerchBounds.Steepest.Max)]
        [Tooltip("Degrees of the steepest surface to land on; 45.")]
        public float steepest;

        /// <summary>
        /// Distance of something watched at which the insect takes off, and within which it flies away from it, world units, 0 to 1000; 5.
        /// 0 watches nothing.
        /// </summary>
        [Range(PerchBounds.FleeDistance.Min, PerchBounds.FleeDistance.Max)]
        [Tooltip("World units: the insect takes off and flies away when something watched comes nearer; 5. 0 watches nothing.")]
        public float fleeDistance;

        /// <summary>True where an insect that sits takes off when something other than its perch touches it; needs colliders.</summary>
        [Tooltip("Whether the insect takes off when a collider other than its perch touches its own. Give it one, and a Rigidbody to "
            + "it or to what touches it.")]
        public bool leavesWhenTouched;

        /// <summary>A butterfly on flowers.</summary>
        public static PerchSettings Default => new PerchSettings
        {
            flightTime = PerchBounds.FlightTime.Default,
            stayTime = PerchBounds.StayTime.Default,
            foldTime = PerchBounds.FoldTime.Default,
            bask = PerchBounds.Bask.Default,
            fanRate = PerchBounds.FanRate.Default,
            searchDistance = PerchBounds.SearchDistance.Default,
            surfaces = Physics.DefaultRaycastLayers,
            steepest = PerchBounds.Steepest.Default,
            fleeDistance = PerchBounds.FleeDistance.Default,
            leavesWhenTouched = true,
        };

        /// <summary>Settings with every value moved into its range; what is no number is the default.</summary>
        internal PerchSettings Clamped()
        {
            PerchSettings none = Default, clamped = this;
            clamped.flightTime = NumberRange.Clamp(flightTime, PerchBounds.FlightTime.Min, PerchBounds.FlightTime.Max, none.flightTime);
            clamped.stayTime = NumberRange.Clamp(stayTime, PerchBounds.StayTime.Min, PerchBounds.StayTime.Max, none.stayTime);
            clamped.foldTime = NumberRange.Clamp(foldTime, PerchBounds.FoldTime.Min, PerchBounds.FoldTime.Max, none.foldTime);
            clamped.bask = NumberRange.Clamp(bask, PerchBounds.Bask.Min, PerchBounds.Bask.Max, none.bask);
            clamped.fanRate = NumberRange.Clamp(fanRate, PerchBounds.FanRate.Min, PerchBounds.FanRate.Max, none.fanRate);
            clamped.searchDistance = NumberRange.Clamp(
                searchDistance, PerchBounds.SearchDistance.Min, PerchBounds.SearchDistance.Max, none.searchDistance);
            clamped.steepest = NumberRange.Clamp(steepest, PerchBounds.Steepest.Min, PerchBounds.Steepest.Max, none.steepest);
            clamped.fleeDistance = NumberRange.Clamp(
                fleeDistance, PerchBounds.FleeDistance.Min, PerchBounds.FleeDistance.Max, none.fleeDistance);
            return clamped;
        }
    }

    /// <summary>Bounds and default of each number of <see cref="PerchSettings"/>, in its units.</summary>
    internal static class PerchBounds
    {
        public static class FlightTime { public const float Min = 0f, Default = 10f, Max = 600f; }
        public static class StayTime { public const float Min = 0.5f, Default = 8f, Max = 600f; }
        public static class FoldTime { public const float Min = 0.1f, Default = 0.5f, Max = 5f; }
        public static class Bask { public const float Min = 0f, Default = 0.7f, Max = 1f; }
        public static class FanRate { public const float Min = 0f, Default = 12f, Max = 60f; }
        public static class SearchDistance { public const float Min = 0.1f, Default = 30f, Max = 1000f; }
        public static class Steepest { public const float Min = 0f, Default = 45f, Max = 90f; }
        public static class FleeDistance { public const float Min = 0f, Default = 5f, Max = 1000f; }
    }
}
