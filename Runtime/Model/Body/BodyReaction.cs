using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// One substep of a body that feels the inertia of its wings: momentum and angular momentum of body and wings together change by the
    /// forces from outside alone, and what the wings have of them moves the body.
    /// </summary>
    internal static class BodyReaction
    {
        /// <summary>Rounds in which the attitude at the end and the motion there settle.</summary>
        private const int k_Rounds = 2;

        /// <summary>Moves the body by the air's forces on its wings, its own drag, its weight, the aid, and the wings' inertia.</summary>
        public static void Step(ref FlyingBody body, in BodyAir air, in BodyMasses now, float h)
        {
            if (body.knowsMasses == 0)
                body.masses = now;
            quaternion before = body.rotation, middle = body.middleRotation;
            // Of the momentum, what is not mass times velocity: nothing is rounded that the velocity would only lose again.
            float3 relative = math.rotate(before, body.masses.Relative(body.spin));
            float3 angular = math.rotate(
                before, body.masses.Turning(math.rotate(math.conjugate(before), body.velocity), body.spin));

            float3 hull = BodyMotion.Hull(body, out float speed);
            float3 weight = body.mass * body.weight, first = math.rotate(middle, 0.5f * (body.masses.first + now.first));
            float3 force = math.rotate(middle, air.force + hull) + weight + body.aidForce;
            float3 moment = math.rotate(middle, air.moment + body.aidMoment) + math.cross(first, body.weight);

            // The forces were taken where the body was predicted to be; half of what its end differs from that is damped.
            var damping = new Symmetric6
            {
                uu = air.damping.uu * (0.5f * h) + float3x3.Scale(h * speed * body.drag),
                uw = air.damping.uw * (0.5f * h),
                ww = air.damping.ww * (0.5f * h),
            };
            float3 faster = h * math.rotate(middle, body.acceleration), spun = body.spin + h * body.spinRate;
            Symmetric6 system = damping;
            system.uu += float3x3.Scale(body.mass);
            system.uw += Turning(now.first);
            system.ww += now.inertia;
            float3 pushed = relative + h * force, change = faster, spin = spun, kept = default;
            for (int round = 0; round < k_Rounds; round++)
            {
                quaternion after = math.normalize(math.mul(before, BodyMotion.Turn(0.5f * h * (body.spin + spin))));
                quaternion there = math.conjugate(after);
                float3 moved = h * (body.velocity + 0.5f * change);
                float3 turned = angular + h * moment - math.cross(moved, 0.5f * (relative + pushed - body.mass * change));
                damping.Multiply(math.rotate(there, faster), spun, out float3 keptForce, out float3 keptMoment);
                system.Solve(
                    math.rotate(there, pushed) - now.linear + keptForce,
                    math.rotate(there, turned) - now.angular - math.cross(now.first, math.rotate(there, body.velocity)) + keptMoment,
                    out float3 u, out float3 w);
                if (!math.all(math.isfinite(u)) || !math.all(math.isfinite(w)))
                {
                    // A wing broke: what is known of it does not count.
                    body.knowsMasses = 0;
                    return;
                }

                change = math.rotate(after, u);
                spin = w;
                kept = math.rotate(after, now.Relative(w)) + body.mass * change;
            }

            body.force += (kept - relative) / h - weight;
            body.moment += air.moment;
            body.acceleration = math.rotate(math.conjugate(middle), change) / h;
            body.spinRate = (spin - body.spin) / h;
            BodyMotion.Advance(ref body, change, spin - body.spin, h);
            body.masses = now;
            body.knowsMasses = 1;
        }

        /// <summary>
        /// Adds to the readings of a body that is held on its bob what the inertia of its wings would do to it beside a body whose wings
        /// keep their mean places: what its bob must answer.
        /// </summary>
        public static unsafe void Hold(ref FlyingBody body, float* point, float phase, float turned, in BodyMasses now, float h)
        {
            if (body.knowsMasses == 0)
                body.masses = now;
            float3 mean = body.reference.velocity;
            BodyMotion.OnBob(
                body, point, BodyBob.At(point, phase - turned), mean, out quaternion before, out float3 velocityBefore,
                out float3 spinBefore);
            BodyMotion.OnBob(
                body, point, BodyBob.At(point, phase), mean, out quaternion after, out float3 velocityAfter, out float3 spinAfter);
            float3 relative = math.rotate(before, body.masses.Relative(spinBefore)),
                relativeAfter = math.rotate(after, now.Relative(spinAfter));
            float3 angular = math.rotate(before, body.masses.Turning(math.rotate(math.conjugate(before), velocityBefore), spinBefore)),
                angularAfter = math.rotate(after, now.Turning(math.rotate(math.conjugate(after), velocityAfter), spinAfter));
            // Of mass times velocity nothing is left: the body beside which it is compared has as much.
            float3 carried = math.cross(body.middleVelocity, 0.5f * (relative + relativeAfter));
            float3 first = math.rotate(body.middleRotation, 0.5f * (body.masses.first + now.first));
            float3 moment = math.cross(first, body.weight) - (angularAfter - angular) / h - carried;
            body.force += (relative - relativeAfter) / h;
            body.moment += math.rotate(math.conjugate(body.middleRotation), moment)
                + math.mul(body.inertia, spinAfter - spinBefore) / h;
            body.masses = now;
            body.knowsMasses = 1;
        }

        // Matrix of w × first for every w.
        private static float3x3 Turning(float3 first) => new float3x3(
            0f, first.z, -first.y,
            -first.z, 0f, first.x,
            first.y, -first.x, 0f);
    }
}
