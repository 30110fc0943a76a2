using Alate.Geometry;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Feedback once a beat, sampled just before the wings latch the next one: errors of velocity, attitude and rates against the
    /// reference, less the periodic bob of this phase, times gains of the trim table's point, make the commands of the next beat. Acts
    /// through the wings alone.
    /// </summary>
    internal static unsafe class BodyFeedback
    {
        /// <summary>Errors of velocity count no more than this, m/s.</summary>
        private const float k_MostError = 0.5f;

        /// <summary>Bound of the integral, metres.</summary>
        private const float k_MostIntegral = 1f;

        /// <summary>Largest error of the heading that the aid sees, radians.</summary>
        private const float k_MostHeading = 0.8f;

        /// <summary>
        /// Turn out of the trim, radians, and rate, rad/s, less the bob, below which a body that tumbled has righted itself.
        /// </summary>
        private const float k_Righted = math.PI / 6f, k_RightedRate = 15f;

        /// <summary>Largest lean into a turn, radians: where little gravity pulls, lift turns no insect quicker.</summary>
        private const float k_MostLean = 1f;

        /// <summary>Samples the body at a phase and makes the commands; writes the drive of each wing.</summary>
        public static void Sample(ref FlyingBody body, float phase, float* point)
        {
            var bob = BodyBob.At(point, phase);
            Errors(ref body, point, bob);
            float speed = math.length(body.velocityError);
            float3 dv = body.velocityError * (speed > k_MostError ? k_MostError / speed : 1f);
            Right(ref body);
            if (body.rights != 0)
            {
                // Attitude first: the commands that a fall asks for clip, and turn a body that tumbles on and on.
                dv = default;
                body.integral = default;
            }

            var lean = new float3(0f, 0f, -Lean(body));
            float3 e = body.turnError - lean, w = body.rateError, i = body.integral;
            if (body.clipped == 0 && body.rights == 0 && speed < k_MostError)
                body.integral = math.clamp(body.integral + dv * body.sinceSample, -k_MostIntegral, k_MostIntegral);
            body.sinceSample = 0f;
            float* states = stackalloc float[TrimPoint.LongStates];
            states[0] = dv.y;
            states[1] = dv.z;
            states[2] = e.x;
            states[3] = w.x;
            states[4] = i.y;
            states[5] = i.z;
            for (int k = 0; k < TrimPoint.LongCommands; k++)
                states[6 + k] = body.last[k];
            float* side = stackalloc float[TrimPoint.SideStates];
            side[0] = dv.x;
            side[1] = e.y;
            side[2] = e.z;
            side[3] = w.y;
            side[4] = w.z;
            side[5] = i.x;
            for (int k = 0; k < TrimPoint.SideCommands; k++)
                side[6 + k] = body.last[TrimPoint.LongCommands + k];

            body.clipped = 0;
            Command(ref body, point + TrimPoint.LongGains, states, 0, TrimPoint.LongCommands, TrimPoint.LongStates);
            Command(ref body, point + TrimPoint.SideGains, side, TrimPoint.LongCommands, TrimPoint.SideCommands, TrimPoint.SideStates);
            if (body.rights != 0)
                BeatHard(ref body);
        }

        // As fast and as far as the wings may: more air on them turns the body sooner.
        private static void BeatHard(ref FlyingBody body)
        {
            for (int command = 0; command < 2; command++)
                body.last[command] = FlightCommands.Limit(command);
        }

        private static void Right(ref FlyingBody body)
        {
            if (body.recovers == 0)
                body.rights = 0;
            else if (body.Tumbles)
                body.rights = 1;
            else if (body.tilt < k_Righted && math.length(body.rateError) < k_RightedRate)
                body.rights = 0;
        }

        /// <summary>Drive of a wing by the point's trim alone.</summary>
        public static WingDrive Trim(float* point) => new WingDrive
        {
            frequency = point[TrimPoint.Drive],
            amplitude = point[TrimPoint.Drive + 1],
            tilt = point[TrimPoint.Drive + 2],
            meanSweep = point[TrimPoint.Drive + 3],
        };

        /// <summary>Drive of a wing by the point's trim and the last commands.</summary>
        public static WingDrive Drive(in FlyingBody body, float* point, float side)
        {
            fixed (float* last = body.last)
            {
                return new WingDrive
                {
                    frequency = math.clamp(point[TrimPoint.Drive] + last[0] * FlightCommands.Unit(0, body.frequency), 0.1f, 1000f),
                    amplitude = math.clamp(
                        point[TrimPoint.Drive + 1] + last[1] * FlightCommands.Unit(1, 0f) + side * last[4] * FlightCommands.Unit(4, 0f), 0f,
                        2f),
                    tilt = point[TrimPoint.Drive + 2] + last[2] * FlightCommands.Unit(2, 0f),
                    meanSweep = point[TrimPoint.Drive + 3] + last[3] * FlightCommands.Unit(3, 0f),
                    meanFeather = side * last[5] * FlightCommands.Unit(5, 0f),
                };
            }
        }

        /// <summary>Errors along the axes of the wanted heading against reference, trim and bob.</summary>
        /// <returns>The wanted heading.</returns>
        public static quaternion Errors(ref FlyingBody body, float* point, in BodyBob bob)
        {
            quaternion wanted = Rotations.AboutY(body.reference.heading), back = math.conjugate(wanted);
            float3 turned = BodyMotion.Log(math.mul(body.rotation, math.conjugate(Trimmed(wanted, point))));
            body.velocityError = math.rotate(back, body.velocity - body.reference.velocity) - bob.velocity;
            body.turnError = math.rotate(back, turned) - new float3(bob.turn, 0f, 0f);
            body.rateError = math.rotate(back, math.rotate(body.rotation, body.spin)) - new float3(bob.rate, body.reference.turning, 0f);
            body.tilt = math.length(TurnApart(body, point, bob, out _).xz);
            return wanted;
        }

        /// <summary>
        /// Turn out of the trimmed attitude along the axes of the body's own heading, taken apart into the error of the heading (y), at
        /// most 0.8 rad, and tilt: a body that looks the wrong way is upright.
        /// </summary>
        public static float3 TurnApart(in FlyingBody body, float* point, in BodyBob bob, out quaternion heading)
        {
            quaternion wanted = Rotations.AboutY(body.reference.heading);
            quaternion error = math.mul(body.rotation, math.conjugate(Trimmed(wanted, point)));
            float4 e = error.value.w < 0f ? -error.value : error.value;
            float off = 2f * Elementary.Atan2(e.y, e.w);
            quaternion twist = Rotations.AboutY(off);
            heading = math.mul(wanted, twist);
            float3 tilt = math.rotate(math.conjugate(heading), BodyMotion.Log(math.mul(error, math.conjugate(twist))));
            return tilt + new float3(-bob.turn, math.clamp(off, -k_MostHeading, k_MostHeading), 0f);
        }

        private static quaternion Trimmed(quaternion heading, float* point) =>
            math.mul(heading, Rotations.AboutX(-point[TrimPoint.Pitch]));

        // By the scene's gravity, against which the lift leans; where there is none nothing is to be held up.
        private static float Lean(in FlyingBody body)
        {
            float gravity = math.length(body.gravity);
            return gravity > 0f ? math.clamp(LateralAcceleration(body.reference) / gravity, -k_MostLean, k_MostLean) : 0f;
        }

        /// <summary>Acceleration of the reference to the right of its heading, m/s².</summary>
        private static float LateralAcceleration(in BodyReference reference)
        {
            Elementary.SinCos(reference.heading, out float sin, out float cos);
            return reference.acceleration.x * cos - reference.acceleration.z * sin;
        }

        private static void Command(ref FlyingBody body, float* gains, float* states, int first, int commands, int count)
        {
            float* made = stackalloc float[TrimPoint.LongCommands];
            for (int k = 0; k < commands; k++)
            {
                float sum = 0f;
                for (int s = 0; s < count; s++)
                    sum -= gains[k * count + s] * states[s];
                float limit = FlightCommands.Limit(first + k);
                made[k] = math.clamp(sum, -limit, limit);
                if (made[k] != sum)
                    body.clipped++;
            }

            for (int k = 0; k < commands; k++)
                body.last[first + k] = made[k];
        }
    }
}
