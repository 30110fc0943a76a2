using Unity.Mathematics;

namespace Alate.Crowds
{
    /// <summary>
    /// One wing of a baked insect: which vertices it moves, and the joints that a skin of linear blends needs, in the insect's own space.
    /// </summary>
    public sealed class BakedWing
    {
        /// <summary>Name of the object that draws the wing.</summary>
        public string Name { get; internal set; }

        /// <summary>The side of the body.</summary>
        public WingSide Side { get; internal set; }

        /// <summary>Wing length, units of the insect's space.</summary>
        public float Length { get; internal set; }

        /// <summary>Vertices of <see cref="BakedSurface"/> that are the wing's.</summary>
        public int[] Vertices { get; internal set; }

        /// <summary>Place of the wing's first joint among those of all wings.</summary>
        public int FirstJoint { get; internal set; }

        /// <summary>Joints of each chain; joint index = chain · joints a chain + joint.</summary>
        public int JointsPerChain { get; internal set; }

        /// <summary>[joint] Position at rest.</summary>
        public float3[] RestJoints { get; internal set; }

        /// <summary>[vertex of the wing] The four joints that move it, counted within the wing.</summary>
        public int4[] VertexJoints { get; internal set; }

        /// <summary>[vertex of the wing] Their weights; sum 1.</summary>
        public float4[] VertexWeights { get; internal set; }
    }
}
