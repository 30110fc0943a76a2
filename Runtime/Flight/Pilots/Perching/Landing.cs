using Alate.Geometry;
using Unity.Mathematics;

namespace Alate.Flight
{
    /// <summary>
    /// The way down to one spot: to the top of a line that slopes down to a place above the spot, then along the line, slower and slower,
    /// until the insect is held there; on, up and once more where it missed that place. Comes in from where the insect is, turned towards
    /// the wanted heading and away from a slope that would be in the way.
    /// </summary>
    public sealed class Landing
    {
        /// <summary>Fastest flight, m/s, at which an insect is held; one that is too low to fly on is held at any speed.</summary>
        public const float HoldSpeed = 0.28f;

        /// <summary>
        /// Height of the feet over the spot, wing lengths, in which the insect is held: any lower a downstroke of its flight would pass
        /// through what it lands on.
        /// </summary>
        public const float Clearance = 1.2f;

        /// <summary>
        /// Distance from there within which it is held, and within which it does not wait for a nearer place, wing lengths.
        /// </summary>
        private const float k_Reach = 0.4f, k_Close = 0.3f;

        /// <summary>Seconds for which what rises to an overhang is taken to go on rising.</summary>
        private const float k_RiseTime = 0.035f;

        /// <summary>Reach aside of one that is too low to fly on, over the reach of the others.</summary>
        private const float k_LowReach = 2f;

        /// <summary>
        /// Height of the line over its length on the ground: as slow insects sink, and below a ceiling, where they climb; and upward part
        /// of an overhang's normal from which on the line turns from one to the other.
        /// </summary>
        private const float k_Rise = 0.45f, k_Climb = -0.15f, k_Overhang = -0.5f;

        /// <summary>Distance of the line's top from the spot, metres, where the insect can stop within.</summary>
        private const float k_LineLength = 0.45f;

        /// <summary>Fastest flight along the line, m/s, and growth of the speed with the distance, 1/s.</summary>
        private const float k_LineSpeed = 0.12f, k_FlareRate = 0.8f;

        /// <summary>
        /// Slowest flight ahead along the line, m/s, where it is not slower itself, and distance along it, wing lengths, up to which the
        /// slip may take it below.
        /// </summary>
        private const float k_LeastAhead = 0.1f, k_Far = 4f;

        /// <summary>Fastest braking where the line is long enough, m/s²: one that brakes as it gets going tumbles.</summary>
        private const float k_Brake = 1f;

        /// <summary>
        /// Way before the spot that is flown at the speed of its end, metres: what braking throws off the line is flown out there.
        /// </summary>
        private const float k_Steady = 0.05f;

        /// <summary>
        /// Speed at the end of the line: wing lengths a second, and its bounds, m/s. What has a short reach comes slower.
        /// </summary>
        private const float k_Touch = 5f, k_LeastTouch = 0.05f, k_MostTouch = 0.12f;

        /// <summary>Fastest approach to the surface: over the height above it, 1/s, and what is added to it, m/s.</summary>
        private const float k_SettleRate = 3f, k_Settle = 0.02f;

        /// <summary>
        /// Most by which the wanted sinking is faster than the flown one, m/s: one that rises while ever more is asked for rocks, and
        /// tumbles.
        /// </summary>
        private const float k_Sink = 0.1f;

        /// <summary>Rate at which the insect gets back to the line, 1/s.</summary>
        private const float k_LineRate = 2f;

        /// <summary>
        /// Rate at which a steady drift off the line is learned, 1/s², distance from the line within which it is, metres, and the fastest
        /// drift, m/s.
        /// </summary>
        private const float k_DriftRate = 1f, k_DriftWithin = 0.015f, k_MostDrift = 0.05f;

        /// <summary>
        /// Share of the difference between flown and followed velocity that is taken out at once, seconds over which it is averaged, and
        /// the most of it, m/s.
        /// </summary>
        private const float k_SlipShare = 0.5f, k_SlipTime = 0.1f, k_MostSlip = 0.12f;

        /// <summary>
        /// Distance off the line over the distance along it within which the insect begins, and from which it gives up, with what it may be
        /// off at the spot, metres.
        /// </summary>
        private const float k_Begin = 0.25f, k_GiveUp = 0.5f, k_Astray = 0.1f;

