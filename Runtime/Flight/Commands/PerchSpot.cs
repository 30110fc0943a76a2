using Unity.Mathematics;

namespace Alate.Flight
{
    /// <summary>A place to sit.</summary>
    public struct PerchSpot
    {
        /// <summary>Point of the surface between the feet, world units.</summary>
        public float3 position;

        /// <summary>Unit normal of the surface, out of it.</summary>
        public float3 normal;

        /// <summary>Direction in which the insect looks, radians about the world's up.</summary>
        public float heading;

        /// <summary>True where there is such a place.</summary>
        internal readonly bool IsFinite => math.all(math.isfinite(position)) && math.all(math.isfinite(normal)) && math.isfinite(heading);
    }
}
