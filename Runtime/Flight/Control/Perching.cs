using Alate.Geometry;
using Unity.Mathematics;

namespace Alate.Flight
{
    /// <summary>
    /// Body of an insect that a perch holds. Once its beat is raised, the body glides down from where a whole downstroke just clears the
    /// surface, turning onto the surface and to the wanted heading, and sits; before a start the raised wings beat while the legs hold on,
    /// then the legs push the body up to where the wings can beat wholly. The default value holds no insect.
    /// </summary>
    internal partial struct Perching
    {
        /// <summary>Fastest way down, m/s; shortest and longest time of it, seconds; rate of the body's turn, rad/s.</summary>
        private const float k_Gliding = 0.25f, k_SettleTime = 0.2f, k_MostTime = 1.5f, k_Turning = 6f;

        /// <summary>Fastest part of a smooth step over its mean.</summary>
        private const float k_MostSlope = 1.5f;

        /// <summary>
        /// Share of the way down in which the body turns onto the surface: the tails of a butterfly that is pitched up hang low.
        /// </summary>
        private const float k_TurnShare = 0.7f;

        /// <summary>Beats until the wings beat raised, and longest time in which a body that is held too low rises, seconds.</summary>
        private const float k_RaiseBeats = 1f, k_MostRaise = 0.3f;

        /// <summary>
        /// Beats before the legs push off, and longest times in which the insect turns on its feet before it and waits on a perch that goes
        /// up and down, seconds.
        /// </summary>
        private const float k_StartBeats = 3f, k_MostStanding = 1f, k_MostWait = 1.2f;

        /// <summary>
        /// Speed at the start and the end of the push, m/s, and its shortest time, seconds. Chosen within the jumps of moths.
        /// </summary>
        private const float k_Push = 0.6f, k_Jump = 0.2f, k_PushTime = 0.12f;

        /// <summary>
        /// Height of the push over that in which a downstroke clears the surface: most insects sink a little before they climb. What is
        /// added below a ceiling: the insect turns over meanwhile.
        /// </summary>
        private const float k_PushShare = 1.45f, k_OverhangPush = 0.3f;

        /// <summary>Share of the push off a ceiling that is over when the body begins to turn: it is away when it is upright.</summary>
        private const float k_TurnDelay = 0.5f;

        /// <summary>
        /// Share of a beat from which on the wings are raised enough to fly, and beats after the push within which they must be.
        /// </summary>
        private const float k_Raised = 0.7f, k_MostBeats = 4f;

        private Stage m_Stage;
        private quaternion m_FromRotation, m_Seat;
        private float3 m_FromFeet, m_FromVelocity, m_Spot, m_Normal, m_Up, m_Feet;
        private float m_Clearance, m_Time, m_WayTime, m_RaiseTime, m_Top, m_FromSpeed;
        private int m_WholeAfter, m_Unmoved;
        private PerchFrame m_Told;
        private float3 m_ToldBefore;
        private bool m_Rises, m_IsOnTop;

        /// <summary>Takes hold of an insect: the body moves no more by itself.</summary>
        /// <param name="body">The body.</param>
        /// <param name="spot">Where it is to sit.</param>
        /// <param name="centre">Its centre of mass, world units.</param>
        /// <param name="legs">From the centre of mass to the feet in body axes, world units.</param>
        /// <param name="clearance">Height of the feet in which a whole downstroke clears the surface, metres.</param>
        /// <param name="frequency">Of its wings' beat, hertz.</param>
        /// <param name="units">World units of a metre.</param>
        public Perching(ref FlyingBody body, in PerchSpot spot, float3 centre, float3 legs, float clearance, float frequency, float units)
        {
            this = default;
            m_Normal = math.normalizesafe(spot.normal, new float3(0f, 1f, 0f));
            m_Seat = Facing(spot.heading);
            m_Spot = spot.position;
            m_Told = new PerchFrame(spot.position, m_Normal, spot.heading);
            m_ToldBefore = spot.position;
            m_Unmoved = k_Still;
            m_Up = math.normalizesafe(m_Normal + new float3(0f, math.min(1f + m_Normal.y, 1f), 0f), m_Normal);
            m_Clearance = clearance;
            Units = units;
            m_Feet = centre + math.rotate(body.rotation, legs);
            ComeDown(ref body, body.velocity * units, clearance * units, frequency);
        }

        private enum Stage
        {
            Free,
            ComingDown,
            Seated,
            Standing,
            Pushing,
        }

