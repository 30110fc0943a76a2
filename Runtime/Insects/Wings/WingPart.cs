namespace Alate
{
    /// <summary>Part of a mesh that is a wing.</summary>
    public enum WingPart
    {
        /// <summary>The whole mesh.</summary>
        WholeMesh,

        /// <summary>The triangles of one submesh, so of one material.</summary>
        Submesh,

        /// <summary>The connected triangles around the one nearest to a point; corners at one place count as connected.</summary>
        ConnectedPart,
    }
}