        /// <summary>
        /// Largest turn out of the straight way towards the wanted heading, and angle off the line's heading at which the insect begins,
        /// radians.
        /// </summary>
        private const float k_MostTurn = 0.8f, k_Aligned = 0.6f;

        /// <summary>
        /// Wind, m/s, above which the line is turned into it, wholly from twice of it: slow insects cannot fly backwards.
        /// </summary>
        private const float k_Calm = 0.1f;

        /// <summary>Height of the line over the surface, over its length on the ground: room for wings beside a slope.</summary>
        private const float k_Clearance = 0.3f;

        /// <summary>Distance from the spot within which an insect flies on and comes back, metres.</summary>
        private const float k_Near = 0.35f;

        /// <summary>Longest time, speed and way of flying on for another try: seconds, m/s, metres.</summary>
        private const float k_RoundTime = 1.6f, k_RoundSpeed = 0.65f, k_RoundWay = 0.6f;

        /// <summary>
        /// Change of the speed while flying on, m/s², and error of the velocity, m/s, up to which all of it is asked for, and from twice of
        /// which none: what was braked hard before still rocks, and one that speeds up as it rocks tumbles.
        /// </summary>
        private const float k_RoundChange = 1f, k_Rocking = 0.12f;

        /// <summary>Error of the velocity, m/s, from which an insect that is near enough is held at any speed.</summary>
        private const float k_MostRocking = 0.14f;

        /// <summary>Seconds within which the reference gets to what is asked for.</summary>
        private const float k_Response = 0.1f;

        /// <summary>Seconds after which a line is flown again.</summary>
        private const float k_Patience = 6f;

        private PerchSpot m_Spot;
        private readonly float m_Stand;
        private float m_LineTime, m_RoundTime, m_Heading, m_Distance;
        private float2 m_CourseWind;
        private PerchSway m_Sway;
        private bool m_HasCourse;
        private float3 m_Line, m_Drift, m_Slip, m_Round;

        /// <param name="spot">Where to land.</param>
        /// <param name="stand">Height of the centre of mass over the feet, metres of the insect.</param>
        public Landing(in PerchSpot spot, float stand)
        {
            m_Spot = spot;
            m_Spot.normal = math.normalizesafe(spot.normal, new float3(0f, 1f, 0f));
            m_Stand = stand;
            m_Sway = new PerchSway(spot.position);
        }

        /// <summary>The spot.</summary>
        public PerchSpot Spot => m_Spot;

        /// <summary>True where the insect is on the line.</summary>
        public bool IsFlaring { get; private set; }

        /// <summary>Number of times that the insect flew up again.</summary>
        public int Attempts { get; private set; }

        /// <summary>
        /// Tells where the spot is by now, each step. One that sways is flown to over the middle of its sway; the last wing length, which
        /// is guided, ends where it is then.
        /// </summary>
        /// <param name="spot">Where; finite. A heading that is not a number stays as it was.</param>
        /// <param name="deltaTime">Seconds since it was told last.</param>
        public void Follow(in PerchSpot spot, float deltaTime)
        {
            m_Spot.position = spot.position;
            m_Spot.normal = math.normalizesafe(spot.normal, m_Spot.normal);
            m_Spot.heading = math.isfinite(spot.heading) ? spot.heading : m_Spot.heading;
            m_Sway.Add(spot.position, deltaTime);
        }

        /// <summary>Command for the next step.</summary>
        public FlightCommand Next(in FlightSituation situation)
        {
            float unit = situation.unitsPerMetre;
            float3 seat = m_Sway.Middle
                + ((m_Stand + Clearance * situation.wingLength) * unit + m_Sway.Along(m_Spot.normal)) * m_Spot.normal;
            float3 off = (situation.position - seat) / unit;
            if (!m_HasCourse)
                ChooseCourse(situation, off);
            UpdateSlip(situation);
            return IsFlaring ? Flare(situation, off) : Approach(situation, seat, off);
        }

