using UnityEngine;

namespace Alate
{
    /// <summary>A connected part of a mesh, seen from the insect.</summary>
    internal readonly struct MeasuredPiece
    {
        /// <summary>Measures in the insect's space.</summary>
        public readonly WingShape shape;

        /// <summary>A point on it, mesh space.</summary>
        public readonly Vector3 point;

        /// <summary>The submesh that all of it belongs to; −1 if it reaches over several.</summary>
        public readonly int submesh;

        public MeasuredPiece(WingShape shape, Vector3 point, int submesh)
        {
            this.shape = shape;
            this.point = point;
            this.submesh = submesh;
        }
    }
}
