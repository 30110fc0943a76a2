using System;
using UnityEngine;

namespace Alate.Flight
{
    /// <summary>Settings by which a pilot avoids colliders in its way.</summary>
    [Serializable]
    public struct ObstacleSettings
    {
        private const float k_LeastClearance = 0f, k_Clearance = 1.5f, k_MostClearance = 20f;

        /// <summary>True where obstacles are avoided; needs colliders.</summary>
        [Tooltip("Whether the insect looks for colliders in its way and flies round them.")]
        public bool avoid;

        /// <summary>Layers of the colliders that are obstacles.</summary>
        [Tooltip("Layers of the colliders that are obstacles. Leave out the insect's own.")]
        public LayerMask layers;

        /// <summary>Distance to keep from a surface, wing lengths, 0 to 20; 1.5.</summary>
        [Range(k_LeastClearance, k_MostClearance)]
        [Tooltip("Wing lengths to keep from a surface; 1.5.")]
        public float clearance;

        /// <summary>All layers that rays meet, 1.5 wing lengths away.</summary>
        public static ObstacleSettings Default =>
            new ObstacleSettings { avoid = true, layers = Physics.DefaultRaycastLayers, clearance = k_Clearance };

        /// <summary>Distance to keep, metres of the insect.</summary>
        internal float Metres(float wingLength) =>
            NumberRange.Clamp(clearance, k_LeastClearance, k_MostClearance, k_Clearance) * wingLength;
    }
}
