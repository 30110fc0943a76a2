using Unity.Mathematics;

namespace Alate
{
    /// <summary>Wing as passed to the skinning job: its pose, its rig, and the vertices to write.</summary>
    /// <remarks>
    /// 448 bytes a wing, the rig's view by value: a chunk of the job needs nothing but its target and the pack.
    /// </remarks>
    internal unsafe struct SkinTarget
    {
        public RigView rig;
        public WingFrame frame;

        /// <summary>Index of the pack and lane that hold the wing's pose.</summary>
        public int pack;
        public int lane;

        /// <summary>True where the job deforms the wing; otherwise vertices and bounds stay.</summary>
        public bool skinned;

        /// <summary>True where only the vertices of the smaller mesh are deformed.</summary>
        public bool smaller;

        /// <summary>True where the vertices are those of the last picture; otherwise displacements are 0.</summary>
        public bool displaces;

        /// <summary>[vertexCount] Deformed vertices, in the mesh's order; null where they are packed.</summary>
        public SkinnedVertex* vertices;

        /// <summary>[vertexCount] Deformed tangents; null where the mesh has none, or they are packed or not wanted.</summary>
        public float4* tangents;

        /// <summary>[vertexCount] Deformed vertices; null where they are not packed.</summary>
        public PackedVertex* packedVertices;

        /// <summary>[vertexCount] Deformed tangents by <see cref="SignedBytes"/>; null as <see cref="tangents"/>.</summary>
        public int* packedTangents;

        /// <summary>[vertexCount] Ways of the vertices since the last picture; null where they are not wanted.</summary>
        public VertexDisplacement* displacements;

        /// <summary>[jointCount] Transforms of the joints, in place of vertices; null where the job deforms the mesh.</summary>
        public DualQuaternion* palette;

        /// <summary>Index of the first joint in the job's joints and 1, in place of a palette of its own; 0 for none.</summary>
        public int placed;
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
