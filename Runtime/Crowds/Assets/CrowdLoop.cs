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

        /// <summary>Differences of the beat from the preset's.</summary>
        public InsectSteering steering;

        /// <summary>Difference of the amplitudes of both sides over their sum; positive beats the left side harder.</summary>
        public float roll;

        /// <summary>
        /// Rotation of the body out of its heading: its pitch, and its bank in a turn. A pose that looks ahead is heading times attitude.
        /// </summary>
        public Quaternion attitude;

        /// <summary>Angular velocity of the body in its own axes, radians a second.</summary>
        public Vector3 angularVelocity;

        /// <summary>True where the loop was flown by trims, with the two beats below instead of steering and roll.</summary>
        public bool isFlown;

        /// <summary>Beats of the right and of the left wings.</summary>
        public WingDrive rightBeat, leftBeat;

        /// <summary>Largest distance from the flown wings between two frames, wing lengths.</summary>
        public float error;
    }
}