        private FlightCommand Flare(in FlightSituation situation, float3 off)
        {
            m_LineTime += situation.deltaTime;
            float reach = k_Reach * situation.wingLength, gap = math.dot(off, m_Spot.normal), along = math.dot(off, m_Line);
            float distance = math.length(off);
            bool isNearest = distance < k_Close * situation.wingLength || distance > m_Distance;
            m_Distance = distance;
            // Below an overhang the raised wings come first: what rises to it beside its reach is held before they do.
            bool isBelow = m_Spot.normal.y < k_Overhang && distance > reach;
            float rising = isBelow ? math.max(-math.dot(situation.velocity, m_Spot.normal), 0f) : 0f;
            bool isLow = gap - k_RiseTime * rising < -0.5f * reach && math.length(off - gap * m_Spot.normal) < k_LowReach * reach;
            bool isRocking = distance < k_LowReach * reach && math.length(m_Slip) > k_MostRocking;
            if (isLow || isRocking || distance < reach && isNearest && gap > -0.5f * reach && math.length(situation.velocity) < HoldSpeed)
            {
                if (!math.isfinite(m_Spot.heading))
                    m_Spot.heading = situation.heading;
                return Wish(FlightWish.Perch, default, situation);
            }

            float3 beside = off - along * m_Line;
            if (m_LineTime > k_Patience || gap < -1.5f * reach || along < -2f * reach
                || math.length(beside) > k_Astray + k_GiveUp * math.max(along, 0f))
            {
                return GoRound(situation);
            }

            float touch = math.clamp(k_Touch * situation.wingLength, k_LeastTouch, k_MostTouch);
            float speed = along > 0f ? math.min(touch + k_FlareRate * math.max(along - math.max(reach, k_Steady), 0f), k_LineSpeed) : 0f;
            if (along > k_LineLength)
                speed = math.max(speed, math.length(situation.referenceVelocity) - k_Brake * k_Response);
            if (math.length(beside) < k_DriftWithin)
                m_Drift += k_DriftRate * situation.deltaTime * beside;
            m_Drift *= math.min(1f, k_MostDrift / math.max(math.length(m_Drift), 1e-6f));
            float3 back = math.min(k_LineRate * math.length(beside), CommandGuard.MostAside) * math.normalizesafe(beside) + m_Drift;
            float3 velocity = OnCourse(-speed * m_Line - back, speed)
                - math.min(k_SlipShare, k_MostSlip / math.max(math.length(m_Slip), 1e-6f)) * m_Slip;
            if (along > k_Far * situation.wingLength)
                velocity = OnCourse(velocity, speed);
            velocity -= math.min(math.dot(velocity, m_Spot.normal) + (gap > 0f ? k_SettleRate * gap + k_Settle : 0f), 0f) * m_Spot.normal;
            return Wish(FlightWish.Land, velocity, situation);
        }

        // An insect over the line sinks to it and is not slowed down, nor is one asked for less that still brakes: where it is slow its
        // trims change most, and it rocks. Bounded aside it flies on ahead, and does not stop to turn its nose.
        private float3 OnCourse(float3 velocity, float speed)
        {
            float3 course = math.normalizesafe(new float3(-m_Line.x, 0f, -m_Line.z));
            var right = new float3(course.z, 0f, -course.x);
            float ahead = math.dot(velocity, course), aside = math.dot(velocity, right);
            float least = math.min(speed * math.length(m_Line.xz), k_LeastAhead);
            return math.max(ahead, least) * course + math.clamp(aside, -CommandGuard.MostAside, CommandGuard.MostAside) * right
                + new float3(0f, velocity.y, 0f);
        }

        private FlightCommand Approach(in FlightSituation situation, float3 seat, float3 off)
        {
            if (m_RoundTime > 0f)
            {
                m_RoundTime -= situation.deltaTime;
                if (m_RoundTime > 0f && math.length(off.xz) < k_RoundWay)
                    return Wish(FlightWish.Land, Round(situation), situation);
                m_RoundTime = 0f;
                ChooseCourse(situation, off);
            }

            if (math.distance(situation.wind.xz, m_CourseWind) > k_Calm)
                ChooseCourse(situation, off);
            float along = math.dot(off, m_Line);
            if (math.length(off.xz) < k_Near && math.dot(off, m_Spot.normal) < 0f)
                return GoRound(situation);
            if (along > 0.5f * k_LineLength && math.length(off - along * m_Line) < k_Begin * along
                && math.abs(Headings.Wrap(situation.heading - m_Heading)) < k_Aligned)
            {
                IsFlaring = true;
                m_LineTime = -along / (0.5f * k_LineSpeed);
                m_Drift = m_Slip = default;
                m_Distance = float.PositiveInfinity;
            }

            float length = math.max(k_LineLength, situation.limits.StoppingDistance(k_LineSpeed));
            return Wish(FlightWish.Land, PathFollower.Towards(
                situation, seat + m_Line * length * situation.unitsPerMetre, default, 0.7f * situation.limits.TopSpeed), situation);
        }

