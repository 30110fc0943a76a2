using System;
using Unity.Collections;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>Managed record of one wing of a <see cref="WingWorld"/>.</summary>
    internal sealed class WingEntry : IDisposable
    {
        public readonly WingRig rig;
        public readonly int version;
        public PackMemory pack;
        public int lane;
        public WingParameters parameters;
        public PackKey packKey;
        public WingSurroundings surroundings;

        /// <summary>Index of the body that the wing carries and 1; 0 for none.</summary>
        public int body;

        /// <summary>Deformed vertices, mesh order; not created where they are packed.</summary>
        public NativeArray<SkinnedVertex> vertices;

        /// <summary>Deformed tangents; not created where the mesh has none, or they are packed or not wanted.</summary>
        public NativeArray<float4> tangents;

        /// <summary>Deformed vertices, mesh order; not created where they are not packed.</summary>
        public NativeArray<PackedVertex> packedVertices;

        /// <summary>Deformed tangents by <see cref="SignedBytes"/>; not created as <see cref="tangents"/>.</summary>
        public NativeArray<int> packedTangents;

        /// <summary>Ways of the vertices since the last picture; not created where they are not wanted.</summary>
        public NativeArray<VertexDisplacement> displacements;

        /// <summary>Transforms of the joints; created where they take the place of vertices and are not placed elsewhere.</summary>
        public NativeArray<DualQuaternion> palette;

        /// <summary>Index of the first joint in the world's joint memory and 1; 0 where the transforms are not placed there.</summary>
        public int placed;

        /// <summary>Index of the wing's first chunk in the skinning job, and number of chunks.</summary>
        public int firstChunk;
        public int chunkCount;

        /// <summary>Index in the skinning job's targets.</summary>
        public int target;

        /// <summary>True where the skinning job deforms the wing.</summary>
        public bool skinned = true;

        /// <summary>True where it deforms the vertices of the smaller mesh alone.</summary>
        public bool smaller;

        /// <summary>True where the vertices are those of the last picture.</summary>
        public bool displaces;

        /// <summary>Bounds of the wing's vertices, kept while the jobs' arrays are laid out again.</summary>
        public ChunkBounds bounds;

        public unsafe WingEntry(WingRig rig, int version, in WingParameters parameters, VertexPacking packing, bool moves)
        {
            this.rig = rig;
            this.version = version;
            this.parameters = parameters;
            rig.Retain();
            if (packing == VertexPacking.Joints)
            {
                palette = new NativeArray<DualQuaternion>(rig.JointCount, Allocator.Persistent);
                return;
            }

            if (moves)
                displacements = new NativeArray<VertexDisplacement>(rig.VertexCount, Allocator.Persistent);
            bool hasTangents = rig.View.skinTangents != null;
            if (packing != VertexPacking.None)
            {
                packedVertices = new NativeArray<PackedVertex>(rig.VertexCount, Allocator.Persistent);
                if (hasTangents && packing == VertexPacking.NormalsAndTangents)
                    packedTangents = new NativeArray<int>(rig.VertexCount, Allocator.Persistent);
                return;
            }

            vertices = new NativeArray<SkinnedVertex>(rig.VertexCount, Allocator.Persistent);
            if (hasTangents)
                tangents = new NativeArray<float4>(rig.VertexCount, Allocator.Persistent);
        }

        /// <summary>Lets the wing carry no body: it meets the inflow of its own parameters again, not that of a body's table.</summary>
        public void LeaveBody()
        {
            body = 0;
            Meet(parameters.inflow);
        }

        /// <summary>Lets the wing meet an inflow, which sets in as the wings beat.</summary>
        public unsafe void Meet(in WingInflow inflow)
        {
            for (int to = 0; pack != null && to < WingPack.Lanes; to++)
            {
                if (pack.Writes(lane, to))
                    pack.view.inflow->Set(to, inflow);
            }
        }

        /// <summary>Lets the wing meet other surroundings from the next substep on.</summary>
        public unsafe void Meet(in WingSurroundings around)
        {
            surroundings = around;
            for (int to = 0; to < WingPack.Lanes; to++)
            {
                if (pack.Writes(lane, to))
                    pack.view.surroundings->Set(to, around);
            }
        }

        /// <summary>True where the transforms of the joints take the place of vertices.</summary>
        public bool HasJoints => placed > 0 || palette.IsCreated;

        /// <summary>Places the transforms of the joints in the world's joint memory.</summary>
        public void Place(int firstJoint)
        {
            GrowingArray.Free(ref palette);
            placed = firstJoint + 1;
        }

        public void Dispose()
        {
            GrowingArray.Free(ref vertices);
            GrowingArray.Free(ref tangents);
            GrowingArray.Free(ref packedVertices);
            GrowingArray.Free(ref packedTangents);
            GrowingArray.Free(ref displacements);
            GrowingArray.Free(ref palette);
            rig.Release();
        }
    }
}
