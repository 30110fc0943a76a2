using Alate.Geometry;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Alate.Flight
{
    /// <summary>
    /// The track of a butterfly: straight stretches of random length with random turns between, drawn back to the middle of a volume, and a
    /// height that climbs and sinks over many beats. One seed gives one track.
    /// </summary>
    public sealed class ErraticCourse
    {
        /// <summary>Parts of the fastest turn that are asked for: at random, calm and erratic, and back from the rim.</summary>
        private const float k_TurnShare = 0.4f, k_MostTurnShare = 1f, k_BackShare = 0.8f;

        /// <summary>
        /// Parts of the acceleration that are asked for, calm and erratic, and part with which the insect counts on its way to the rim.
        /// </summary>
        private const float k_Acceleration = 0.45f, k_MostAcceleration = 1f, k_Rim = 0.3f;

        /// <summary>Factors of an erratic track on the time between turns and on their spread.</summary>
        private const float k_Shorter = 0.5f, k_Wider = 1.3f;

        /// <summary>Part of the speed that is kept at the rim: an insect that stops there stalls.</summary>
        private const float k_Least = 0.2f;

        /// <summary>Largest radius of a turn back, a share of half of the volume's narrower side.</summary>
        private const float k_Fits = 0.5f;

        /// <summary>Room before the rim in turn radii, at which the insect turns back.</summary>
        private const float k_Room = 1.5f;

        /// <summary>Largest angle off the way to the middle of a turn back from the rim, radians.</summary>
        private const float k_Homeward = 1f;

        /// <summary>Range of the speed about its mean, calm and erratic, a share.</summary>
        private const float k_SpeedSpread = 0.3f, k_MostSpeedSpread = 0.8f;

        private Random m_Random;
        private float3 m_Wanted;
        private float m_Course, m_WantedCourse, m_Left, m_Pace, m_Climb;
        private bool m_Begun, m_TurnsBack;

        /// <param name="seed">Any number; insects with different ones fly different tracks.</param>
        public ErraticCourse(int seed) => m_Random = Random.CreateFromIndex((uint)(seed & int.MaxValue));

        /// <summary>Course now, radians about the world's up; 0 is along +Z, π/2 along +X.</summary>
        public float Course => m_Course;

        /// <summary>Velocity for the next step, m/s along the world's axes.</summary>
        /// <param name="situation">The insect now.</param>
        /// <param name="volume">Where it stays.</param>
        /// <param name="settings">How it flies.</param>
        public float3 Next(in FlightSituation situation, in FlightVolume volume, WanderSettings settings)
        {
            settings = settings.Clamped();
            float dt = situation.deltaTime;
            Begin(situation);
            FlightLimits all = situation.limits;
            // No faster than a turn back fits into the volume.
            float half = 0.5f * math.cmin(math.abs(((float3)volume.size).xz)) / situation.unitsPerMetre;
            float speed = math.min(m_Pace * settings.speed, math.min(all.TopSpeed, k_Fits * half * k_BackShare * all.TurnRate(0f)));
            var limits = new FlightLimits(all.TopSpeed, all.LeastClimb, all.MostClimb, k_Rim * all.Acceleration);
            Turn(situation, limits, volume, settings, speed);
            Climb(situation.limits, settings, dt);

            float turn = math.lerp(k_TurnShare, k_MostTurnShare, settings.erratic);
            float rate = (m_TurnsBack ? math.max(k_BackShare, turn) : turn) * all.TurnRate(speed);
            m_Course = Headings.Wrap(m_Course + math.clamp(Headings.Wrap(m_WantedCourse - m_Course), -rate * dt, rate * dt));
            float3 wanted = speed * Along(m_Course) + new float3(0f, m_Climb, 0f);
            wanted = volume.Hold(wanted, situation.position, limits, situation.unitsPerMetre);
            if (math.length(wanted.xz) < k_Least * speed)
                wanted.xz = k_Least * speed * Along(m_Course).xz;
            float3 change = wanted - m_Wanted;
            float acceleration = math.lerp(k_Acceleration, k_MostAcceleration, settings.erratic) * all.Acceleration;
            m_Wanted += change * math.min(1f, acceleration * dt / math.max(math.length(change), 1e-6f));
            if (math.all(math.isfinite(m_Wanted)) && math.isfinite(m_Course + m_WantedCourse + m_Left + m_Climb))
                return m_Wanted;

            // A volume that is nowhere: on as it flies, and again with the next step.
            m_Begun = m_TurnsBack = false;
            return situation.referenceVelocity;
        }

        /// <summary>Forgets where the insect was; the random numbers go on.</summary>
        public void Restart() => m_Begun = false;

        private void Begin(in FlightSituation situation)
        {
            if (m_Begun)
                return;
            m_Begun = true;
            m_Course = m_WantedCourse = situation.heading;
            m_Left = 0f;
            m_Pace = 1f;
            m_Climb = 0f;
            m_Wanted = situation.referenceVelocity;
        }

        // At the end of a stretch, or where the way leads out: once, until the insect is on its new way.
        private void Turn(
            in FlightSituation situation, in FlightLimits limits, in FlightVolume volume, in WanderSettings settings, float speed)
        {
            m_Left -= situation.deltaTime;
            float3 home = (float3)volume.centre - situation.position;
            float homeward = Elementary.Atan2(home.x, home.z);
            float room = (k_Room * limits.TurnRadius(speed) + limits.StoppingDistance(speed)) * situation.unitsPerMetre;
            float3 ahead = situation.position + room * Along(m_WantedCourse);
            ahead.y = volume.centre.y;
            bool leadsOut = !volume.Contains(ahead);
            m_TurnsBack &= leadsOut && math.abs(Headings.Wrap(m_WantedCourse - homeward)) <= k_Homeward + 0.5f;
            if (leadsOut && !m_TurnsBack)
            {
                m_TurnsBack = true;
                m_WantedCourse = Headings.Wrap(homeward + m_Random.NextFloat(-k_Homeward, k_Homeward));
                Stretch(settings);
            }
            else if (m_Left <= 0f)
            {
                float spread = math.min(settings.turnSpread * math.lerp(1f, k_Wider, settings.erratic), WanderBounds.TurnSpread.Max);
                float course = m_WantedCourse + math.radians(spread) * Normal();
                float3 biased = Along(course) + settings.homing
                    * math.saturate(math.length(home.xz) / (0.5f * math.cmin(math.abs(((float3)volume.size).xz)))) * Along(homeward);
                m_WantedCourse = Elementary.Atan2(biased.x, biased.z);
                Stretch(settings);
            }
        }

        // Straight stretches of exponential length: turns that come at random.
        private void Stretch(in WanderSettings settings)
        {
            m_Left = -settings.straightTime * math.lerp(1f, k_Shorter, settings.erratic) * Elementary.Log(1f - m_Random.NextFloat());
            m_Pace = 1f + math.lerp(k_SpeedSpread, k_MostSpeedSpread, settings.erratic) * m_Random.NextFloat(-1f, 1f);
        }

        // An Ornstein-Uhlenbeck process, exact for any step.
        private void Climb(in FlightLimits limits, in WanderSettings settings, float dt)
        {
            float kept = Elementary.Exp(-dt / settings.bobTime);
            m_Climb = kept * m_Climb + settings.bob * math.sqrt(1f - kept * kept) * Normal();
            m_Climb = math.clamp(m_Climb, limits.LeastClimb, limits.MostClimb);
        }

        private float Normal() =>
            math.sqrt(-2f * Elementary.Log(1f - m_Random.NextFloat())) * Elementary.Cos(2f * math.PI * m_Random.NextFloat());

        private static float3 Along(float course)
        {
            Elementary.SinCos(course, out float sin, out float cos);
            return new float3(sin, 0f, cos);
        }
    }
}
