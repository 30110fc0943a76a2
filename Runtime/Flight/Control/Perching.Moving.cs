using Unity.Mathematics;

namespace Alate.Flight
{
    /// <summary>A perch that moves, and whoever moves the insect on it.</summary>
    internal partial struct Perching
    {
        /// <summary>Steps without a motion along the normal after which a perch is still: frames may be longer than steps.</summary>
        private const int k_Still = 5;

        /// <summary>Longest way of a perch between two steps, metres: what jumps farther is another place.</summary>
        private const float k_MostJump = 0.2f;

        // A perch that goes up and down is left where it begins to sink: a small insect would be overtaken.
        private readonly bool IsMomentToLeave => m_IsOnTop || m_Unmoved >= k_Still;

        /// <summary>Takes the spot along with whoever moves the insect.</summary>
        /// <param name="from">A point that goes along, world units.</param>
        /// <param name="to">Where it goes.</param>
        /// <param name="turn">Turn about the vertical.</param>
        public void Carry(float3 from, float3 to, quaternion turn)
        {
            m_FromRotation = math.mul(turn, m_FromRotation);
            m_FromVelocity = math.rotate(turn, m_FromVelocity);
            m_Seat = math.mul(turn, m_Seat);
            m_Normal = math.rotate(turn, m_Normal);
            m_Up = math.rotate(turn, m_Up);
            m_FromFeet = to + math.rotate(turn, m_FromFeet - from);
            m_Spot = to + math.rotate(turn, m_Spot - from);
            m_Feet = to + math.rotate(turn, m_Feet - from);
        }

        /// <summary>
        /// Goes along with a perch that moves: what sits goes with it, what comes down comes to where it is, and what pushes off is lifted
        /// by a perch that rises, but does not follow one that sinks or swings aside.
        /// </summary>
        /// <param name="body">The body.</param>
        /// <param name="spot">Where the perch is by now; one that is where it was told to be last does nothing.</param>
        public void Follow(ref FlyingBody body, in PerchSpot spot)
        {
            m_ToldBefore = m_Told.Position;
            m_Unmoved++;
            if (!m_Told.Move(spot, k_MostJump * Units, out float3 from, out quaternion turn))
            {
                m_ToldBefore = m_Told.Position;
                return;
            }

            float3 to = m_Told.Position;
            float rise = math.dot(to - from, m_Normal);
            m_Unmoved = rise == 0f ? m_Unmoved : 0;
            m_IsOnTop = m_Rises && rise < 0f;
            m_Rises = rise > 0f || m_Rises && rise == 0f;
            if (IsSeated)
            {
                Carry(from, to, turn);
                body.rotation = m_Seat = math.normalize(m_Seat);
            }
            else
            {
                if (m_Stage == Stage.Pushing)
                    m_FromFeet += math.max(rise, 0f) * m_Normal;
                m_Seat = math.normalize(math.mul(turn, m_Seat));
                m_Normal = math.rotate(turn, m_Normal);
                m_Up = math.rotate(turn, m_Up);
                m_Spot = to + math.rotate(turn, m_Spot - from);
            }

            m_Normal = math.normalize(m_Normal);
            m_Up = math.normalize(m_Up);
        }

        /// <summary>
        /// Takes a pose between steps along with a perch that has moved on since then: of an insect that sits wholly, on the way down the
        /// more the nearer it is.
        /// </summary>
        /// <param name="now">Where the perch is by now.</param>
        /// <param name="alpha">Share of the step that is over; 1 for the pose of an insect that sits.</param>
        /// <param name="rotation">Of the body.</param>
        /// <param name="centre">Its centre of mass, world units.</param>
        public readonly void Show(in PerchSpot now, float alpha, ref quaternion rotation, ref float3 centre)
        {
            PerchFrame frame = m_Told;
            bool hasMoved = frame.Move(now, k_MostJump * Units, out float3 from, out quaternion turn);
            if (IsSeated)
            {
                rotation = hasMoved ? math.mul(turn, rotation) : rotation;
                centre = hasMoved ? frame.Position + math.rotate(turn, centre - from) : centre;
                return;
            }

            float share = Smooth(m_Time / m_WayTime), held = m_Stage == Stage.ComingDown ? share : 1f - share;
            centre += held * ((hasMoved ? frame.Position : from) - math.lerp(m_ToldBefore, from, alpha));
        }
    }
}
