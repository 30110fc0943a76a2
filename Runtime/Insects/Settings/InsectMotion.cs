using System;
using Unity.Mathematics;
using UnityEngine;

namespace Alate
{
    /// <summary>Source of an insect's own motion, and the response to jumps.</summary>
    [Serializable]
    public struct InsectMotion
    {
        private const float k_LeastMetres = 1e-6f, k_MostMetres = 1000f;
        private const float k_LeastDistance = 1f, k_MostDistance = 10000f, k_LeastAngle = 10f, k_MostAngle = 180f;

        /// <summary>Source of the velocity.</summary>
        [Tooltip("Where the body's velocity comes from. Transform: from how it moves. Rigidbody: from its physics. Script: from "
            + "InsectWings.Velocity.")]
        public VelocitySource source;

        /// <summary>Rigidbody for <see cref="VelocitySource.Rigidbody"/>; null finds the nearest above.</summary>
        [Tooltip("The body that carries the insect. None: the nearest one at or above this object.")]
        public Rigidbody body;

        /// <summary>
        /// Metres of real flight that one world unit stands for, 0 to 1000; 0, or less than a millionth, takes the wing's own size in the
        /// scene for life size.
        /// </summary>
        [Tooltip("Metres of real flight that one world unit stands for, 0 to 1000. 0: an insect drawn ten times life size that moves 10 "
            + "units a second flies at 1 m/s. 1: units are metres, whatever the insect's size.")]
        public float metresPerUnit;

        /// <summary>Response to jumps.</summary>
        [Tooltip("What happens when the insect jumps to another place. Keep: the wings beat on. Reset: they start over. Ignore: they feel "
            + "the jump as wind.")]
        public TeleportResponse onTeleport;

        /// <summary>Wing lengths of one frame's unexplained move from which on it is a jump, 1 to 10000.</summary>
        [Range(k_LeastDistance, k_MostDistance)]
        [Tooltip("Wing lengths of an unexplained move in one frame that make it a jump, 1 to 10000; 25. Lower catches short teleports, but "
            + "also sudden starts.")]
        public float teleportDistance;

        /// <summary>Degrees of one frame's unexplained turn from which on it is a jump, 10 to 180.</summary>
        [Range(k_LeastAngle, k_MostAngle)]
        [Tooltip("Degrees of an unexplained turn in one frame that make it a jump, 10 to 180; 100. At 180 turns are never jumps.")]
        public float teleportAngle;

        /// <summary>
        /// Default settings: motion of the transform, life size by the wing's own size, jumps of 25 wing lengths or 100 degrees kept.
        /// </summary>
        public static InsectMotion Default => new InsectMotion { teleportDistance = 25f, teleportAngle = 100f };

        internal InsectMotion Clamped()
        {
            InsectMotion clamped = this;
            InsectMotion usual = Default;
            bool isScale = math.isfinite(metresPerUnit) && metresPerUnit >= k_LeastMetres;
            clamped.metresPerUnit = isScale ? math.min(metresPerUnit, k_MostMetres) : usual.metresPerUnit;
            clamped.teleportDistance = math.isfinite(teleportDistance)
                ? math.clamp(teleportDistance, k_LeastDistance, k_MostDistance)
                : usual.teleportDistance;
            clamped.teleportAngle = math.isfinite(teleportAngle)
                ? math.clamp(teleportAngle, k_LeastAngle, k_MostAngle)
                : usual.teleportAngle;
            return clamped;
        }
    }
}
