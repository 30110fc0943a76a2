using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Draws gizmos in the scene view.</summary>
    internal sealed class ScenePen : IGizmoPen
    {
        private const float k_Width = 2.5f, k_DotSize = 0.035f;

        /// <inheritdoc/>
        public void Line(Vector3 from, Vector3 to, Color colour, bool wide)
        {
            if (wide)
            {
                Handles.color = colour;
                Handles.DrawAAPolyLine(k_Width, from, to);
                return;
            }

            Gizmos.color = colour;
            Gizmos.DrawLine(from, to);
        }

        /// <inheritdoc/>
        public void Dot(Vector3 at, Color colour)
        {
            Gizmos.color = colour;
            Gizmos.DrawSphere(at, k_DotSize * HandleUtility.GetHandleSize(at));
        }

        /// <inheritdoc/>
        public void Box(Matrix4x4 space, Bounds bounds, Color colour)
        {
            Matrix4x4 before = Gizmos.matrix;
            Gizmos.matrix = space;
            Gizmos.color = colour;
            Gizmos.DrawWireCube(bounds.center, bounds.size);
            Gizmos.matrix = before;
        }
    }
}
