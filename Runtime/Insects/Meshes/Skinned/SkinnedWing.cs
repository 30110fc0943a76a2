namespace Alate
{
    /// <summary>Wing of a skinned mesh, before it becomes a mesh of its own.</summary>
    internal sealed class SkinnedWing
    {
        /// <summary>Corners of its triangles, by submesh of the source.</summary>
        public int[][] submeshes;

        /// <summary>Index of the bone that carries the wing; −1 if the mesh has none.</summary>
        public int bone;

        /// <summary>Shape, side and pair of the wing.</summary>
        public WingCandidate place;
    }
}
