namespace Alate
{
    /// <summary>One wing of a skinned mesh, before it becomes a mesh of its own.</summary>
    internal sealed class SkinnedWing
    {
        /// <summary>The corners of its triangles, by submesh of the source.</summary>
        public int[][] submeshes;

        /// <summary>The bone that carries it; −1 if the mesh has none.</summary>
        public int bone;

        /// <summary>Its shape, side and pair.</summary>
        public WingCandidate place;
    }
}
