namespace Alate
{
    /// <summary>Which part of a mesh is a wing.</summary>
    public enum WingPart
    {
        /// <summary>All of it.</summary>
        WholeMesh,

        /// <summary>The triangles of one submesh, so of one material.</summary>
        Submesh,

        /// <summary>The triangles that hang together with the one nearest to a point; corners at the same place count as one.</summary>
        ConnectedPart,
    }
}
