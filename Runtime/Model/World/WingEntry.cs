using System;
using Unity.Collections;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>What a <see cref="WingWorld"/> keeps of one wing on the managed side.</summary>
    internal sealed class WingEntry : IDisposable
    {
        public readonly WingRig rig;
        public readonly int version;
        public PackMemory pack;
        public int lane;
        public WingParameters parameters;
        public PackKey pacing;
        public WingSurroundings surroundings;

        /// <summary>Deformed vertices, mesh order.</summary>
        public NativeArray<SkinnedVertex> vertices;

        /// <summary>Deformed tangents; not created where the mesh has none.</summary>
        public NativeArray<float4> tangents;

        /// <summary>First chunk of the wing in the skinning job, and how many.</summary>
        public int firstChunk;
        public int chunkCount;

        /// <summary>Index in the skinning job's targets.</summary>
        public int target;

        /// <summary>Whether the skinning job deforms it.</summary>
        public bool skinned = true;

        /// <summary>Corners of its vertices, kept while the jobs' arrays are laid out again.</summary>
        public ChunkBounds bounds;

        public unsafe WingEntry(WingRig rig, int version, in WingParameters parameters)
        {
            this.rig = rig;
            this.version = version;
            this.parameters = parameters;
            rig.Retain();
            vertices = new NativeArray<SkinnedVertex>(rig.VertexCount, Allocator.Persistent);
            if (rig.View.skinTangents != null)
                tangents = new NativeArray<float4>(rig.VertexCount, Allocator.Persistent);
        }

        public void Dispose()
        {
            vertices.Dispose();
            if (tangents.IsCreated)
                tangents.Dispose();
            rig.Release();
        }
    }
}
