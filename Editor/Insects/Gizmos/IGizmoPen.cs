using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Draws in the scene, in world space.</summary>
    internal interface IGizmoPen
    {
        /// <summary>Draws a line; wide ones are a few pixels wide, whatever their distance.</summary>
        void Line(Vector3 from, Vector3 to, Color colour, bool wide);

        /// <summary>Draws a small ball that keeps its size on the screen.</summary>
        void Dot(Vector3 at, Color colour);

        /// <summary>Draws the edges of a box in the space of a matrix.</summary>
        void Box(Matrix4x4 space, Bounds bounds, Color colour);
    }
}
