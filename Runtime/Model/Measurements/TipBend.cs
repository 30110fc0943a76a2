using Alate.Geometry;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Bend of a wing: the height of its tip over the wing's plane, as an angle at the hinge; the plane turns with the root.
    /// </summary>
    internal static class TipBend
    {
        /// <summary>The vertex farthest out on the span, of several the most forward.</summary>
        /// <param name="rest">[vertex] Rest positions, wing frame.</param>
        /// <param name="triangles">Three vertex indices a triangle; vertices of no triangle are no tip.</param>
        public static int FindTip(float3[] rest, int[] triangles)
        {
            int tip = triangles[0];
            foreach (int vertex in triangles)
            {
                bool farther = rest[vertex].x > rest[tip].x;
                bool moreForward = rest[vertex].x == rest[tip].x && rest[vertex].z > rest[tip].z;
                tip = farther || moreForward ? vertex : tip;
            }

            return tip;
        }

        /// <summary>Angle of the tip above the root's plane, radians, up positive.</summary>
        /// <param name="tip">The tip as the root sees it, <see cref="BeatFrame.AtRoot"/>.</param>
        public static float Angle(float3 tip) => Elementary.Atan2(tip.y, math.length(tip.xz));
    }
}
