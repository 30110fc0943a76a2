using System;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Scripting.APIUpdating;

namespace Alate
{
    /// <summary>
    /// Content baked once from a skeleton and a mesh (Sec. 4.1): weights, the map from joints to vertices, masses, springs, surface
    /// patches, the order of skinning. Never changes; all wings of one skeleton and mesh share it, left and right ones too where one mesh
    /// serves both. Lies in native memory, which is freed when the last user has called <see cref="Release"/>.
    /// </summary>
    /// <remarks>For the main thread. Reading a property of a disposed rig throws <see cref="ObjectDisposedException"/>.</remarks>
    [MovedFrom(true, null, "Alate")]
    public sealed class WingRig
    {
        private readonly RigMemory m_Memory;
        private int m_Users = 1;

        private WingRig(RigContent content)
        {
            m_Memory = new RigMemory(content);
            Frame = content.frame;
            TriangleCount = content.triangleCount;
            Area = content.area;
            Beams = content.beams;
            VeinFactors = content.hasVeins ? content.veinFactors : null;
        }

        /// <summary>Frame of the wing: converts between mesh space and wing frame; may be read after disposal.</summary>
        public WingFrame Frame { get; }

        /// <summary>Number of triangles with an area, each place once; masses and patches count these alone.</summary>
        public int TriangleCount { get; }

        /// <summary>Area of the wing, one side, squared wing lengths.</summary>
        public float Area { get; }

        /// <summary>Measured stiffness of the chains, as hinges; may be read after disposal.</summary>
        internal BeamHinges Beams { get; }

        /// <summary>[bone] Factors of the veins; null where none are known. May be read after disposal.</summary>
        internal float[] VeinFactors { get; }

        /// <summary>True once the last user has released the rig.</summary>
        public bool IsDisposed => m_Users == 0;

        /// <summary>Number of chains, n.</summary>
        public int ChainCount => View.chainCount;

        /// <summary>Number of joints of each chain, m.</summary>
        public int JointsPerChain => View.jointsPerChain;

        /// <summary>Number of joints, n·m; joint index = chain · m + joint.</summary>
        public int JointCount => View.jointCount;

        /// <summary>Number of bones, n·(m−1); bone index = chain · (m−1) + inner joint.</summary>
        public int BoneCount => View.boneCount;

        /// <summary>Number of cells between neighbouring chains, (n−1)·(m−1); cell index = forward chain · (m−1) + inner joint.</summary>
        public int CellCount => View.cellCount;

        /// <summary>Number of springs of the elastic network.</summary>
        public int SpringCount => View.springCount;

        /// <summary>Number of surface patches that meet the air.</summary>
        public int PatchCount => View.patchCount;

        /// <summary>Number of vertices of the mesh, including those of no triangle.</summary>
        public int VertexCount => View.vertexCount;

        /// <summary>[joint] Rest positions, wing frame, wing lengths.</summary>
        public NativeArray<float3>.ReadOnly RestJoints => Alive.restJoints.AsReadOnly();

        /// <summary>[joint] Masses; the wing's is 1. None is below about 1e-4, also where a joint carries no part of the mesh.</summary>
        public NativeArray<float>.ReadOnly JointMasses => Alive.jointMasses.AsReadOnly();

        /// <summary>[spring] The elastic network.</summary>
        public NativeArray<Spring>.ReadOnly Springs => Alive.springs.AsReadOnly();

        /// <summary>[vertex] The four joints that move it.</summary>
        public NativeArray<int4>.ReadOnly VertexJoints => Alive.vertexJoints.AsReadOnly();

        /// <summary>[vertex] Weights of the four joints, in [0, 1], sum 1.</summary>
        public NativeArray<float4>.ReadOnly VertexWeights => Alive.vertexWeights.AsReadOnly();

        /// <summary>[joint] Index of the joint's first vertex in <see cref="JointVertices"/>; one more entry holds the end.</summary>
        public NativeArray<int>.ReadOnly JointVertexStarts => Alive.jointVertexStarts.AsReadOnly();

        /// <summary>The vertices that each joint moves, {v_j | w_ij ≠ 0} of Sec. 4.1, joint by joint, ascending.</summary>
        public NativeArray<int>.ReadOnly JointVertices => Alive.jointVertices.AsReadOnly();

        /// <summary>View of the rig for jobs; valid until disposal.</summary>
        internal ref readonly RigView View => ref Alive.view;

        /// <summary>View of the rig with all its patches, or with few; the joints are the same.</summary>
        internal ref readonly RigView ViewAt(bool coarse)
        {
            if (coarse)
                return ref Alive.coarseView;
            return ref Alive.view;
        }

        private RigMemory Alive => IsDisposed ? throw new ObjectDisposedException(nameof(WingRig)) : m_Memory;

        /// <summary>Bakes a rig for a mesh, with one user: the caller releases it.</summary>
        /// <param name="skeleton">A valid skeleton in the space of the mesh.</param>
        /// <param name="mesh">A readable mesh; the triangles of all its submeshes make the wing.</param>
        /// <param name="settings">What to choose.</param>
        /// <exception cref="ArgumentNullException">There is no skeleton or no mesh.</exception>
        /// <exception cref="ArgumentException">The skeleton is not valid, the mesh is broken or not readable, or the two do not fit:
        /// less than half of the wing's area lies within 0.15 wing lengths of the joints, or the joints reach less than half or more than
        /// twice as far as the mesh. The message is one line.</exception>
        /// <exception cref="ArgumentOutOfRangeException">The number of patches is negative.</exception>
        public static WingRig Bake(WingSkeleton skeleton, Mesh mesh, in WingRigSettings settings) =>
            Bake(skeleton, SurfaceMesh.FromMesh(mesh), settings);

        /// <summary>Bakes a rig for a surface of plain arrays, with one user: the caller releases it.</summary>
        /// <inheritdoc cref="Bake(WingSkeleton, Mesh, in WingRigSettings)"/>
        public static WingRig Bake(WingSkeleton skeleton, SurfaceMesh surface, in WingRigSettings settings) =>
            new WingRig(RigBaker.Bake(skeleton, surface, settings));

        /// <summary>Adds one user.</summary>
        /// <exception cref="ObjectDisposedException">The last user has released the rig.</exception>
        public void Retain()
        {
            ThrowIfDisposed();
            m_Users++;
        }

        /// <summary>Removes one user; the last one frees the memory.</summary>
        /// <exception cref="ObjectDisposedException">The last user has released the rig before.</exception>
        public void Release()
        {
            ThrowIfDisposed();
            if (--m_Users == 0)
                m_Memory.Dispose();
        }

        private void ThrowIfDisposed()
        {
            if (IsDisposed)
                throw new ObjectDisposedException(nameof(WingRig));
        }
    }
}
