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

        /// <summary>Way of a start down a slope, over the slope's fall.</summary>
        private const float k_Downhill = 1.2f;

        /// <summary>Squared length up to which what is left of a unit vector is rounding.</summary>
        internal const float Rounding = 1e-6f;

        /// <summary>Attempts before a spot is given up.</summary>
        private const int k_Attempts = 3;

        private Random m_Random;
        private float m_Left;
        private float3 m_Away;
        private bool m_Begun;

        /// <param name="seed">Any number: lengths of stays and flights.</param>
        public PerchPlan(int seed) => m_Random = Random.CreateFromIndex((uint)(seed & int.MaxValue));

        /// <summary>Stage of the insect.</summary>
        public PerchStage Stage { get; private set; }

        /// <summary>The landing under way, or the last one; null before the first.</summary>
        public Landing Landing { get; private set; }

        /// <summary>True where the insect flies and it is time to look for a spot.</summary>
        public bool WantsSpot { get; private set; }

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

        /// <summary>Sits on a spot from the start.</summary>
        public void Sit(in PerchSpot spot)
        {
            Land(spot, 0f);
            Stage = PerchStage.Perched;
            m_Left = float.PositiveInfinity;
        }

        /// <summary>Leaves the spot with the next step, or gives up landing.</summary>
        public void TakeOff(in PerchSettings settings)
        {
            if (Stage == PerchStage.Perched)
                m_Left = 0f;
            else if (Stage != PerchStage.TakingOff)
                FlyOn(settings);
        }

        /// <summary>Command for the next step.</summary>
        /// <param name="situation">The insect now.</param>
        /// <param name="settings">How it lives.</param>
        /// <param name="threat">Place of what it flees from, world units; not a number for none.</param>
        /// <param name="between">What flies between landings wants.</param>
        public FlightCommand Next(in FlightSituation situation, in PerchSettings settings, float3 threat, in FlightCommand between)
        {
            if (!m_Begun)
                FlyOn(settings);
            m_Begun = true;
            bool isThreatened = math.all(math.isfinite(threat));
            switch (Stage)
            {
                case PerchStage.Approaching:
                case PerchStage.Flaring:
                    return isThreatened || Landing.Attempts >= k_Attempts ? GiveUp(settings, between) : Descend(situation, settings);
                case PerchStage.Perched:
                    return Sit(situation, settings, threat, isThreatened);
                case PerchStage.TakingOff:
                    return Leave(situation, settings);
                default:
                    m_Left -= situation.deltaTime;
                    WantsSpot = m_Left <= 0f && !isThreatened;
                    return between;
            }
        }

        private FlightCommand GiveUp(in PerchSettings settings, in FlightCommand between)
        {
            FlyOn(settings);
            return between;
        }

        private FlightCommand Descend(in FlightSituation situation, in PerchSettings settings)
        {
            FlightCommand command = Landing.Next(situation);
            Stage = Landing.IsFlaring ? PerchStage.Flaring : PerchStage.Approaching;
            if (command.wish == FlightWish.Perch)
            {
                Stage = PerchStage.Perched;
                m_Left = settings.stayTime * m_Random.NextFloat(0.5f, 1.5f);
            }

            return command;
        }

        private FlightCommand Sit(in FlightSituation situation, in PerchSettings settings, float3 threat, bool isThreatened)
        {
            // On its last way down it does not sit yet.
            if (situation.state != FlightState.Landing)
                m_Left -= situation.deltaTime;
            if (m_Left > 0f && !isThreatened)
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
            m_Left = k_TakeOffTime;
            return Leave(situation, settings);
        }

        private FlightCommand Leave(in FlightSituation situation, in PerchSettings settings)
        {
            m_Left -= situation.deltaTime;
            if (m_Left <= 0f || math.distance(situation.position, Landing.Spot.position) > k_TakeOffWay * situation.unitsPerMetre)
                FlyOn(settings);
            float3 velocity = math.min(k_TakeOffSpeed, situation.limits.TopSpeed) * m_Away + new float3(0f, situation.limits.MostClimb, 0f);
            return NoseFirst.Limit(FlightCommand.Fly(velocity), situation);
        }

        private void FlyOn(in PerchSettings settings)
        {
            Stage = PerchStage.Between;
            WantsSpot = false;
            m_Left = settings.flightTime * m_Random.NextFloat(0.5f, 1.5f);
        }
    }
}
