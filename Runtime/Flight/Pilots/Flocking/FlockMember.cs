using Unity.Mathematics;

namespace Alate.Flight
{
    /// <summary>One insect of all flocks, as its neighbours see it. World units.</summary>
    internal struct FlockMember
    {
        /// <summary>World units.</summary>
        public float3 position;

        /// <summary>World units per second.</summary>
        public float3 velocity;

        /// <summary>World units up to which others are neighbours, and to keep from them.</summary>
        public float sight, room;

        /// <summary>Members with the same number flock together.</summary>
        public int group;
    }
}
