using System;
using UnityEngine;

namespace Alate.Flight
{
    /// <summary>Settings of when an insect lands, how long it stays, and what it does there. Times are chosen; each stay and flight lasts between half and one and a half times as long.</summary>
    [Serializable]
    public struct PerchSettings
    {
        /// <summary>Mean time between landings, seconds, 0 to 600; 10.</summary>
        [Range(0f, 600f)]
        [Tooltip("Seconds of flight between landings on average, 0 to 600; 10.")]
        public float flightTime;

        /// <summary>Mean time on a spot, seconds, 0.5 to 600; 8.</summary>
        [Range(0.5f, 600f)]
        [Tooltip("Seconds on a spot on average, 0.5 to 600; 8.")]
        public float stayTime;

        /// <summary>Seconds to fold the wings, 0.1 to 5; 0.5.</summary>
        [Range(0.1f, 5f)]
        [Tooltip("Seconds to fold or spread the wings, 0.1 to 5; 0.5.")]
        public float foldTime;

        /// <summary>Share of the fold that the wings open while the insect basks, 0 to 1; 0.7. 0 keeps them folded.</summary>
        [Range(0f, 1f)]
        [Tooltip("How far the wings open while the insect basks, 0 to 1; 0.7. 0 keeps them folded.")]
        public float bask;

        /// <summary>Openings a minute, 0 to 60; 12. 0 keeps the wings still: folded, or open where the insect basks.</summary>
        [Range(0f, 60f)]
        [Tooltip("How often a minute the wings open and close slowly, 0 to 60; 12. 0 keeps them still.")]
        public float fanRate;

        /// <summary>Distance within which a spot is looked for, world units, 0.1 to 1000; 30.</summary>
        [Range(0.1f, 1000f)]
        [Tooltip("World units within which spots are looked for, 0.1 to 1000; 30.")]
        public float searchDistance;

        /// <summary>True where surfaces below are spots too, beside marked ones; needs colliders.</summary>
        [Tooltip("Whether the insect lands on colliders below it too, beside marked spots.")]
        public bool landsOnSurfaces;

        /// <summary>Layers of the colliders to land on.</summary>
        [Tooltip("Layers of the colliders to land on.")]
        public LayerMask surfaces;

        /// <summary>Steepest surface to land on, degrees, 0 to 90; 45.</summary>
        [Range(0f, 90f)]
        [Tooltip("Degrees of the steepest surface to land on, 0 to 90; 45.")]
        public float steepest;

        /// <summary>Distance of something watched at which the insect takes off, world units, 0 to 1000; 5. 0 watches nothing.</summary>
        [Range(0f, 1000f)]
        [Tooltip("World units: the insect takes off when something watched comes nearer; 5. 0 watches nothing.")]
        public float fleeDistance;

        /// <summary>A butterfly on flowers.</summary>
        public static PerchSettings Default => new PerchSettings
        {
            flightTime = 10f,
            stayTime = 8f,
            foldTime = 0.5f,
            bask = 0.7f,
            fanRate = 12f,
            searchDistance = 30f,
            surfaces = Physics.DefaultRaycastLayers,
            steepest = 45f,
            fleeDistance = 5f,
        };

        /// <summary>Settings with every value moved into its range; what is no number is the default.</summary>
        internal PerchSettings Clamped()
        {
            PerchSettings none = Default, clamped = this;
            clamped.flightTime = NumberRange.Clamp(flightTime, 0f, 600f, none.flightTime);
            clamped.stayTime = NumberRange.Clamp(stayTime, 0.5f, 600f, none.stayTime);
            clamped.foldTime = NumberRange.Clamp(foldTime, 0.1f, 5f, none.foldTime);
            clamped.bask = NumberRange.Clamp(bask, 0f, 1f, none.bask);
            clamped.fanRate = NumberRange.Clamp(fanRate, 0f, 60f, none.fanRate);
            clamped.searchDistance = NumberRange.Clamp(searchDistance, 0.1f, 1000f, none.searchDistance);
            clamped.steepest = NumberRange.Clamp(steepest, 0f, 90f, none.steepest);
            clamped.fleeDistance = NumberRange.Clamp(fleeDistance, 0f, 1000f, none.fleeDistance);
            return clamped;
        }
    }
}
