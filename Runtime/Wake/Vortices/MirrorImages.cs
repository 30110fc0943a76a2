using System;
using Unity.Mathematics;

namespace Alate.Wake
{
    /// <summary>
    /// Planes that the air does not cross: the insect's plane of symmetry, a ground, or both. What mirror images of vortices induce at a
    /// point is what the vortices themselves induce at the point's mirror image, mirrored: V(p) = V(p) + M V(M p).
    /// </summary>
    internal readonly struct MirrorImages
    {
        private readonly bool m_Across, m_Ground;
        private readonly float3 m_Up;
        private readonly float m_Height;

        /// <summary>Planes of a flow.</summary>
        /// <param name="across">Mirrors left and right, at x = 0.</param>
        /// <param name="ground">Mirrors at a ground.</param>
        /// <param name="up">Unit normal of the ground.</param>
        /// <param name="height">Height of the origin above the ground, reference lengths.</param>
        /// <exception cref="ArgumentException">The two planes are not at right angles, so that their images have no end.</exception>
        public MirrorImages(bool across, bool ground, float3 up, float height)
        {
            if (across && ground && math.abs(up.x) > 1e-5f)
            {
                throw new ArgumentException(
                    $"The ground's normal is {up}; a flow that is symmetric left and right needs one without x.", nameof(up));
            }
            m_Across = across;
            m_Ground = ground;
            m_Up = up;
            m_Height = height;
        }

        /// <summary>Number of images of a point, with itself, which is image 0.</summary>
        public int Count => (m_Across ? 2 : 1) * (m_Ground ? 2 : 1);

        /// <summary>Image of a point.</summary>
        public float3 Point(int image, float3 point)
        {
            if (Crosses(image))
                point.x = -point.x;
            if (Dives(image))
                point -= 2f * (math.dot(m_Up, point) + m_Height) * m_Up;
            return point;
        }

        /// <summary>Image of a direction or a velocity; its own inverse.</summary>
        public float3 Direction(int image, float3 direction)
        {
            if (Crosses(image))
                direction.x = -direction.x;
            if (Dives(image))
                direction -= 2f * math.dot(m_Up, direction) * m_Up;
            return direction;
        }

        private bool Crosses(int image) => m_Across && (image & 1) != 0;

        private bool Dives(int image) => m_Ground && (m_Across ? image >> 1 : image) != 0;
    }
}
