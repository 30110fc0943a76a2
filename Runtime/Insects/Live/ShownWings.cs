using UnityEngine;

namespace Alate
{
    /// <summary>Living mesh in the place of an authored one, and what brings the wings' pose to the graphics card.</summary>
    internal abstract class ShownWings
    {
        /// <summary>The mesh that is drawn.</summary>
        public abstract Mesh Mesh { get; }

        /// <summary>Parts of the wings' vertices that the world computes.</summary>
        public abstract VertexPacking Packing { get; }

        /// <summary>True where the world computes the ways of the vertices from picture to picture.</summary>
        public abstract bool Moves { get; }

        /// <summary>Returns true where the renderer still shows what it was given.</summary>
        public abstract bool IsCurrent { get; }

        /// <summary>Uploads the pose of all wings.</summary>
        public abstract void Upload(WingWorld world, LiveWing[] wings);

        /// <summary>Takes away the motion of the last upload: the wings stay as they are.</summary>
        public abstract void Stop(WingWorld world, LiveWing[] wings);

        /// <summary>Gives the renderer back what it had, and frees the rest.</summary>
        public abstract void Restore();
    }
}
