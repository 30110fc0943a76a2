using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Help from outside for an insect that a gust has thrown about: towards the wanted velocity and attitude, only beyond 30° and 0.4 m/s,
    /// bounded by the weight, and reported.
    /// </summary>
    internal static unsafe class BodyAid
    {
        /// <summary>Errors below which there is no aid, radians and m/s.</summary>
        private const float k_Turn = math.PI / 6f, k_Velocity = 0.4f;

        /// <summary>
        /// Rate of the force over the mass, s⁻¹; rate at which the moment turns the body back, critically damped, over F0: what upsets a
        /// body grows with its beat.
        /// </summary>
        private const float k_Rate = 4f, k_Beat = 4f;

        /// <summary>Bounds over the weight in the scene's gravity (and a wing's length).</summary>
        private const float k_MostMoment = 1f, k_MostForce = 0.5f;

        /// <summary>Fills force (world axes) and moment (body axes).</summary>
        public static void Evaluate(ref FlyingBody body, float phase)
        {
            body.aidForce = body.aidMoment = default;
            if (!(body.aid > 0f))
                return;
            float* point = stackalloc float[TrimPoint.Floats];
            body.table.Read(body.reference.airSpeed, body.reference.climb, point);
            FlyingBody seen = body;
            var bob = BodyBob.At(point, phase);
            quaternion wanted = BodyFeedback.Errors(ref seen, point, bob);
            float weight = body.mass * math.length(body.gravity);
            float3 dv = Beyond(seen.velocityError, k_Velocity),
                e = Beyond(BodyFeedback.TurnApart(body, point, bob, out quaternion heading), k_Turn);
            body.aidForce = body.aid * Bounded(math.rotate(wanted, dv) * (-k_Rate * body.mass), k_MostForce * weight);
            if (math.any(e != 0f))
            {
                float rate = k_Beat * body.frequency;
                float3 turn = math.rotate(heading, rate * rate * e) + math.rotate(wanted, 2f * rate * seen.rateError);
                turn = math.rotate(math.conjugate(body.rotation), turn);
                body.aidMoment = body.aid * Bounded(-math.mul(body.inertia, turn), k_MostMoment * weight * body.length);
            }

            body.aidPower += math.dot(body.aidForce, body.velocity) + math.dot(body.aidMoment, body.spin);
        }

        // All of the error from half as much again as the bound on, nothing below it.
        private static float3 Beyond(float3 error, float bound) => error * math.saturate(2f * (math.length(error) / bound - 1f));

        private static float3 Bounded(float3 value, float most)
        {
            float size = math.length(value);
            return size > most ? value * (most / size) : value;
        }
    }
}
