using System;
using UnityEngine;

namespace Alate.Crowds
{
    /// <summary>A loop in a baked insect's texture, and how the live insect flies it.</summary>
    [Serializable]
    public struct CrowdLoop
    {
        /// <summary>Name of the motion.</summary>
        public string name;

        /// <summary>First row.</summary>
        public int firstFrame;

        /// <summary>Rows; the last is followed by the first.</summary>
        public int frames;

        /// <summary>Loops a second.</summary>
        public float frequency;

        /// <summary>Velocity of the body, units of the insect's space per second, in its own axes.</summary>
        public Vector3 velocity;

        /// <summary>How the beat differs from the preset's.</summary>
        public InsectSteering steering;

        /// <summary>Largest distance from the flown wings between two frames, wing lengths.</summary>
        public float error;
    }
}
