using Alate.Geometry;
using Unity.Mathematics;

namespace Alate.Flight
{
    /// <summary>
    /// Reference of the feedback, made from a pilot's command: what insects fly, bounded acceleration, a filter, turns on an arc, a heading
    /// that crabs into the wind, speeds and climbs of the table, and a rate that waits for an insect that has not followed. Once a fixed
    /// step.
    /// </summary>
    public struct FlightReference
    {
        /// <summary>Seconds of the filters of velocity and wind: a gust is met before it has blown the insect off its way.</summary>
        private const float k_Filter = 0.1f, k_WindFilter = 0.07f;

        /// <summary>
        /// Share of the largest change of velocity that an insect follows at rest, and share of the top speed from which it follows all:
        /// trims change most where it is slow, and one that changes its speed faster than its beat can follow rocks.
        /// </summary>
        private const float k_SlowShare = 0.25f, k_Nimble = 0.45f;

        /// <summary>
        /// Speed above which the insect looks along its way and turns on an arc: m/s, and at most a share of the top speed.
        /// </summary>
        private const float k_Cruising = 0.3f, k_CruisingShare = 0.25f;

        /// <summary>Fastest turn of a slow insect's heading, rad/s, and rate at which it is approached, 1/s.</summary>
        private const float k_MostTurning = 3f, k_Turning = 4f;

        /// <summary>
        /// Share of the largest change of velocity by which the wanted climb of a cruising insect changes, 0.7 m/s² of what flies: with it
        /// pitch, beat and bob change more than a monarch can follow in a turn.
        /// </summary>
        private const float k_ClimbShare = 0.28f;

        /// <summary>
        /// Velocity error from which the reference of a cruising insect comes towards it, m/s, and its rate, 1/s: a monarch that has lost
        /// its speed does not get it back at once.
        /// </summary>
        private const float k_Lost = 0.15f, k_Yield = 6f;

        /// <summary>
        /// Velocity error, m/s, at which the reference waits for the insect, and share of its rate and of a slow insect's turning that is
        /// left then: one that is told to go on before it has followed rocks, overshoots and tumbles.
        /// </summary>
        private const float k_Waits = 0.2f, k_LeastRate = 0.05f;

        /// <summary>
        /// Seconds in which the rate of a guarded reference sets in: one that jumps rocks a slow insect from its first beat.
        /// </summary>
        private const float k_SetsIn = 0.03f;

        /// <summary>Fastest turn into a gust, rad/s, and seconds in which the heading of a fast insect gets to its course.</summary>
        private const float k_MostCrabbing = 10f, k_Course = 0.03f;

        /// <summary>
        /// Heading from which on a hovering insect sets off, radians off its way, and share of the cruising speed that it creeps with
        /// before.
        /// </summary>
        private const float k_Aligned = 0.6f, k_Slow = 0.5f;

        /// <summary>Share of the table's top speed that the air speed may reach.</summary>
        private const float k_Beyond = 1.1f;

        /// <summary>Part of a rotation about the world's up, squared, above which it has a heading: one by half a turn has none.</summary>
        private const float k_HasHeading = 0.01f;

        private float3 m_Velocity, m_Rate;
        private float m_Turning, m_Aim, m_Cruising, m_Climb;

        /// <summary>Velocity over ground, m/s.</summary>
        public float3 Velocity => m_Velocity;

        /// <summary>Heading, radians.</summary>
        public float Heading { get; private set; }

        /// <summary>Smoothed velocity of the air, m/s.</summary>
        public float3 Wind { get; private set; }

        // Level, as the speeds of the table are.
        private readonly float AirSpeed => math.length((m_Velocity - Wind).xz);

        /// <summary>Starts at a motion.</summary>
        public FlightReference(float3 velocity, float heading, float3 wind)
        {
            m_Velocity = velocity;
            m_Rate = default;
            m_Climb = velocity.y;
            m_Turning = 0f;
            m_Aim = float.NaN;
            m_Cruising = k_Cruising;
            Heading = heading;
            Wind = wind;
        }

        /// <summary>Situation of a body that follows this reference, in a scene of life size.</summary>
        internal readonly FlightSituation Situation(in FlyingBody body) => new FlightSituation
        {
            position = body.position,
            rotation = body.rotation,
            velocity = body.velocity,
            angularVelocity = math.rotate(body.rotation, body.spin),
            wind = Wind,
            referenceVelocity = m_Velocity,
            heading = Heading,
            unitsPerMetre = 1f,
        };

        /// <summary>Reference turned about the world's up, radians.</summary>
        internal FlightReference Turned(float by)
        {
            quaternion turn = Rotations.AboutY(by);
            FlightReference turned = this;
            turned.m_Velocity = math.rotate(turn, m_Velocity);
            turned.m_Rate = math.rotate(turn, m_Rate);
            turned.Heading += by;
            return turned;
        }

