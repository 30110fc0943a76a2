using UnityEngine;

namespace Alate
{
    /// <summary>Living mesh in the place of an authored one, and what brings the wings' pose to the graphics card.</summary>
    internal abstract class ShownWings
    {
        /// <summary>The mesh that is drawn.</summary>
        public abstract Mesh Mesh { get; }

        /// <summary>Share of the time that a mesh of its own would take to make: one in so many.</summary>
        public abstract int SharedBy { get; }

        /// <summary>Parts of the wings' vertices that the world computes.</summary>
        public abstract VertexPacking Packing { get; }

        /// <summary>True where the world computes the ways of the vertices from picture to picture.</summary>
        public abstract bool Moves { get; }

        /// <summary>Returns true where the renderer still shows what it was given.</summary>
        public abstract bool IsCurrent { get; }

        /// <summary>Wings on the mesh; none before <see cref="Begin"/>.</summary>
        protected LiveWing[] Wings { get; private set; } = System.Array.Empty<LiveWing>();

        /// <summary>Takes over the wings on the mesh.</summary>
        public void Begin(LiveWing[] wings) => Wings = wings;

        /// <summary>First joint of a wing in the world's joint memory; −1 where it has vertices.</summary>
        public virtual int FirstJoint(int wing) => -1;

        /// <summary>Has the mesh drawn with fewer triangles, where that costs less, or with all.</summary>
        public virtual void ShowSmaller(bool smaller)
        {
        }

        /// <summary>Uploads the pose of all wings.</summary>
        public abstract void Upload(WingWorld world);

        /// <summary>Takes away the motion of the last upload: the wings stay as they are.</summary>
        public abstract void Stop(WingWorld world);

        /// <summary>Gives the renderer back what it had, and frees the rest.</summary>
        public abstract void Restore();
    }
}
