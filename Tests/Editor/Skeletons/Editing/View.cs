using UnityEngine;

namespace Alate.Editor.Tests
{
    /// <summary>A simple eye without perspective, 1000 pixels a unit, pixel (0, 0) ahead of where it stands.</summary>
    internal sealed class View
    {
        private const float k_PixelsPerUnit = 1000f;

        private readonly Vector3 m_Eye;
        private readonly Quaternion m_Rotation;

        public View(Vector3 eye, Quaternion rotation)
        {
            m_Eye = eye;
            m_Rotation = rotation;
        }

        /// <summary>From two units above the origin straight down; x to the right, z up the screen.</summary>
        public static View FromAbove => new View(new Vector3(0f, 2f, 0f), Quaternion.LookRotation(Vector3.down, Vector3.forward));

        public Vector3 Project(Vector3 world)
        {
            Vector3 seen = Quaternion.Inverse(m_Rotation) * (world - m_Eye);
            return new Vector3(seen.x * k_PixelsPerUnit, seen.y * k_PixelsPerUnit, seen.z);
        }

        public Ray Through(Vector2 pixel) =>
            new Ray(
                m_Eye + m_Rotation * new Vector3(pixel.x / k_PixelsPerUnit, pixel.y / k_PixelsPerUnit, 0f), m_Rotation * Vector3.forward);
    }
}