        /// <summary>Leads an insect by a step: towards what is commanded, or out of a tumble.</summary>
        /// <param name="body">The insect, whose reference is set.</param>
        /// <param name="command">Velocity and heading are taken.</param>
        /// <param name="table">Bounds of speed and climb.</param>
        /// <param name="isGuarded">False follows commands that insects cannot fly, and rights no insect.</param>
        /// <param name="dt">Seconds.</param>
        internal void Lead(ref FlyingBody body, in FlightCommand command, TrimTable table, bool isGuarded, float dt)
        {
            body.recovers = isGuarded ? 1 : 0;
            body.reference = body.rights != 0
                ? Right(body, table, dt)
                : Step(command.velocity, command.heading, body.wind, body.velocityError, table, isGuarded, dt);
        }

        /// <summary>Moves on by a step towards what is wanted.</summary>
        /// <param name="wanted">Velocity over ground, m/s.</param>
        /// <param name="heading">Wanted heading, radians; not a number follows the way.</param>
        /// <param name="wind">Velocity of the air, m/s.</param>
        /// <param name="error">Velocity of the insect relative to the reference at its last beat, less the bob, m/s along the heading's
        /// axes.</param>
        /// <param name="table">Bounds of speed and climb.</param>
        /// <param name="isGuarded">False follows commands that insects cannot fly, without waiting for the insect.</param>
        /// <param name="dt">Seconds.</param>
        /// <returns>What the bodies' feedback follows within the step.</returns>
        internal BodyReference Step(float3 wanted, float heading, float3 wind, float3 error, TrimTable table, bool isGuarded, float dt)
        {
            // Squares of larger ones overflow; what is no number hovers.
            float largest = math.cmax(math.abs(wanted));
            wanted = math.all(math.isfinite(wanted)) ? wanted * math.min(1f, OuterBounds.Speed / math.max(largest, 1f)) : default;
            FlightLimits limits = table.Limits;
            m_Cruising = math.min(k_Cruising, k_CruisingShare * limits.TopSpeed);
            Feel(wind, dt);
            if (isGuarded)
            {
                wanted -= Wind;
                CommandGuard.Limit(ref wanted, ref heading, m_Velocity - Wind, Heading, m_Cruising / k_Cruising);
                wanted += Wind;
            }

            float share = isGuarded ? math.max(1f - math.length(error) * (1f / k_Waits), k_LeastRate) : 1f;
            wanted.y = Climb(wanted.y, limits, dt);
            float3 target = OnAnArc(Bounded(wanted, table, limits), limits);
            float3 rate = Followed((target - m_Velocity) * (1f / k_Filter), limits);
            if (isGuarded)
            {
                rate *= share;
                rate = m_Rate + (1f - Elementary.Exp(-dt / k_SetsIn)) * (rate - m_Rate);
            }

            m_Rate = rate;
            var reference = new BodyReference { velocity = m_Velocity, acceleration = rate };
            Turn(heading, share, dt);
            reference.heading = Heading;
            reference.turning = m_Turning;
            Heading += m_Turning * dt;
            m_Velocity += rate * dt + Lost(error) * (1f - Elementary.Exp(-k_Yield * dt));

            float3 air = m_Velocity - Wind;
            Elementary.SinCos(Heading, out float sin, out float cos);
            reference.airSpeed = air.x * sin + air.z * cos;
            reference.climb = air.y;
            return reference;
        }

        /// <summary>
        /// Moves on by a step with an insect that rights itself: fast ahead along its own heading, in the trims that are the steadiest,
        /// with what it falls as far as they close, and level where it rises: one that climbs as it turns over has no speed left to pull
        /// out with. From there it flies on as it is told.
        /// </summary>
        /// <param name="body">The insect.</param>
        /// <param name="table">Bounds of speed and climb.</param>
        /// <param name="dt">Seconds.</param>
        /// <returns>What the body's feedback follows within the step.</returns>
        internal BodyReference Right(in FlyingBody body, TrimTable table, float dt)
        {
            FlightLimits limits = table.Limits;
            Feel(body.wind, dt);
            float4 q = body.rotation.value;
            if (q.y * q.y + q.w * q.w > k_HasHeading)
                Heading = 2f * Elementary.Atan2(q.y, q.w);
            Elementary.SinCos(Heading, out float sin, out float cos);
            table.Climbs(limits.TopSpeed, out float least, out float most);
            float climb = math.clamp(body.velocity.y - Wind.y, least, math.min(most, 0f));
            m_Velocity = Wind + new float3(limits.TopSpeed * sin, climb, limits.TopSpeed * cos);
            m_Climb = m_Velocity.y;
            m_Rate = default;
            m_Turning = 0f;
            return new BodyReference { velocity = m_Velocity, heading = Heading, airSpeed = limits.TopSpeed, climb = climb };
        }

