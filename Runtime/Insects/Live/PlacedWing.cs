using Unity.Mathematics;
using UnityEngine;

namespace Alate
{
    /// <summary>
    /// Frame of a wing in the world. Of a transform with unequal scales or shear the span's direction is kept, up is made perpendicular to
    /// it, and forward to both: the wing is computed as the closest rigid wing, and drawn with the transform's scale.
    /// </summary>
    internal readonly struct PlacedWing
    {
        /// <summary>Length below which a wing has no direction, world units.</summary>
        private const float k_LeastLength = 1e-6f;

        /// <summary>Axes of the wing, unit vectors at right angles, world; a mirror image for wings of the left side.</summary>
        public readonly float3 span, up, forward;

        /// <summary>Wing length, world units.</summary>
        public readonly float length;

        /// <summary>Position of the hinge, world.</summary>
        public readonly float3 hinge;

        /// <summary>False where the scale leaves no span, no width or no direction.</summary>
        public readonly bool isValid;

        /// <summary>Finds the axes of a wing whose mesh is drawn by a matrix.</summary>
        public PlacedWing(in Matrix4x4 meshToWorld, in WingFrame frame)
        {
            float3 drawnSpan = meshToWorld.MultiplyVector(frame.axes.c0);
            float3 drawnUp = meshToWorld.MultiplyVector(frame.axes.c1);
            float3 drawnForward = meshToWorld.MultiplyVector(frame.axes.c2);
            hinge = meshToWorld.MultiplyPoint3x4(frame.origin);
            length = math.length(drawnSpan) * frame.length;

            span = math.normalizesafe(drawnSpan);
            // A flat mesh that is scaled to nothing across its surface is still a wing: its normal is that of what is left, on the side on
            // which the frame has it.
            float3 across = math.cross(drawnForward, drawnSpan);
            float side = math.dot(across, drawnUp);
            if (side == 0f)
                side = math.dot(math.cross(frame.axes.c2, frame.axes.c0), frame.axes.c1);
            up = math.normalizesafe(math.sign(side) * across);
            float3 third = math.cross(span, up);
            forward = math.dot(third, drawnForward) < 0f ? -third : third;
            isValid = length > k_LeastLength && math.lengthsq(up) > 0.5f && math.all(math.isfinite(hinge)) && math.isfinite(length);
        }

        /// <summary>Converts a vector of the world to wing axes, in world units.</summary>
        public float3 ToWing(float3 world) => new float3(math.dot(span, world), math.dot(up, world), math.dot(forward, world));

        /// <summary>
        /// Converts an axis of turning (an angular velocity, a moment) of the world to wing axes: in a mirror image an axis keeps its
        /// direction where a vector is turned round.
        /// </summary>
        public float3 AxisToWing(float3 world) => ToWing(world) * Handedness;

        /// <summary>Converts an axis of turning in wing axes to the world.</summary>
        public float3 AxisToWorld(float3 wing) => ToWorld(wing) * Handedness;

        // 1 for a right wing's axes, −1 for their mirror image.
        private float Handedness => math.dot(math.cross(span, up), forward) < 0f ? -1f : 1f;

        /// <summary>Converts a vector in wing axes to the world.</summary>
        public float3 ToWorld(float3 wing) => span * wing.x + up * wing.y + forward * wing.z;
    }
}
