using Alate.Flight;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>
    /// A point that obeys an insect's limits: its reference changes no faster than the acceleration, above 0.3 m/s its course turns no
    /// faster than a/v, and the point follows the reference a filter later.
    /// </summary>
    internal sealed class PointFlyer
    {
        private const float k_Filter = 0.1f, k_SlowSpeed = 0.3f, k_TurnRate = 4f, k_MostTurning = 3f;

        public FlightSituation situation;

        public PointFlyer(float unitsPerMetre = 10f, float dt = 0.02f)
        {
            situation = new FlightSituation
            {
                rotation = quaternion.identity,
                limits = new FlightLimits(1.3f, -0.3f, 0.3f, 2.5f),
                deltaTime = dt,
                wingLength = 0.061f,
                unitsPerMetre = unitsPerMetre,
            };
        }

        /// <summary>Largest change of velocity so far, m/s².</summary>
        public float MostAcceleration { get; private set; }

        public void Fly(IFlightPilot pilot) => Fly(pilot.Command(situation));

        public void Fly(in FlightCommand command)
        {
            FlightLimits limits = situation.limits;
            float dt = situation.deltaTime;
            situation.state = command.wish == FlightWish.Perch
                ? FlightState.Perched : command.wish == FlightWish.Land ? FlightState.Landing : FlightState.Flying;
            if (situation.state == FlightState.Perched)
            {
                situation.velocity = situation.referenceVelocity = default;
                situation.position = command.spot.position + new float3(0f, 0.01f, 0f) * situation.unitsPerMetre;
                situation.time += dt;
                return;
            }

            float3 wanted = command.velocity;
            wanted.y = math.clamp(wanted.y, limits.LeastClimb, limits.MostClimb);
            float across = math.length(wanted.xz);
            wanted.xz *= across > limits.TopSpeed ? limits.TopSpeed / across : 1f;
            float3 reference = situation.referenceVelocity;
            float speed = math.length(reference.xz);
            if (speed > k_SlowSpeed && math.length(wanted.xz) > 1e-3f)
            {
                float course = math.atan2(reference.x, reference.z), turn = Headings.Wrap(math.atan2(wanted.x, wanted.z) - course);
                float most = limits.Acceleration / speed * dt;
                if (math.abs(turn) > most)
                {
                    course += math.clamp(turn, -most, most);
                    float kept = math.max(math.dot(wanted.xz, reference.xz) / speed, 0.5f * speed);
                    wanted.xz = kept * new float2(math.sin(course), math.cos(course));
                }
            }

            float3 change = wanted - reference;
            change *= math.min(1f, 1.5f * limits.Acceleration * dt / math.max(math.length(change), 1e-6f));
            MostAcceleration = math.max(MostAcceleration, math.length(change) / dt);
            situation.referenceVelocity = reference + change;
            situation.velocity += (situation.referenceVelocity - situation.velocity) * (1f - math.exp(-dt / k_Filter));
            situation.position += situation.velocity * (dt * situation.unitsPerMetre);
            float heading = math.length(situation.referenceVelocity.xz) > k_SlowSpeed
                || !math.isfinite(command.heading) && math.length(situation.referenceVelocity.xz) > 0.1f
                ? math.atan2(situation.referenceVelocity.x, situation.referenceVelocity.z) : command.heading;
            if (math.isfinite(heading))
            {
                situation.heading +=
                    math.clamp(k_TurnRate * Headings.Wrap(heading - situation.heading), -k_MostTurning, k_MostTurning) * dt;
            }
            situation.time += dt;
        }
    }
}