        // Straight in, or, from close by, on and back; turned towards the wanted heading, but not so that the slope is in the way.
        private void ChooseCourse(in FlightSituation situation, float3 off)
        {
            m_HasCourse = true;
            bool isNear = math.length(off.xz) < k_Near;
            m_Heading = isNear ? situation.heading + math.PI : Elementary.Atan2(-off.x, -off.z);
            if (math.isfinite(m_Spot.heading))
                m_Heading += math.clamp(Headings.Wrap(m_Spot.heading - m_Heading), -k_MostTurn, k_MostTurn);
            float2 wind = m_CourseWind = situation.wind.xz;
            float strength = math.length(wind);
            if (strength > k_Calm)
            {
                float upwind = Headings.Wrap(Elementary.Atan2(-wind.x, -wind.y) - m_Heading);
                m_Heading += math.saturate(strength / k_Calm - 1f) * upwind;
            }

            Elementary.SinCos(m_Heading, out float sin, out float cos);
            var course = new float2(sin, cos);
            float2 down = m_Spot.normal.xz;
            float rise = math.lerp(k_Rise, k_Climb, math.saturate((k_Overhang - m_Spot.normal.y) / (1f + k_Overhang)));
            float most = rise * m_Spot.normal.y - k_Clearance;
            if (math.dot(course, down) > most && math.lengthsq(down) > 1e-6f)
            {
                float2 slope = math.normalize(down);
                float outwards = math.clamp(most / math.length(down), -1f, 1f);
                float2 aside = course - slope * math.dot(course, slope);
                aside = math.lengthsq(aside) > PerchPlan.Rounding ? math.normalize(aside) : new float2(slope.y, -slope.x);
                course = outwards * slope + math.sqrt(1f - outwards * outwards) * aside;
                m_Heading = Elementary.Atan2(course.x, course.y);
            }

            m_Line = math.normalize(new float3(-course.x, rise, -course.y));
        }

        // Ahead and up for another try, below an overhang down.
        private FlightCommand GoRound(in FlightSituation situation)
        {
            IsFlaring = false;
            Attempts++;
            m_RoundTime = k_RoundTime;
            Elementary.SinCos(situation.heading, out float sin, out float cos);
            var ahead = new float3(sin, 0f, cos);
            m_Round = math.min(k_RoundSpeed, situation.limits.TopSpeed) * math.normalizesafe(ahead + m_Spot.normal * new float3(1f, 0f, 1f))
                + new float3(0f, PerchPlan.Rise(situation, m_Spot.normal), 0f);
            return Wish(FlightWish.Land, m_Round, situation);
        }

        private float3 Round(in FlightSituation situation)
        {
            float calm = math.saturate(2f - math.length(m_Slip) / k_Rocking);
            float most = math.length(situation.referenceVelocity.xz) + k_RoundChange * k_Response * calm;
            float3 velocity = m_Round;
            velocity.xz *= math.min(1f, most / math.max(math.length(velocity.xz), 1e-6f));
            return velocity;
        }

        private void UpdateSlip(in FlightSituation situation) =>
            m_Slip +=
                (1f - Elementary.Exp(-situation.deltaTime / k_SlipTime)) * (situation.velocity - situation.referenceVelocity - m_Slip);

        private FlightCommand Wish(FlightWish wish, float3 velocity, in FlightSituation situation)
        {
            float sinks = math.max(-(situation.referenceVelocity.y + m_Slip.y), 0f);
            velocity.y = math.max(velocity.y, -k_Sink - sinks);
            return new FlightCommand { velocity = velocity, heading = m_Heading, wish = wish, spot = m_Spot };
        }
    }
}
