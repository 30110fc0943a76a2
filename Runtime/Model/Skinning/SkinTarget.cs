using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>One wing as the skinning job sees it: whose pose, which rig, where to.</summary>
    internal unsafe struct SkinTarget
    {
        public RigView rig;
        public WingFrame frame;

        /// <summary>Index of the pack and lane that hold the wing's pose.</summary>
        public int pack;
        public int lane;

        /// <summary>Whether to deform it; otherwise vertices and bounds stay.</summary>
        public bool skinned;

        /// <summary>[vertexCount], in the mesh's order.</summary>
        public SkinnedVertex* vertices;

        /// <summary>[vertexCount]; null without tangents.</summary>
        public float4* tangents;
    }

    /// <summary>Work of one index of the skinning job: some quads of one wing.</summary>
    internal struct SkinChunk
    {
        public int target;
        public int firstQuad;
        public int endQuad;
    }

    /// <summary>Corners of a chunk's deformed vertices, mesh space.</summary>
    internal struct ChunkBounds
    {
        public float3 min;
        public float3 max;
    }
}
