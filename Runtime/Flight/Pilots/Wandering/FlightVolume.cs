using System;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Flight
{
    /// <summary>A part of the world in which an insect stays, world units.</summary>
    [Serializable]
    public struct FlightVolume
    {
        /// <summary>Least size along an axis, world units.</summary>
        private const float k_LeastSize = 1e-3f;

        /// <summary>Room at the rim for what the body flies besides its reference: metres, and at most a share of half the size.</summary>
        private const float k_Margin = 0.1f, k_MarginShare = 0.25f;

        /// <summary>Seconds that are looked ahead along a rim that bends inwards.</summary>
        private const float k_Ahead = 0.3f;

        /// <summary>Box or ellipsoid, along the world's axes.</summary>
        [Tooltip("Box or ellipsoid, along the world's axes.")]
        public VolumeShape shape;

        /// <summary>The middle, world units.</summary>
        [Tooltip("The middle, world units.")]
        public Vector3 centre;

        /// <summary>Size from side to side along each axis, world units.</summary>
        [Tooltip("Size from side to side along each axis, world units.")]
        public Vector3 size;

        /// <param name="shape">Box or ellipsoid.</param>
        /// <param name="centre">The middle, world units.</param>
        /// <param name="size">From side to side, world units.</param>
        public FlightVolume(VolumeShape shape, Vector3 centre, Vector3 size)
        {
            this.shape = shape;
            this.centre = centre;
            this.size = size;
        }

        private float3 Half => 0.5f * math.max(math.abs((float3)size), k_LeastSize);

        /// <summary>Returns true where a point, world units, lies within.</summary>
        public bool Contains(float3 point)
        {
            float3 place = (point - (float3)centre) / Half;
            return shape == VolumeShape.Box ? math.cmax(math.abs(place)) <= 1f : math.lengthsq(place) <= 1f;
        }

        /// <summary>
        /// A velocity, m/s, without what would carry an insect out: towards the rim no faster than it can stop before; back in where it is
        /// outside.
        /// </summary>
        /// <param name="velocity">Wanted, m/s.</param>
        /// <param name="point">Where the insect is, world units.</param>
        /// <param name="limits">What the insect can do.</param>
        /// <param name="unitsPerMetre">World units of a metre of the insect.</param>
        public float3 Hold(float3 velocity, float3 point, in FlightLimits limits, float unitsPerMetre)
        {
            float3 place = point - (float3)centre;
            float margin = math.min(k_Margin, k_MarginShare * math.cmin(Half) / unitsPerMetre);
            if (shape == VolumeShape.Ellipsoid)
            {
                velocity = BrakeRound(velocity, place, margin, limits, unitsPerMetre);
                return BrakeRound(velocity, place + k_Ahead * unitsPerMetre * velocity, margin, limits, unitsPerMetre);
            }

            for (int axis = 0; axis < 3; axis++)
            {
                float3 outward = default;
                outward[axis] = place[axis] < 0f ? -1f : 1f;
                velocity = Brake(velocity, outward, (Half[axis] - math.abs(place[axis])) / unitsPerMetre - margin, limits);
            }

            return velocity;
        }

        private float3 BrakeRound(float3 velocity, float3 place, float margin, in FlightLimits limits, float unitsPerMetre)
        {
            float3 outward = math.normalizesafe(place / (Half * Half));
            float share = math.length(place / Half);
            float left = share > 1e-6f
                ? math.length(place) * (1f / share - 1f) * math.dot(math.normalizesafe(place), outward)
                : math.cmin(Half);
            return Brake(velocity, outward, left / unitsPerMetre - margin, limits);
        }

        private static float3 Brake(float3 velocity, float3 outward, float left, in FlightLimits limits)
        {
            float speed = math.dot(velocity, outward);
            float most = left >= 0f ? limits.SpeedToStopWithin(left) : -math.min(limits.SpeedToStopWithin(-left), 0.5f * limits.TopSpeed);
            return speed > most ? velocity - (speed - most) * outward : velocity;
        }
    }
}
