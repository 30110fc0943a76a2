using Unity.Mathematics;

namespace Alate.Flight
{
    /// <summary>
    /// The way down to one spot: to a place before it, then along a straight line, slower and slower, until the feet reach it; up again and once more where the insect came
    /// down beside it.
    /// </summary>
    public sealed class Landing
    {
        /// <summary>Fastest contact, m/s.</summary>
        public const float ContactSpeed = 0.28f;

        /// <summary>Speed with which the feet come down, m/s.</summary>
        private const float k_TouchSpeed = 0.12f;

        /// <summary>Fastest way along the line, m/s.</summary>
        private const float k_LineSpeed = 0.15f;

        /// <summary>Rate of the speed along the line, 1/s.</summary>
        private const float k_FlareRate = 1.2f;

        /// <summary>Rate at which the insect gets back to the line, 1/s.</summary>
        private const float k_LineRate = 1.5f;

        /// <summary>Rate at which a steady drift off the line is learned, 1/s², and the fastest drift, m/s.</summary>
        private const float k_DriftRate = 1f, k_MostDrift = 0.08f;

        /// <summary>Length of the line, metres, where the insect can stop within.</summary>
        private const float k_LineLength = 0.25f;

        /// <summary>What the legs reach, wing lengths.</summary>
        private const float k_Reach = 0.12f;

        /// <summary>How far beside the spot the insect may be when it comes down, wing lengths.</summary>
        private const float k_Beside = 0.15f;

        /// <summary>Growth of that distance with the height above the spot.</summary>
        private const float k_Funnel = 0.3f;

        /// <summary>Distance beside the spot from which it is near, metres.</summary>
        private const float k_Near = 0.3f;

        /// <summary>Seconds and speed, m/s, of flying on for another try.</summary>
        private const float k_RoundTime = 1.6f, k_RoundSpeed = 0.65f;

        /// <summary>Seconds after which a line is flown again.</summary>
        private const float k_Patience = 8f;

        /// <summary>Tries after which the insect lands whichever way it looks.</summary>
        private const int k_TriesByHeading = 3;

        private PerchSpot m_Spot;
        private readonly float3 m_Line;
        private readonly float m_Stand;
        private float m_LineTime, m_RoundTime;
        private float3 m_Drift, m_Round;

        /// <param name="spot">Where to land.</param>
        /// <param name="stand">Height of the centre of mass over the feet, metres of the insect.</param>
        public Landing(in PerchSpot spot, float stand)
        {
            m_Spot = spot;
            m_Spot.normal = math.normalizesafe(spot.normal, new float3(0f, 1f, 0f));
            m_Line = math.normalizesafe(m_Spot.normal + new float3(0f, 1f, 0f), m_Spot.normal);
            m_Stand = stand;
        }

        /// <summary>The spot.</summary>
        public PerchSpot Spot => m_Spot;

        /// <summary>Whether the insect is on the line.</summary>
        public bool IsFlaring { get; private set; }

        /// <summary>How often the insect flew up again.</summary>
        public int Attempts { get; private set; }

        /// <summary>Command for the next step.</summary>
        public FlightCommand Next(in FlightSituation situation)
        {
            float unit = situation.unitsPerMetre;
            float3 seat = m_Spot.position + m_Stand * unit * m_Spot.normal;
            float3 off = (situation.position - seat) / unit;
            if (!IsFlaring)
                return Approach(situation, seat, off);

            m_LineTime += situation.deltaTime;
            float gap = math.dot(off, m_Spot.normal), along = math.dot(off, m_Line);
            float3 beside = off - along * m_Line, flat = off - gap * m_Spot.normal;
            float reach = k_Reach * situation.wingLength, near = k_Beside * situation.wingLength;
            bool isOver = math.length(flat) < near + 0.5f * math.max(gap, 0f);
            if (math.abs(gap + 0.5f * reach) < 1.5f * reach && isOver && math.length(situation.velocity) < ContactSpeed)
            {
                if (!math.isfinite(m_Spot.heading))
                    m_Spot.heading = situation.heading;
                return Wish(FlightWish.Perch, default, situation);
            }

            if (m_LineTime > k_Patience || gap < -2f * reach || math.length(beside) > 4f * near + 0.1f + 0.6f * math.max(along, 0f))
                return GoRound(situation);

            // Beside the line the insect waits above the spot.
            float straight = math.saturate(2f - math.length(beside) / (near + k_Funnel * math.max(gap, 0f)));
            float down = gap > 0f ? math.clamp(k_FlareRate * along, k_TouchSpeed, k_LineSpeed) * straight : -0.1f;
            m_Drift += k_DriftRate * situation.deltaTime * beside;
            m_Drift *= math.min(1f, k_MostDrift / math.max(math.length(m_Drift), 1e-6f));
            float3 back = math.min(k_LineRate * math.length(beside), NoseFirst.MostAside) * math.normalizesafe(beside) + m_Drift;
            return Wish(FlightWish.Land, -down * m_Line - back, situation);
        }

        private FlightCommand Approach(in FlightSituation situation, float3 seat, float3 off)
        {
            if (m_RoundTime > 0f)
            {
                m_RoundTime -= situation.deltaTime;
                return Wish(FlightWish.Land, m_Round, situation);
            }

            float along = math.dot(off, m_Line);
            if (math.length(off.xz) < k_Near && math.dot(off, m_Spot.normal) < 0f)
                return GoRound(situation);
            if (along > 0f && math.length(off - along * m_Line) < math.max(0.05f, 0.4f * along) && math.length(situation.referenceVelocity) < k_LineSpeed)
            {
                IsFlaring = true;
                m_LineTime = -along / (0.5f * k_LineSpeed);
                m_Drift = default;
            }

            // Hovering insects hardly climb: near the spot the height that there is has to do.
            float3 velocity = LineTop(situation, seat);
            if (math.length(off.xz) < k_Near)
                velocity.y = math.min(velocity.y, 0f);
            return Wish(FlightWish.Land, velocity, situation);
        }

        // Ahead and up for another try.
        private FlightCommand GoRound(in FlightSituation situation)
        {
            IsFlaring = false;
            if (++Attempts == k_TriesByHeading)
                m_Spot.heading = float.NaN;
            m_RoundTime = k_RoundTime;
            math.sincos(situation.heading, out float sin, out float cos);
            var ahead = new float3(sin, 0f, cos);
            m_Round = math.min(k_RoundSpeed, situation.limits.TopSpeed) * math.normalizesafe(ahead + m_Spot.normal * new float3(1f, 0f, 1f)) + new float3(0f, situation.limits.MostClimb, 0f);
            return Wish(FlightWish.Land, m_Round, situation);
        }

        private float3 LineTop(in FlightSituation situation, float3 seat) =>
            PathFollower.Towards(situation, seat + m_Line * Length(situation.limits) * situation.unitsPerMetre, default, 0.7f * situation.limits.TopSpeed);

        private static float Length(in FlightLimits limits) => math.max(k_LineLength, limits.StoppingDistance(k_LineSpeed));

        private FlightCommand Wish(FlightWish wish, float3 velocity, in FlightSituation situation) =>
            NoseFirst.Limit(new FlightCommand { velocity = velocity, heading = m_Spot.heading, wish = wish, spot = m_Spot }, situation);
    }
}
