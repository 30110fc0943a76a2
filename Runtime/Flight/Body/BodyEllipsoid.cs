using System;
using UnityEngine;

namespace Alate.Flight
{
    /// <summary>A part of an insect's body as the flight sees it: an ellipsoid of even density.</summary>
    [Serializable]
    public struct BodyEllipsoid
    {
        /// <summary>Largest half of a swing, degrees.</summary>
        internal const float MostSwing = 45f;

        /// <summary>Middle from the middle of the thorax, metres: X right, Y up, Z ahead.</summary>
        [Tooltip("Metres from the middle of the thorax: X right, Y up, Z ahead.")]
        public Vector3 centre;

        /// <summary>Half axes, metres, above 0.</summary>
        [Tooltip("Half axes, metres.")]
        public Vector3 halfAxes;

        /// <summary>Share of the body's mass without wings; shares are weighed against their sum.</summary>
        [Tooltip("Share of the body's mass without wings.")]
        public float share;

        /// <summary>
        /// Half of the swing up and down about its front end with every beat, degrees, 0 to 45; of one part, the abdomen. 0 holds it. It
        /// is shown, and with <see cref="ModelOptions.bodyReaction"/> its inertia moves the body.
        /// </summary>
        [Tooltip("Half of the swing up and down about its front end with every beat, degrees: of the abdomen. 0 holds it.")]
        public float swing;

        /// <summary>Phase of the beat in which a part that swings hangs lowest, degrees: 0 where the wings are up.</summary>
        [Tooltip("Phase of the beat in which a part that swings hangs lowest, degrees: 0 where the wings are up.")]
        public float lowestPhase;

        /// <summary>Ellipsoid in millimetres.</summary>
        public static BodyEllipsoid Millimetres(
            double x, double y, double z, double a, double b, double c, double share) => new BodyEllipsoid
            {
                centre = new Vector3((float)(1e-3 * x), (float)(1e-3 * y), (float)(1e-3 * z)),
                halfAxes = new Vector3((float)(1e-3 * a), (float)(1e-3 * b), (float)(1e-3 * c)),
                share = (float)share,
            };

        /// <summary>The ellipsoid in an insect of another size.</summary>
        internal BodyEllipsoid Scaled(float size) =>
            new BodyEllipsoid
            {
                centre = size * centre,
                halfAxes = size * halfAxes,
                share = share,
                swing = swing,
                lowestPhase = lowestPhase,
            };

        /// <summary>The ellipsoid, swinging with the beat.</summary>
        /// <param name="degrees">Half of the swing.</param>
        /// <param name="lowest">Phase in which it hangs lowest, degrees.</param>
        internal BodyEllipsoid Swinging(float degrees, float lowest)
        {
            BodyEllipsoid swinging = this;
            swinging.swing = degrees;
            swinging.lowestPhase = lowest;
            return swinging;
        }

        /// <summary>Front end, about which a part swings, metres from the middle of the thorax.</summary>
        internal readonly Vector3 Hinge => centre + new Vector3(0f, 0f, halfAxes.z);
    }
}
