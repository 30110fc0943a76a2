using Unity.Mathematics;
using UnityEngine.Scripting.APIUpdating;

namespace Alate
{
    /// <summary>
    /// The frame in which a wing is computed: origin at the hinge, X to the tip, Y up, Z forward, one wing length long. For a left
    /// wing the axes are a mirror image, so that every wing is computed as a right one.
    /// </summary>
    [MovedFrom(true, null, "Alate")]
    public readonly struct WingFrame
    {
        /// <summary>The hinge, mesh space.</summary>
        public readonly float3 origin;

        /// <summary>Columns: span, up and forward axis, unit vectors in mesh space.</summary>
        public readonly float3x3 axes;

        /// <summary>Wing length: the largest distance of the mesh from the hinge along the span, mesh units.</summary>
        public readonly float length;

        /// <summary>True for a left wing: forward is −cross(span, up).</summary>
        public readonly bool mirrored;

        /// <summary>A frame from its parts; the axes are unit vectors at right angles, a mirror image where mirrored.</summary>
        public WingFrame(float3 origin, float3x3 axes, float length, bool mirrored)
        {
            this.origin = origin;
            this.axes = axes;
            this.length = length;
            this.mirrored = mirrored;
        }

        /// <summary>Converts a point of mesh space to the wing frame, in wing lengths.</summary>
        public float3 ToWing(float3 meshPoint) => DirectionToWing(meshPoint - origin) / length;

        /// <summary>Converts a point of the wing frame to mesh space.</summary>
        public float3 ToMesh(float3 wingPoint) => origin + DirectionToMesh(wingPoint) * length;

        /// <summary>Converts a direction of mesh space to the wing frame, of equal length.</summary>
        public float3 DirectionToWing(float3 meshDirection) =>
            new float3(math.dot(axes.c0, meshDirection), math.dot(axes.c1, meshDirection), math.dot(axes.c2, meshDirection));

        /// <summary>Converts a direction of the wing frame to mesh space, of equal length.</summary>
        public float3 DirectionToMesh(float3 wingDirection) => math.mul(axes, wingDirection);
    }
}
