using Unity.Mathematics;
using UnityEngine;

namespace Alate
{
    /// <summary>
    /// Velocity and turn rate of a body from where it is frame by frame. Far from the origin, where positions are coarse, it looks over longer times; a jump is
    /// told from motion and does not enter the velocity.
    /// </summary>
    internal struct MotionSampler
    {
        /// <summary>Seconds over which a new velocity is taken over; a beat or less, so that jitter of frame times does not shake the wings.</summary>
        private const float k_Smoothing = 0.05f;

        /// <summary>Longest time to look over, seconds.</summary>
        private const float k_LongestWindow = 0.5f;

        private Vector3 m_Position, m_WindowPosition;
        private Quaternion m_Rotation, m_WindowRotation;
        private float m_Window;
        private bool m_Started, m_Moving;

        /// <summary>World units per second.</summary>
        public Vector3 Velocity { get; private set; }

        /// <summary>Radians per second about the world's axes.</summary>
        public Vector3 AngularVelocity { get; private set; }

        /// <summary>Takes the body's place as new, and its motion as it was.</summary>
        public void Rebase(Vector3 position, Quaternion rotation)
        {
            m_Position = m_WindowPosition = position;
            m_Rotation = m_WindowRotation = rotation;
            m_Window = 0f;
            m_Started = true;
        }

        /// <summary>Forgets the motion: the next place is the first.</summary>
        public void Forget() => this = default;

        /// <summary>Takes in where the body is after some time, seconds; where no time has passed it may be anywhere.</summary>
        /// <param name="position">World position.</param>
        /// <param name="rotation">World rotation.</param>
        /// <param name="dt">Seconds since the last place.</param>
        /// <param name="finest">The least velocity that matters, world units per second.</param>
        /// <param name="jump">A move beyond what the motion explains, world units, from which on it is a jump.</param>
        /// <param name="turn">The same for turns, degrees.</param>
        /// <returns>Whether the body jumped.</returns>
        public bool Sample(Vector3 position, Quaternion rotation, float dt, float finest, float jump, float turn)
        {
            if (!m_Started || !(dt > 0f))
            {
                Rebase(position, rotation);
                return false;
            }

            float unexplained = (position - m_Position - Velocity * dt).magnitude;
            float turned = Quaternion.Angle(m_Rotation, rotation) - AngularVelocity.magnitude * Mathf.Rad2Deg * dt;
            if (unexplained > jump || turned > turn)
            {
                Rebase(position, rotation);
                return true;
            }

            m_Position = position;
            m_Rotation = rotation;
            m_Window += dt;
            if (m_Window >= math.min(4f * Resolution(position) / finest, k_LongestWindow))
                CloseWindow();
            return false;
        }

        // The distance between neighbouring floats at a place.
        private static float Resolution(Vector3 position)
        {
            float largest = math.cmax(math.abs((float3)position));
            return largest * 1.2e-7f;
        }

        private void CloseWindow()
        {
            float share = m_Moving ? 1f - math.exp(-m_Window / k_Smoothing) : 1f;
            Vector3 velocity = (m_Position - m_WindowPosition) / m_Window;
            Velocity += share * (velocity - Velocity);
            AngularVelocity += share * (Rate(m_WindowRotation, m_Rotation, m_Window) - AngularVelocity);
            m_Moving = true;
            m_WindowPosition = m_Position;
            m_WindowRotation = m_Rotation;
            m_Window = 0f;
        }

        private static Vector3 Rate(Quaternion from, Quaternion to, float seconds)
        {
            Quaternion turn = to * Quaternion.Inverse(from);
            float sign = turn.w < 0f ? -1f : 1f;
            var axis = new Vector3(sign * turn.x, sign * turn.y, sign * turn.z);
            float sine = axis.magnitude;
            if (sine < 1e-6f)
                return Vector3.zero;
            float angle = 2f * math.atan2(sine, sign * turn.w);
            return axis * (angle / (sine * seconds));
        }
    }
}
