using Alate.Geometry;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// One substep of a body: where it is in the middle, which its wings meet, then its motion by the implicit midpoint rule with the air's
    /// damping.
    /// </summary>
    internal static class BodyMotion
    {
        /// <summary>Carries the body to the middle of the substep as it moved in the last one.</summary>
        public static void Predict(ref FlyingBody body, float h)
        {
            float half = 0.5f * h;
            body.middleSpin = body.spin + half * body.spinRate;
            body.middleRotation = math.normalize(math.mul(body.rotation, Turn(half * (body.spin + 0.5f * half * body.spinRate))));
            body.middleVelocity = body.velocity + half * math.rotate(body.middleRotation, body.acceleration);
        }

        /// <summary>Moves the body by the air's forces on its wings, its own drag, its weight and the aid.</summary>
        public static void Step(ref FlyingBody body, in BodyAir air, float h)
        {
            quaternion q = body.middleRotation;
            float3 hull = Hull(body, out float speed);
            float3 spin = body.middleSpin;
            float3 aid = math.rotate(math.conjugate(q), body.aidForce);
            air.damping.Multiply(0.5f * h * body.acceleration, 0.5f * h * body.spinRate, out float3 givenForce, out float3 givenMoment);
            float3 force = air.force + hull + math.rotate(math.conjugate(q), body.weight) * body.mass + aid;
            float3 moment = air.moment - math.cross(spin, math.mul(body.inertia, spin)) + body.aidMoment;

            // Midpoint: the forces were taken where the body was predicted to be; K carries them to where it gets.
            var system = new Symmetric6
            {
                uu = air.damping.uu * (0.5f * h),
                uw = air.damping.uw
                * (0.5f * h),
                ww = air.damping.ww * (0.5f * h) + body.inertia
            };
            float3 own = body.mass + h * speed * body.drag;
            system.uu.c0.x += own.x;
            system.uu.c1.y += own.y;
            system.uu.c2.z += own.z;

            float3 hullGiven = body.drag * (2f * speed) * (0.5f * h * body.acceleration);
            system.Solve(h * (force + givenForce + hullGiven), h * (moment + givenMoment), out float3 du, out float3 dw);
            if (!math.all(math.isfinite(du)) || !math.all(math.isfinite(dw)))
                return;
            body.force += math.rotate(q, (body.mass * du / h) - math.rotate(math.conjugate(q), body.weight) * body.mass);
            body.moment += air.moment;
            Advance(ref body, math.rotate(q, du), dw, h);
            body.acceleration = du / h;
            body.spinRate = dw / h;
        }

        /// <summary>Adds the air of a body that is held to its readings.</summary>
        public static void Read(ref FlyingBody body, in BodyAir air)
        {
            quaternion q = body.middleRotation, back = math.conjugate(q);
            body.force += math.rotate(q, air.force + Hull(body, out _));
            body.moment += air.moment;
            body.damping.c0 += LongDamping(air, q, math.rotate(back, new float3(0f, 1f, 0f)), default);
            body.damping.c1 += LongDamping(air, q, math.rotate(back, new float3(0f, 0f, 1f)), default);
            body.damping.c2 += LongDamping(air, q, default, new float3(1f, 0f, 0f));
        }

        /// <summary>Evaluates the drag of the hull in body axes, N, and the speed of the air, m/s, in the middle of the substep.</summary>
        public static float3 Hull(in FlyingBody body, out float speed)
        {
            float3 stream = math.rotate(math.conjugate(body.middleRotation), body.wind - body.middleVelocity);
            speed = math.length(stream);
            return body.drag * (speed * stream);
        }

        private static float3 LongDamping(in BodyAir air, quaternion q, float3 u, float3 w)
        {
            Symmetric6 damping = air.damping;
            damping.Multiply(u, w, out float3 force, out float3 moment);
            force = math.rotate(q, force);
            return new float3(force.y, force.z, moment.x);
        }

        /// <summary>Sets attitude and motion to the trim's with its bob.</summary>
        public static unsafe void Place(ref FlyingBody body, float* point, in BodyBob bob, float3 velocity)
        {
            OnBob(body, point, bob, velocity, out body.rotation, out body.velocity, out body.spin);
            body.acceleration = body.spinRate = default;
            body.middleRotation = body.rotation;
            body.middleVelocity = body.velocity;
            body.middleSpin = body.spin;
        }

        /// <summary>Finds attitude and motion of the trim with its bob.</summary>
        public static unsafe void OnBob(
            in FlyingBody body, float* point, in BodyBob bob, float3 mean, out quaternion rotation, out float3 velocity, out float3 spin)
        {
            quaternion heading = Rotations.AboutY(body.reference.heading);
            rotation = math.normalize(math.mul(heading, Rotations.AboutX(bob.turn - point[TrimPoint.Pitch])));
            velocity = mean + math.rotate(heading, bob.velocity);
            spin = new float3(bob.rate, 0f, 0f);
        }

        /// <summary>Sets attitude and motion to the trim's with its bob at a phase, and their rates to those of the bob.</summary>
        /// <param name="body">The body.</param>
        /// <param name="point">A <see cref="TrimPoint"/>.</param>
        /// <param name="phase">Φ, radians.</param>
        /// <param name="rate">Of the phase, rad/s.</param>
        /// <param name="velocity">Mean over the beat, m/s.</param>
        public static unsafe void PlaceOnBob(ref FlyingBody body, float* point, float phase, float rate, float3 velocity)
        {
            const float step = 0.01f;
            BodyBob after = BodyBob.At(point, phase + step), before = BodyBob.At(point, phase - step);
            Place(ref body, point, BodyBob.At(point, phase), velocity);
            float perStep = 0.5f * rate / step;
            float3 acceleration = math.rotate(Rotations.AboutY(body.reference.heading), perStep * (after.velocity - before.velocity));
            body.acceleration = math.rotate(math.conjugate(body.rotation), acceleration);
            body.spinRate = new float3(perStep * (after.rate - before.rate), 0f, 0f);
        }

        /// <summary>Moves a body whose velocity and angular velocity change by so much, world and body axes.</summary>
        public static void Advance(ref FlyingBody body, float3 change, float3 turnChange, float h)
        {
            body.Move(h * (body.velocity + 0.5f * change));
            body.rotation = math.normalize(math.mul(body.rotation, Turn(h * (body.spin + 0.5f * turnChange))));
            body.velocity += change;
            body.spin += turnChange;
        }

        /// <summary>Rotation by a rotation vector.</summary>
        public static quaternion Turn(float3 by)
        {
            float angle = math.length(by);
            float sinc = angle > 1e-4f ? Elementary.Sin(0.5f * angle) / angle : 0.5f - angle * angle * (1f / 48f);
            return new quaternion(by.x * sinc, by.y * sinc, by.z * sinc, Elementary.Cos(0.5f * angle));
        }

        /// <summary>Rotation vector of a rotation, the short way.</summary>
        public static float3 Log(quaternion q)
        {
            float4 v = q.value.w < 0f ? -q.value : q.value;
            float sine = math.length(v.xyz);
            return sine < 1e-6f ? 2f * v.xyz : v.xyz * (2f * Elementary.Atan2(sine, v.w) / sine);
        }
    }
}
