using Unity.Mathematics;

namespace Alate
{
    /// <summary>Middle of the stroke and tilt of four wings now, with their derivatives per radian of Φ; lane = wing.</summary>
    internal struct StrokeMeans
    {
        /// <summary>Sine and cosine of the turn about +X, which is nose down: minus the tilt.</summary>
        public float4 tiltSin, tiltCos;

        /// <summary>Sine and cosine of half of it.</summary>
        public float4 tiltHalfSin, tiltHalfCos;

        /// <summary>Derivatives of the turn about +X.</summary>
        public float4 tiltRate, tiltCurvature;

        /// <summary>Means of flap, sweep and feather, radians, and their derivatives.</summary>
        public SoaFloat3 angle, rate, curvature;
    }
}
