using Alate.Geometry;
using Unity.Mathematics;

namespace Alate.Fitting
{
    /// <summary>The plane in which a wing is seen from above: a right-angled frame of unit vectors through the origin.</summary>
    internal readonly struct WingPlane
    {
        /// <summary>Unit vector along <see cref="PlanPoint.x"/>.</summary>
        public readonly float3 right;

        /// <summary>Unit vector towards the viewer.</summary>
        public readonly float3 up;

        /// <summary>Unit vector along <see cref="PlanPoint.z"/>.</summary>
        public readonly float3 ahead;

        private WingPlane(float3 right, float3 up, float3 ahead)
        {
            this.right = right;
            this.up = up;
            this.ahead = ahead;
        }

        /// <summary>Makes a plane of a normal; its rotation about the normal is arbitrary.</summary>
        public static WingPlane Facing(float3 normal)
        {
            float3 size = math.abs(normal);
            float3 other = size.x <= size.y && size.x <= size.z ? new float3(1f, 0f, 0f)
                : size.y <= size.z ? new float3(0f, 1f, 0f) : new float3(0f, 0f, 1f);
            float3 right = math.normalize(math.cross(other, normal));
            return new WingPlane(right, normal, math.normalize(math.cross(right, normal)));
        }

        public PlanPoint ToPlan(float3 p) => new PlanPoint(math.dot(right, p), math.dot(ahead, p));

        /// <summary>A vector of the plane in space.</summary>
        public float3 Direction(PlanPoint v) => (float)v.x * right + (float)v.z * ahead;
    }
}
