using UnityEngine;

namespace Alate
{
    /// <summary>A connected part of a mesh, seen from the insect.</summary>
    internal readonly struct MeasuredPiece
    {
        /// <summary>Shape in the insect's space.</summary>
        public readonly WingShape shape;

        /// <summary>A point on it, mesh space.</summary>
        public readonly Vector3 point;

        /// <summary>Submesh of the whole part; −1 if the part reaches over several.</summary>
        public readonly int submesh;

        public MeasuredPiece(WingShape shape, Vector3 point, int submesh)
        {
            this.shape = shape;
            this.point = point;
            this.submesh = submesh;
        }
    }
}
