namespace Alate.Editor
{
    /// <summary>Weaknesses of a rig whose skeleton is valid.</summary>
    internal enum RigProblemKind
    {
        /// <summary>Mesh and skeleton do not belong together; no rig can be baked.</summary>
        DoesNotFit,

        /// <summary>Vertices beside the fan of joints; they move with its edge, stiffly.</summary>
        FarVertices,

        /// <summary>Triangles that only roots move: they never bend.</summary>
        HeldByRoots,

        /// <summary>Triangles without an area: they count for nothing, and their normals are undefined.</summary>
        NoArea,

        /// <summary>A joint that carries so much of the wing that those around it hardly matter.</summary>
        MassConcentrated,

        /// <summary>A joint that carries no part of the mesh.</summary>
        NoMass,
    }
}
