using System;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;

namespace Alate
{
    /// <content>Deformed vertices, and their ways from picture to picture for motion vectors.</content>
    public sealed partial class WingWorld
    {
        /// <summary>Vertices that the last <see cref="Skin"/> made: mesh space, in the mesh's vertex order. Do not dispose.</summary>
        /// <exception cref="ArgumentException">No such wing.</exception>
        public NativeArray<SkinnedVertex> Vertices(WingHandle wing) => Entry(wing).vertices;

        /// <summary>Tangents that go with the vertices, w the handedness; not created where the mesh has none.</summary>
        /// <exception cref="ArgumentException">No such wing.</exception>
        public NativeArray<float4> Tangents(WingHandle wing) => Entry(wing).tangents;

        /// <summary>
        /// Vertices of a wing that was added with packing; not created otherwise, as those of <see cref="Vertices"/> are not for such a
        /// wing.
        /// </summary>
        internal NativeArray<PackedVertex> PackedVertices(WingHandle wing) => Entry(wing).packedVertices;

        /// <summary>Tangents of a wing that was added with packing; not created where they are not wanted, or the mesh has none.</summary>
        internal NativeArray<int> PackedTangents(WingHandle wing) => Entry(wing).packedTangents;

        /// <summary>
        /// Transforms of the joints, mesh space, of a wing that was added without vertices; not created for others, and where they are
        /// placed in <see cref="JointMemory"/>.
        /// </summary>
        internal NativeArray<DualQuaternion> Palette(WingHandle wing) => Entry(wing).palette;

        /// <summary>Memory in which joints are placed by <see cref="PlaceJoints"/>; asked for before each use.</summary>
        internal IJointMemory JointMemory { get; set; }

        /// <summary>
        /// Lets <see cref="Skin"/> write the joints' transforms of a wing that was added without vertices into <see cref="JointMemory"/>,
        /// from the given joint on.
        /// </summary>
        internal void PlaceJoints(WingHandle wing, int firstJoint)
        {
            WingEntry entry = Entry(wing);
            entry.Place(firstJoint);
            m_Arrays.SetPlace(entry);
        }

        /// <summary>
        /// Returns true where a picture has shown what the next one moves on from: false after a reset or a time in which the wing was not
        /// deformed.
        /// </summary>
        internal bool IsMovedOn(WingHandle wing) => Entry(wing).displaces;

        /// <summary>Bounds of the vertices that the last <see cref="Skin"/> made, mesh space.</summary>
        /// <exception cref="ArgumentException">No such wing.</exception>
        public Bounds Bounds(WingHandle wing)
        {
            WingEntry entry = Entry(wing);
            return m_Arrays.Bounds(entry, entry.placed > 0 ? JointTexels : default);
        }

        /// <summary>
        /// Ways of the vertices from the last picture to the last <see cref="Skin"/>; not created for a wing that was added without. They
        /// are 0 until <see cref="TakePicture"/>, and after a reset or a time in which the wing was not deformed.
        /// </summary>
        internal NativeArray<VertexDisplacement> Displacements(WingHandle wing) => Entry(wing).displacements;

        private NativeArray<float4> JointTexels => JointMemory == null ? default : JointMemory.Texels;

        /// <summary>Notes that a picture shows a wing's vertices: the next displacements lead from them.</summary>
        internal void TakePicture(WingHandle wing) => m_Arrays.SetDisplaces(Entry(wing), true);

        /// <summary>Sets a wing's displacements to 0: a picture shows the vertices that the last one showed.</summary>
        internal void StopDisplacements(WingHandle wing)
        {
            NativeArray<VertexDisplacement> displacements = Entry(wing).displacements;
            for (int vertex = 0; vertex < displacements.Length; vertex++)
                displacements[vertex] = default;
        }
    }
}