        private void Feel(float3 wind, float dt) => Wind += (1f - Elementary.Exp(-dt / k_WindFilter)) * (wind - Wind);

        private float Climb(float wanted, in FlightLimits limits, float dt)
        {
            wanted = math.clamp(wanted, Wind.y + limits.LeastClimb, Wind.y + limits.MostClimb);
            float most = AirSpeed > m_Cruising ? k_ClimbShare * limits.Acceleration * dt : float.PositiveInfinity;
            m_Climb += math.clamp(wanted - m_Climb, -most, most);
            return m_Climb;
        }

        private float3 Lost(float3 error)
        {
            float size = math.length(error);
            if (!(size > k_Lost) || AirSpeed < m_Cruising)
                return default;
            return math.rotate(Rotations.AboutY(Heading), error * (1f - k_Lost / size));
        }

        // Ahead and up a slow insect follows less, across its nose it goes with the air at once.
        private float3 Followed(float3 rate, in FlightLimits limits)
        {
            float most = limits.Acceleration * math.lerp(k_SlowShare, 1f, math.saturate(AirSpeed / (k_Nimble * limits.TopSpeed)));
            Elementary.SinCos(Heading, out float sin, out float cos);
            var right = new float3(cos, 0f, -sin);
            float3 aside = math.dot(rate, right) * right, ahead = rate - aside;
            ahead *= math.min(1f, most / math.max(math.length(ahead), 1e-6f));
            rate = ahead + aside;
            return rate * math.min(1f, limits.Acceleration / math.max(math.length(rate), 1e-6f));
        }

        // Through the air the insect is not faster than its table, more wind carries it; climbs as far as the table closes.
        private float3 Bounded(float3 wanted, TrimTable table, in FlightLimits limits)
        {
            float3 air = wanted - Wind;
            float speed = math.length(air.xz);
            float most = k_Beyond * limits.TopSpeed;
            if (speed > most)
                air.xz *= most / speed;
            table.Climbs(math.min(speed, most), out float least, out float fastest);
            air.y = math.clamp(air.y, least, fastest);
            return air + Wind;
        }

        // A fast insect does not fly sideways or backwards: its course turns no faster than its acceleration allows.
        private float3 OnAnArc(float3 target, in FlightLimits limits)
        {
            float2 from = (m_Velocity - Wind).xz, to = (target - Wind).xz;
            float speed = math.length(from), wanted = math.length(to);
            m_Aim = float.NaN;
            if (speed < m_Cruising && wanted > m_Cruising)
            {
                // From hovering it turns first, then goes.
                float aim = Elementary.Atan2(to.x, to.y);
                if (math.abs(Headings.Wrap(aim - Heading)) < k_Aligned)
                    return target;
                m_Aim = aim;
                float2 slow = to * (m_Cruising * k_Slow / wanted);
                return new float3(slow.x + Wind.x, target.y, slow.y + Wind.z);
            }

            if (speed < m_Cruising || wanted < 1e-3f)
                return target;
            float angle = Elementary.Atan2(from.y * to.x - from.x * to.y, math.dot(from, to));
            float most = limits.TurnRate(speed) * k_Filter;
            if (math.abs(angle) <= most)
                return target;
            Elementary.SinCos(math.clamp(angle, -most, most), out float sin, out float cos);
            float2 along = from / speed;
            float length = math.abs(angle) > 0.5f * math.PI ? math.max(wanted, m_Cruising) : wanted;
            float2 turned = length * new float2(along.x * cos + along.y * sin, along.y * cos - along.x * sin);
            return new float3(turned.x + Wind.x, target.y, turned.y + Wind.z);
        }

        private void Turn(float wanted, float share, float dt)
        {
            float2 air = (m_Velocity - Wind).xz;
            float speed = math.length(air);
            float course = Elementary.Atan2(air.x, air.y);
            if (speed <= m_Cruising && math.isfinite(m_Aim))
                wanted = m_Aim;
            else if (speed > m_Cruising || (!math.isfinite(wanted) && speed > 0.5f * m_Cruising))
                wanted = course;
            float error = math.isfinite(wanted) ? Headings.Wrap(wanted - Heading) : 0f;
            if (speed > m_Cruising)
            {
                // The course is smooth already: a heading that lagged behind it would fly sideways through a gust.
                m_Turning = math.clamp(error / math.max(dt, k_Course), -k_MostCrabbing, k_MostCrabbing);
                return;
            }

            float turning = share * math.clamp(k_Turning * error, -k_MostTurning, k_MostTurning);
            m_Turning += (1f - Elementary.Exp(-dt / k_Filter)) * (turning - m_Turning);
        }
    }
}
