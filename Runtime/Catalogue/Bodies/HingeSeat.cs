using System;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>
    /// Flat area of a body's side on which a wing sits: within it the skin is moved to the plane of the hinge, around it the move fades
    /// out, so that the root of the wing lies on the skin.
    /// </summary>
    internal sealed class HingeSeat
    {
        /// <summary>Distance of the skin inside the plane of the hinge, as a share of the hinge's distance from the middle.</summary>
        private const float k_Inset = 0.003f;

        /// <summary>
        /// Flat skin all round the root, of the root's length: wider than the triangles are, which span the edge of the flat area.
        /// </summary>
        private const float k_Margin = 0.22f;

        private readonly Vector3 m_Hinge;
        private readonly float m_Front, m_Rear, m_HalfHeight, m_Fade;

        /// <summary>Makes the seat of a wing: its root with a margin all round, and a fade as wide as half the root.</summary>
        /// <param name="hinge">Hinge of the wing on the body, millimetres.</param>
        /// <param name="leading">Front end of the root from the hinge, millimetres, ahead positive.</param>
        /// <param name="trailing">Rear end of the root from the hinge, millimetres, ahead positive.</param>
        public HingeSeat(Vector3 hinge, float leading, float trailing)
        {
            m_Hinge = hinge;
            float front = hinge.z + leading, rear = hinge.z + trailing;
            float root = front - rear;
            m_HalfHeight = k_Margin * root;
            m_Front = front + m_HalfHeight;
            m_Rear = rear - m_HalfHeight;
            m_Fade = 0.5f * root;
        }

        /// <summary>The part with its skin moved to the seat, on both sides where it lies on both.</summary>
        public BodyPart Press(BodyPart part) => part.Moved(Move);

        /// <summary>Returns true where a place is on or near the seat, where hair would grow through the wing.</summary>
        public bool Covers(Vector3 place) => Away(place) < 0.5;

        private Vector3 Move(Vector3 place)
        {
            double away = Away(place);
            float target = (1f - k_Inset) * m_Hinge.x;

            // What lies deep inside, such as the middle line of the back, is no skin of the side.
            if (away >= 1 || Math.Abs(place.x) < 0.5f * target)
                return place;
            float share = (float)(1 - away * away * (3 - 2 * away));
            place.x += share * (Math.Sign(place.x) * target - place.x);
            return place;
        }

        // From the flat area, in widths of the fade.
        private double Away(Vector3 place)
        {
            float beyond = Math.Max(0f, Math.Max(place.z - m_Front, m_Rear - place.z));
            float above = Math.Max(0f, Math.Abs(place.y - m_Hinge.y) - m_HalfHeight);
            return Math.Sqrt(beyond * beyond + above * above) / m_Fade;
        }
    }
}
