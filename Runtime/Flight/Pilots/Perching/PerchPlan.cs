using Alate.Geometry;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Alate.Flight
{
    /// <summary>An insect's day: it flies, lands on a spot, sits, and takes off when its time is up or something comes near.</summary>
    public sealed class PerchPlan
    {
        /// <summary>Longest time of taking off, seconds, and how far it goes, metres.</summary>
        private const float k_TakeOffTime = 2.5f, k_TakeOffWay = 0.5f;

        /// <summary>Speed of taking off ahead, m/s; many species cannot climb while they hover.</summary>
        private const float k_TakeOffSpeed = 0.65f;

        /// <summary>Sinking away from a ceiling, m/s, and upward part of an overhang's normal below which nothing climbs.</summary>
        private const float k_Drop = 0.2f, k_Overhang = -0.3f;

        /// <summary>Way of a start down a slope, over the slope's fall.</summary>
        private const float k_Downhill = 1.2f;

        /// <summary>Squared length up to which what is left of a unit vector is rounding.</summary>
        internal const float Rounding = 1e-6f;

        /// <summary>Attempts before a spot is given up.</summary>
        private const int k_Attempts = 3;

        private Random m_Random;

        // Seconds of the stage that have passed, and its length: a share of a mean that may change meanwhile.
        private float m_Passed, m_Share;
        private float3 m_Away;
        private bool m_Begun;

        /// <param name="seed">Any number: lengths of stays and flights.</param>
        public PerchPlan(int seed) => Draw(seed);

        /// <summary>Stage of the insect.</summary>
        public PerchStage Stage { get; private set; }

        /// <summary>The landing under way, or the last one; null before the first.</summary>
        public Landing Landing { get; private set; }

        /// <summary>True where the insect flies and it is time to look for a spot.</summary>
        public bool WantsSpot { get; private set; }

        /// <summary>Draws what comes with another seed; what is under way goes on.</summary>
        internal void Draw(int seed) => m_Random = Random.CreateFromIndex((uint)(seed & int.MaxValue));

        /// <summary>Goes for a spot.</summary>
        /// <param name="spot">Where.</param>
        /// <param name="stand">Height of the centre of mass over the feet, metres.</param>
        public void Land(in PerchSpot spot, float stand)
        {
            Landing = new Landing(spot, stand);
            Stage = PerchStage.Approaching;
            WantsSpot = false;
            m_Begun = true;
        }

        /// <summary>Tells where the spot of the landing is by now, each step: one that moves takes the insect along.</summary>
        /// <param name="spot">Where; finite.</param>
        /// <param name="deltaTime">Seconds since it was told last.</param>
        public void Follow(in PerchSpot spot, float deltaTime) => Landing?.Follow(spot, deltaTime);

        /// <summary>Sits on a spot from the start.</summary>
        public void Sit(in PerchSpot spot)
        {
            Land(spot, 0f);
            Stage = PerchStage.Perched;
            Begin(float.PositiveInfinity);
        }

        /// <summary>Leaves the spot with the next step, or gives up landing.</summary>
        public void TakeOff()
        {
            if (Stage == PerchStage.Perched)
                Begin(0f);
            else if (Stage != PerchStage.TakingOff)
                FlyOn();
        }

        /// <summary>Command for the next step.</summary>
        /// <param name="situation">The insect now.</param>
        /// <param name="settings">How it lives.</param>
        /// <param name="threat">Place of what it flees from, world units; not a number for none.</param>
        /// <param name="between">What flies between landings wants.</param>
        public FlightCommand Next(in FlightSituation situation, in PerchSettings settings, float3 threat, in FlightCommand between)
        {
            if (!m_Begun)
                FlyOn();
            m_Begun = true;
            bool isThreatened = math.all(math.isfinite(threat));
            switch (Stage)
            {
                case PerchStage.Approaching:
                case PerchStage.Flaring:
                    return isThreatened || Landing.Attempts >= k_Attempts ? GiveUp(between) : Descend(situation, settings);
                case PerchStage.Perched:
                    return Sit(situation, settings, threat, isThreatened);
                case PerchStage.TakingOff:
                    return Leave(situation);
                default:
                    m_Passed += situation.deltaTime;
                    WantsSpot = m_Passed >= m_Share * settings.flightTime && !isThreatened;
                    return isThreatened ? Flee(situation, threat, between) : between;
            }
        }

        // Away from the threat, at least as fast as it takes off; it rises and sinks as it would without.
        private static FlightCommand Flee(in FlightSituation situation, float3 threat, in FlightCommand between)
        {
            float3 level = new float3(1f, 0f, 1f), wanted = between.velocity * level;
            float3 away = math.normalizesafe((situation.position - threat) * level, math.normalizesafe(wanted));
            float speed = math.max(math.length(wanted), math.min(k_TakeOffSpeed, situation.limits.TopSpeed));
            return FlightCommand.Fly(speed * away + new float3(0f, between.velocity.y, 0f));
        }

        private FlightCommand GiveUp(in FlightCommand between)
        {
            FlyOn();
            return between;
        }

        private FlightCommand Descend(in FlightSituation situation, in PerchSettings settings)
        {
            FlightCommand command = Landing.Next(situation);
            Stage = Landing.IsFlaring ? PerchStage.Flaring : PerchStage.Approaching;
            if (command.wish == FlightWish.Perch)
            {
                Stage = PerchStage.Perched;
                Begin(m_Random.NextFloat(0.5f, 1.5f));
            }

            return command;
        }

        private FlightCommand Sit(in FlightSituation situation, in PerchSettings settings, float3 threat, bool isThreatened)
        {
            // On its last way down it does not sit yet.
            if (situation.state != FlightState.Landing)
                m_Passed += situation.deltaTime;
            if (m_Passed < m_Share * settings.stayTime && !isThreatened)
                return new FlightCommand { wish = FlightWish.Perch, spot = Landing.Spot, heading = Landing.Spot.heading };
            var ahead = new float3(Elementary.Sin(situation.heading), 0f, Elementary.Cos(situation.heading));
            float3 downhill = Landing.Spot.normal * new float3(1f, 0f, 1f);
            float3 from = isThreatened ? math.normalizesafe((situation.position - threat) * new float3(1f, 0f, 1f)) : default;
            float3 away = ahead + 0.7f * from;

            // Not into the slope: along it, and a little down, but not straight back: a slow insect takes seconds to turn round.
            float3 down = math.normalizesafe(downhill);
            float uphill = math.min(math.dot(away, down), 0f);
            float3 along = away - uphill * down;
            if (uphill < 0f)
                away = math.length(away) * (math.lengthsq(along) > Rounding ? math.normalize(along) : new float3(down.z, 0f, -down.x));
            away += k_Downhill * math.length(downhill) * down;
            m_Away = math.normalizesafe(away, ahead);
            Stage = PerchStage.TakingOff;
            m_Passed = 0f;
            return Leave(situation);
        }

        private FlightCommand Leave(in FlightSituation situation)
        {
            m_Passed += situation.deltaTime;
            bool isFar = math.distance(situation.position, Landing.Spot.position) > k_TakeOffWay * situation.unitsPerMetre;
            if (m_Passed >= k_TakeOffTime || isFar)
                FlyOn();
            float3 velocity = math.min(k_TakeOffSpeed, situation.limits.TopSpeed) * m_Away
                + new float3(0f, Rise(situation, Landing.Spot.normal), 0f);
            var command = FlightCommand.Fly(velocity);
            command.spot = Landing.Spot;
            return command;
        }

        /// <summary>Climb away from a surface, m/s: up, but not into an overhang.</summary>
        internal static float Rise(in FlightSituation situation, float3 normal) =>
            math.lerp(situation.limits.MostClimb, -k_Drop, math.saturate(normal.y / k_Overhang));

        private void FlyOn()
        {
            Stage = PerchStage.Between;
            WantsSpot = false;
            Begin(m_Random.NextFloat(0.5f, 1.5f));
        }

        private void Begin(float share)
        {
            m_Passed = 0f;
            m_Share = share;
        }
    }
}
