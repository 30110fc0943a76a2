using System;
using UnityEngine;

namespace Alate.Flight
{
    /// <summary>A part of an insect's body as the flight sees it: an ellipsoid of even density.</summary>
    [Serializable]
    public struct BodyEllipsoid
    {
        /// <summary>Middle from the middle of the thorax, metres: X right, Y up, Z ahead.</summary>
        [Tooltip("Metres from the middle of the thorax: X right, Y up, Z ahead.")]
        public Vector3 centre;

        /// <summary>Half axes, metres, above 0.</summary>
        [Tooltip("Half axes, metres.")]
        public Vector3 halfAxes;

        /// <summary>Share of the body's mass without wings; shares are weighed against their sum.</summary>
        [Tooltip("Share of the body's mass without wings.")]
        public float share;

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
            new BodyEllipsoid { centre = size * centre, halfAxes = size * halfAxes, share = share };
    }
}