        /// <summary>World units of a metre.</summary>
        public float Units { private get; set; }

        /// <summary>True where the perch moves the body.</summary>
        public readonly bool Holds => m_Stage != Stage.Free;

        private readonly float FromHeight => math.dot(m_FromFeet - m_Spot, m_Normal);

        // 0 on the ground and on walls, 1 below a ceiling.
        private readonly float Overhang => math.saturate(-1.4f * m_Normal.y);

        private readonly bool BeatsWhole => m_Stage == Stage.Pushing && m_WholeAfter >= 0;

        /// <summary>True where the feet are on the spot.</summary>
        public readonly bool IsSeated => m_Stage == Stage.Seated || m_Stage == Stage.Standing;

        /// <summary>Velocity with which the insect flies off, m/s.</summary>
        public readonly float3 Jump => k_Jump * m_Up;

        /// <summary>Comes down to the spot and sits there.</summary>
        public void Sit(ref FlyingBody body, in HeldWings wings, float dt)
        {
            if (m_Stage > Stage.Seated)
                ComeDown(ref body, default, BeatsWhole ? m_Clearance * Units : 0f, wings.Frequency);
            if (m_Stage == Stage.Seated)
                return;
            if (m_Time == 0f)
                wings.BeatRaised();
            m_Time += dt;
            float share = math.saturate(m_Time / m_WayTime);
            body.rotation = Rotations.Slerp(m_FromRotation, m_Seat, Smooth(share / k_TurnShare));
            m_Feet = math.lerp(m_FromFeet, m_Spot, Smooth(share)) + m_FromVelocity * (m_WayTime * share * (1f - share) * (1f - share));

            // The height has a course of its own, in place of its share of the straight way.
            m_Feet += (Height(m_Time) - FromHeight * (1f - Smooth(share))) * m_Normal;
            if (share < 1f)
                return;
            m_Stage = Stage.Seated;
            wings.Rest();
        }

        /// <summary>Leaves the spot, or the way down to it.</summary>
        /// <param name="body">The body.</param>
        /// <param name="wings">Its wings.</param>
        /// <param name="heading">Where the insect is to fly, radians; while its wings get going it turns there on its feet. Not a number
        /// leaves it as it sits.</param>
        /// <param name="dt">Seconds.</param>
        public void Start(ref FlyingBody body, in HeldWings wings, float heading, float dt)
        {
            if (m_Stage < Stage.Standing)
                Stand(body.rotation, wings);
            if (m_Stage == Stage.Pushing && IsUp(wings, dt))
            {
                m_Stage = Stage.Free;
                wings.PlaceOnBob(0f);
                return;
            }

            m_Time += dt;
            if (m_Stage == Stage.Standing)
            {
                bool isTurned = Turn(heading, dt) || m_Time > k_MostStanding;
                if (m_Time > m_WayTime && isTurned && (IsMomentToLeave || m_Time > m_WayTime + k_MostWait))
                    Push(ref body, math.min(m_Time - m_WayTime, dt), 2f / wings.Frequency);
            }

            if (m_Stage == Stage.Standing)
            {
                body.rotation = m_Seat;
                Hold(ref body);
                return;
            }

            // As at the end of the step, where the feet are by then: the first step of flight begins with what is shown.
            wings.PlaceOnBob(dt);
            float pushed = math.min(m_Time, m_WayTime), beyond = m_Time - pushed;
            m_Feet = m_FromFeet
                + (m_FromSpeed * pushed + 0.5f * (k_Jump - m_FromSpeed) * pushed * pushed / m_WayTime + k_Jump * beyond) * Units * m_Up;
            if (m_WholeAfter < 0 && (m_WayTime - m_Time) * wings.Frequency < 0.5f)
            {
                m_WholeAfter = wings.Beats;
                wings.BeatWhole();
            }

            float since = k_TurnDelay * Overhang, share = m_Time / m_WayTime;
            body.rotation = Rotations.Slerp(m_FromRotation, body.rotation, Smooth((share - since) / (1f - since)));
            Hold(ref body);
        }

        /// <summary>Centre of mass with the feet where they are, world units.</summary>
        public readonly float3 Centre(quaternion rotation, float3 legs) => m_Feet - math.rotate(rotation, legs);

