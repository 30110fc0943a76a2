using Alate.Geometry;
using Unity.Mathematics;
using UnityEngine;

namespace Alate
{
    /// <summary>
    /// Velocity and turn rate of a body from its position frame by frame. Samples longer times far from the origin, where positions are
    /// coarse; a jump is told from motion and does not enter the velocity.
    /// </summary>
    internal struct MotionSampler
    {
        /// <summary>
        /// Time over which a new velocity is taken over, seconds; a beat or less, so that jitter of frame times does not shake the wings.
        /// </summary>
        private const float k_Smoothing = 0.05f;

        /// <summary>Longest time of a sample, seconds.</summary>
        private const float k_LongestWindow = 0.5f;

        private Vector3 m_Position, m_WindowPosition, m_JumpVelocity, m_JumpRate;
        private Quaternion m_Rotation, m_WindowRotation;
        private float m_Window;
        private bool m_Started, m_Moving, m_Jumped;

        /// <summary>Velocity of the body, world units per second.</summary>
        public Vector3 Velocity { get; private set; }

        /// <summary>Angular velocity of the body, radians per second about the world's axes.</summary>
        public Vector3 AngularVelocity { get; private set; }

        /// <summary>Marks a jump of the body, just made or about to be: its motion stays unchanged at the next position.</summary>
        public void Interrupt() => m_Started = false;

        /// <summary>Samples the body after some time, seconds; its position may be anywhere where no time has passed.</summary>
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

            Vector3 velocity = (position - m_Position) / dt, rate = Rate(m_Rotation, rotation, dt);
            if (!IsNear(velocity, Velocity, jump / dt) || !IsNear(rate, AngularVelocity, turn * Mathf.Deg2Rad / dt))
            {
                // Two jumps in a row that are alike are no jumps but a motion that began of a sudden.
                bool isMotion = m_Jumped && IsNear(velocity, m_JumpVelocity, jump / dt)
                    && IsNear(rate, m_JumpRate, turn * Mathf.Deg2Rad / dt);
                m_JumpVelocity = velocity;
                m_JumpRate = rate;
                m_Jumped = true;
                Rebase(position, rotation);
                if (isMotion)
                    TakeOver(velocity, rate, 1f);
                return !isMotion;
            }

            m_Jumped = false;
            m_Position = position;
            m_Rotation = rotation;
            m_Window += dt;
            if (m_Window >= math.min(4f * Resolution(position) / finest, k_LongestWindow))
                CloseWindow();
            return false;
        }

        private static bool IsNear(Vector3 a, Vector3 b, float distance) => (a - b).magnitude <= distance;

        private void Rebase(Vector3 position, Quaternion rotation)
        {
            m_Position = m_WindowPosition = position;
            m_Rotation = m_WindowRotation = rotation;
            m_Window = 0f;
            m_Started = true;
        }

        // The distance between neighbouring floats at a place.
        private static float Resolution(Vector3 position)
        {
            float largest = math.cmax(math.abs((float3)position));
            return largest * 1.2e-7f;
        }

        private void CloseWindow()
        {
            float share = m_Moving ? 1f - Elementary.Exp(-m_Window / k_Smoothing) : 1f;
            TakeOver((m_Position - m_WindowPosition) / m_Window, Rate(m_WindowRotation, m_Rotation, m_Window), share);
            m_WindowPosition = m_Position;
            m_WindowRotation = m_Rotation;
            m_Window = 0f;
        }

        private void TakeOver(Vector3 velocity, Vector3 rate, float share)
        {
            Velocity += share * (velocity - Velocity);
            AngularVelocity += share * (rate - AngularVelocity);
            m_Moving = true;
        }

        private static Vector3 Rate(Quaternion from, Quaternion to, float seconds)
        {
            Quaternion turn = to * Quaternion.Inverse(from);
            float sign = turn.w < 0f ? -1f : 1f;
            var axis = new Vector3(sign * turn.x, sign * turn.y, sign * turn.z);
            float sine = axis.magnitude;
            if (sine < 1e-6f)
                return Vector3.zero;
            float angle = 2f * Elementary.Atan2(sine, sign * turn.w);
            return axis * (angle / (sine * seconds));
        }
    }
}
