namespace Alate
{
    /// <summary>Format of the vertices that the skinning job writes for a wing.</summary>
    internal enum VertexPacking
    {
        /// <summary>Positions, normals and, where the mesh has them, tangents; all as floats.</summary>
        None,

        /// <summary>Positions as floats and normals as signed bytes; no tangents.</summary>
        Normals,

        /// <summary>Positions as floats, normals and tangents as signed bytes.</summary>
        NormalsAndTangents,

        /// <summary>No vertices: the transforms of the joints, by which a graphics card deforms the mesh.</summary>
        Joints,
    }
}
