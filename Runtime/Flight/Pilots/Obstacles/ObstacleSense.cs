using Unity.Mathematics;

namespace Alate.Flight
{
    /// <summary>
    /// Hits of one insect's rays: one along its way and four around it. A wanted velocity loses what would carry the insect into a surface
    /// before it can stop, and turns to the freest side.
    /// </summary>
    internal sealed class ObstacleSense
    {
        /// <summary>Rays of one insect.</summary>
        public const int RayCount = 5;

        /// <summary>Angle of the outer rays off the middle one: tangent of 35°.</summary>
        private const float k_Spread = 0.7f;

        private readonly float4[] m_Met = new float4[RayCount];
        private readonly float3[] m_Directions = new float3[RayCount];
        private float3 m_Way = new float3(0f, 0f, 1f);

        /// <summary>Start of the rays, world units.</summary>
        public float3 From { get; private set; }

        /// <summary>Reach of the rays, world units.</summary>
        public float Reach { get; private set; }

        /// <summary>Layers that they meet.</summary>
        public int Layers { get; private set; }

        /// <summary>True where the way is blocked so that hardly anything is left of the wanted velocity.</summary>
        public bool IsBlocked { get; private set; }

        /// <summary>Direction of a ray, unit length.</summary>
        public float3 Direction(int ray) => m_Directions[ray];

        /// <summary>Takes over what a ray met.</summary>
        /// <param name="ray">Which one.</param>
        /// <param name="normal">Of the surface.</param>
        /// <param name="distance">World units; below 0 for nothing.</param>
        public void SetHit(int ray, float3 normal, float distance) => m_Met[ray] = new float4(normal, distance);

        /// <summary>Changes a velocity so that the insect flies round what its rays met, and asks for new rays.</summary>
        /// <param name="wanted">m/s.</param>
        /// <param name="situation">The insect now.</param>
        /// <param name="settings">What is avoided.</param>
        /// <param name="goal">Metres to the goal; beyond it nothing is in the way.</param>
        public float3 Avoid(float3 wanted, in FlightSituation situation, in ObstacleSettings settings, float goal = float.PositiveInfinity)
        {
            IsBlocked = false;
            if (!settings.avoid)
                return wanted;
            float clearance = settings.Metres(situation.wingLength);
            float3 allowed = Limit(wanted, situation, clearance);
            float lost = math.length(wanted) - math.length(allowed);
            IsBlocked = math.length(allowed) < 0.2f * math.length(wanted);
            if (lost > 0.3f * math.length(wanted) && goal > FirstHit() / situation.unitsPerMetre + clearance)
                allowed = Limit(allowed + lost * FreestSide(), situation, clearance);
            Look(wanted, situation, settings, clearance);
            return allowed;
        }

        private float3 Limit(float3 velocity, in FlightSituation situation, float clearance)
        {
            for (int ray = 0; ray < RayCount; ray++)
            {
                float4 met = m_Met[ray];
                if (!(met.w >= 0f))
                    continue;
                float moved = math.dot(situation.position - From, met.xyz);
                float off = (met.w * -math.dot(m_Directions[ray], met.xyz) + moved) / situation.unitsPerMetre - clearance;
                float into = -math.dot(velocity, met.xyz);
                float most = off >= 0f
                    ? situation.limits.SpeedToStopWithin(off)
                    : -math.min(situation.limits.SpeedToStopWithin(-off), 0.3f);
                if (into > most)
                    velocity += (into - most) * met.xyz;
            }

            return velocity;
        }

        private float FirstHit()
        {
            float first = float.PositiveInfinity;
            foreach (float4 met in m_Met)
                first = met.w >= 0f ? math.min(first, met.w) : first;
            return first;
        }

        // Across the way: to the side, or up or down, whose ray goes farthest.
        private float3 FreestSide()
        {
            float3 side = default;
            float farthest = -1f;
            for (int ray = 1; ray < RayCount; ray++)
            {
                float free = m_Met[ray].w >= 0f ? m_Met[ray].w : 2f * Reach;
                if (free <= farthest)
                    continue;
                farthest = free;
                side = m_Directions[ray] - m_Way * math.dot(m_Directions[ray], m_Way);
            }

            return math.normalizesafe(side);
        }

        private void Look(float3 wanted, in FlightSituation situation, in ObstacleSettings settings, float clearance)
        {
            m_Way = math.normalizesafe(0.5f * situation.referenceVelocity + wanted, m_Way);
            float3 right = math.normalizesafe(math.cross(new float3(0f, 1f, 0f), m_Way), new float3(1f, 0f, 0f));
            float3 up = math.cross(m_Way, right);
            m_Directions[0] = m_Way;
            m_Directions[1] = math.normalize(m_Way + k_Spread * right);
            m_Directions[2] = math.normalize(m_Way - k_Spread * right);
            m_Directions[3] = math.normalize(m_Way + k_Spread * up);
            m_Directions[4] = math.normalize(m_Way - k_Spread * up);
            float speed = math.max(math.length(wanted), math.length(situation.referenceVelocity));
            From = situation.position;
            Reach =
                (situation.limits.StoppingDistance(speed) + situation.limits.TurnRadius(speed) + 2f * clearance) * situation.unitsPerMetre;
            Layers = settings.layers;
            for (int ray = 0; ray < RayCount; ray++)
                m_Met[ray].w = -1f;
            ObstacleRays.Ask(this);
        }
    }
}