        private void ComeDown(ref FlyingBody body, float3 velocity, float least, float frequency)
        {
            m_Stage = Stage.ComingDown;
            m_FromRotation = body.rotation;
            m_FromFeet = m_Feet;

            // The beat under way is still whole: until the wings are raised the body does not sink, and one that is too low rises.
            m_Top = math.max(FromHeight, least);
            float rise = m_Top - FromHeight;
            m_RaiseTime = math.min(
                math.max(least > 0f ? k_RaiseBeats / frequency : 0f, k_MostSlope * rise / (k_Gliding * Units)), k_MostRaise);

            // Below an overhang it turns upside down first: upright its raised wings are the farthest up.
            float turnTime = Angle(m_FromRotation, m_Seat) / k_Turning, first = Overhang * turnTime;
            m_RaiseTime += first;
            velocity -= math.min(math.dot(velocity, m_Normal), 0f) * m_Normal;
            float way = math.distance(m_Feet + rise * m_Normal, m_Spot);
            float speed = math.max(k_Gliding * Units, math.length(velocity));
            m_WayTime = m_RaiseTime + math.clamp(k_MostSlope * way / speed, k_SettleTime, k_MostTime)
                + turnTime - first;

            // What the insect brings along carries it no farther than the way is long.
            m_FromVelocity = velocity * math.min(1f, k_MostSlope * way / math.max(math.length(velocity) * m_WayTime, 1e-6f * Units));
            m_Time = 0f;
            Hold(ref body);
        }

        // Over the surface on the way down: up to the top, then down.
        private readonly float Height(float time)
        {
            if (time >= m_RaiseTime)
                return m_Top * (1f - Smooth((time - m_RaiseTime) / (m_WayTime - m_RaiseTime)));
            return math.lerp(FromHeight, m_Top, Smooth(time / m_RaiseTime));
        }

        // What is on its way down has beating wings already, and no feet on the ground to turn on.
        private void Stand(quaternion rotation, in HeldWings wings)
        {
            m_WayTime = m_Stage == Stage.Seated ? k_StartBeats / wings.Frequency : 0f;
            m_Seat = rotation;
            m_Stage = Stage.Standing;
            m_Time = 0f;
            wings.BeatRaised();
        }

        // The wings have beaten wholly, and are about to beat down; wings that nobody computes do not beat.
        private readonly bool IsUp(in HeldWings wings, float dt)
        {
            float beyond = m_Time - m_WayTime;
            bool isWhole = m_WholeAfter >= 0 && wings.Beats > m_WholeAfter + 1 && beyond > 0f;
            bool isRaised = wings.Phase > k_Raised || wings.Frequency * dt > 1f - k_Raised;
            return isWhole && isRaised || beyond * wings.Frequency > k_MostBeats;
        }

        private bool Turn(float heading, float dt)
        {
            if (m_WayTime == 0f || !math.isfinite(heading))
                return true;
            quaternion wanted = Facing(heading);
            float angle = Angle(m_Seat, wanted), most = k_Turning * dt;
            m_Seat = angle > most ? Rotations.Slerp(m_Seat, wanted, most / angle) : wanted;
            return angle <= most;
        }

        private void Push(ref FlyingBody body, float time, float leastTime)
        {
            body.reference = new BodyReference { heading = Headings.Of(m_Seat) };
            float way = math.max((k_PushShare + k_OverhangPush * Overhang) * m_Clearance * Units - math.dot(m_Feet - m_Spot, m_Normal), 0f)
                / math.max(math.dot(m_Up, m_Normal), 0.1f) / Units;
            m_Stage = Stage.Pushing;
            m_FromRotation = m_Seat;
            m_FromFeet = m_Feet;
            m_WayTime = math.max(math.max(2f * way / (k_Push + k_Jump), k_PushTime), leastTime);
            m_FromSpeed = 2f * way / m_WayTime - k_Jump;
            m_Time = time;
            m_WholeAfter = -1;
        }

        // On the surface, looking along a heading.
        private readonly quaternion Facing(float heading)
        {
            Elementary.SinCos(heading, out float sin, out float cos);
            var ahead = new float3(sin, 0f, cos);
            ahead -= m_Normal * math.dot(ahead, m_Normal);

            // Of a heading straight into a wall or out of it nothing is left but rounding.
            if (math.lengthsq(ahead) < 1e-6f)
                ahead = math.cross(new float3(1f, 0f, 0f), m_Normal);
            return quaternion.LookRotation(math.normalizesafe(ahead, new float3(0f, 0f, 1f)), m_Normal);
        }

        private static float Angle(quaternion from, quaternion to) => math.length(BodyMotion.Log(math.mul(to, math.conjugate(from))));

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
