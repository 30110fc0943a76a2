namespace Alate
{
    /// <summary>State of an <see cref="InsectWings"/>: its wings live, or the reason why they do not.</summary>
    public enum InsectState
    {
        /// <summary>Not in play, or switched off.</summary>
        Inactive,

        /// <summary>Waits for its turn; it starts within a few frames.</summary>
        Waiting,

        /// <summary>The wings beat.</summary>
        Ready,

        /// <summary>The list of wings is empty.</summary>
        NoWings,

        /// <summary>The wings are drawn by a SkinnedMeshRenderer, which moves them by bones.</summary>
        SkinnedWings,

        /// <summary>A wing has no renderer, or it was destroyed.</summary>
        NoRenderer,

        /// <summary>A wing's renderer has no MeshFilter with a mesh.</summary>
        NoMesh,

        /// <summary>The mesh keeps no copy that scripts can read.</summary>
        MeshNotReadable,

        /// <summary>The renderer was merged with others by static batching.</summary>
        StaticBatch,

        /// <summary>The mesh has no such submesh, or no triangles there.</summary>
        NoSuchPart,

        /// <summary>Two wings claim the same vertices.</summary>
        WingsOverlap,

        /// <summary>No skeleton is given, and none could be laid out automatically.</summary>
        NoSkeleton,

        /// <summary>The skeleton has problems of its own.</summary>
        SkeletonInvalid,

        /// <summary>The skeleton is not that of this mesh.</summary>
        SkeletonDoesNotFit,

        /// <summary>A scale of zero leaves nothing to move.</summary>
        ZeroScale,

        /// <summary>An error came up while the wings were built; it is in the console.</summary>
        Failed,
    }
}
