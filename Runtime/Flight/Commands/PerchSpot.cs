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

        /// <summary>True where there can be such a place.</summary>
        internal readonly bool IsPossible =>
            OuterBounds.Hold(position, OuterBounds.Distance) && OuterBounds.Hold(normal, OuterBounds.Distance);
    }
}
