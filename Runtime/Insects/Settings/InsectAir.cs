using System;
using UnityEngine;

namespace Alate
{
    /// <summary>The wind around an insect.</summary>
    [Serializable]
    public struct InsectAir
    {
        /// <summary>Steady wind, world units per second.</summary>
        [Tooltip("Steady wind, world units per second, world axes; 0 is still air. It counts like flight the other way.")]
        public Vector3 wind;

        /// <summary>True where Unity's wind zones blow on the wings too.</summary>
        [Tooltip("Adds the scene's WindZones: their main wind, pulses and turbulence, in world units per second.")]
        public bool windZones;

        /// <summary>Default settings: still air, wind zones felt.</summary>
        public static InsectAir Default => new InsectAir { windZones = true };
    }
}
