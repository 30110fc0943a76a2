using Unity.Mathematics;

namespace Alate.Flight
{
    /// <summary>View that a member of a flock has of its neighbours.</summary>
    internal struct FlockView
    {
        /// <summary>Middle of the neighbours, world units.</summary>
        public float3 centre;

        /// <summary>Mean velocity of the neighbours, world units per second.</summary>
        public float3 velocity;

        /// <summary>Sum of the ways away from those that are too near: 1 long for one that touches, 0 at the distance to keep.</summary>
        public float3 apart;

        /// <summary>Neighbours of its group.</summary>
        public int count;
    }
}
