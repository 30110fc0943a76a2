using Unity.Mathematics;

namespace Alate.Flight
{
    /// <summary>
    /// Body of an insect that sits: from the contact on the feet glide to the spot and the body onto the surface and to the wanted heading; before a start the wings beat
    /// themselves up to a hover while the legs hold on, then the legs push the insect off as the wings are about to beat down.
    /// </summary>
    internal struct Perching
    {
        /// <summary>Seconds in which the body settles, and rate of its turn on the feet, rad/s.</summary>
        private const float k_SettleTime = 0.2f, k_Turning = 6f;

        /// <summary>Beats before the legs let go.</summary>
        private const float k_StartBeats = 3f;

        /// <summary>Share of a beat from which on the wings are raised enough to let go, and beats after which the legs let go anyhow.</summary>
        private const float k_Raised = 0.7f, k_MostBeats = 5f;

        /// <summary>Speed with which the legs push off, m/s. Chosen below the jumps of moths.</summary>
        private const float k_Jump = 0.2f;

        private quaternion m_Contact, m_Seat;
        private float3 m_ContactFeet, m_Spot, m_Up, m_Feet;
        private float m_Heading, m_SettleTime;
        private float m_Time, m_Started;

        /// <summary>The contact: the body moves no more by itself.</summary>
        /// <param name="body">The body.</param>
        /// <param name="spot">Where it sits.</param>
        /// <param name="centre">Its centre of mass, world units.</param>
        /// <param name="legs">From the centre of mass to the feet in body axes, world units.</param>
        public Perching(ref FlyingBody body, in PerchSpot spot, float3 centre, float3 legs)
        {
            float3 up = math.normalizesafe(spot.normal, new float3(0f, 1f, 0f));
            math.sincos(spot.heading, out float sin, out float cos);
            var ahead = new float3(sin, 0f, cos);
            ahead = math.normalizesafe(ahead - up * math.dot(ahead, up), math.normalizesafe(math.cross(new float3(1f, 0f, 0f), up), new float3(0f, 0f, 1f)));
            m_Seat = quaternion.LookRotation(ahead, up);
            m_Heading = math.atan2(ahead.x, ahead.z);
            m_Spot = spot.position;
            m_Up = math.normalizesafe(up + new float3(0f, 1f, 0f), up);
            m_Contact = body.rotation;
            m_SettleTime = k_SettleTime + math.length(BodyMotion.Log(math.mul(m_Seat, math.conjugate(m_Contact)))) / k_Turning;
            m_ContactFeet = m_Feet = centre + math.rotate(body.rotation, legs);
            m_Time = m_Started = 0f;
            Hold(ref body);
        }

        /// <summary>Takes the spot along with whoever moves the insect.</summary>
        /// <param name="from">A point that goes along, world units.</param>
        /// <param name="to">Where it goes.</param>
        /// <param name="turn">Turn about the vertical.</param>
        /// <param name="angle">Its angle, radians.</param>
        public void Carry(float3 from, float3 to, quaternion turn, float angle)
        {
            m_Contact = math.mul(turn, m_Contact);
            m_Seat = math.mul(turn, m_Seat);
            m_Up = math.rotate(turn, m_Up);
            m_Heading += angle;
            m_ContactFeet = to + math.rotate(turn, m_ContactFeet - from);
            m_Spot = to + math.rotate(turn, m_Spot - from);
            m_Feet = to + math.rotate(turn, m_Feet - from);
        }

        /// <summary>Sits on.</summary>
        public void Sit(ref FlyingBody body, float dt)
        {
            m_Time += dt;
            m_Started = 0f;
            float share = Smooth(m_Time / m_SettleTime);
            body.rotation = math.slerp(m_Contact, m_Seat, share);
            m_Feet = math.lerp(m_ContactFeet, m_Spot, share);
        }

        /// <summary>Velocity with which the legs push the insect off, m/s.</summary>
        public readonly float3 Jump => k_Jump * m_Up;

        /// <summary>Beats the wings up.</summary>
        /// <returns>Whether the legs may let go.</returns>
        public bool Start(ref FlyingBody body, WingWorld world, BodyHandle handle, in WingDrive hover, LiveInsect live, float dt)
        {
            if (m_Started == 0f)
            {
                body.reference = new BodyReference { heading = m_Heading };
                foreach (LiveWing wing in live.wings)
                    world.SetDrive(wing.handle, hover);
            }

            m_Started += dt;
            float share = m_Started * hover.frequency / k_StartBeats;
            world.PlaceOnBob(handle);
            m_Feet = m_Spot;
            bool isRaised = world.Read(live.wings[0].handle).Phase > k_Raised * 2f * math.PI || hover.frequency * dt > 1f - k_Raised;
            if (share >= 1f && (isRaised || share > k_MostBeats / k_StartBeats))
                return true;
            body.rotation = math.slerp(m_Seat, body.rotation, Smooth(share));
            Hold(ref body);
            return false;
        }

        /// <summary>Centre of mass with the feet where they are, world units.</summary>
        public readonly float3 Centre(quaternion rotation, float3 legs) => m_Feet - math.rotate(rotation, legs);

        private static void Hold(ref FlyingBody body)
        {
            body.mode = BodyMode.Resting;
            body.velocity = body.spin = body.acceleration = body.spinRate = default;
        }

        private static float Smooth(float share)
        {
            share = math.saturate(share);
            return share * share * (3f - 2f * share);
        }
    }
}
