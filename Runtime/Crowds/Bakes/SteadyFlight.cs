using Alate.Flight;
using Alate.Geometry;
using Unity.Mathematics;

namespace Alate.Crowds
{
    /// <summary>
    /// A steady flight of an insect by its own wings: mean attitude, velocity and beat of a free flight that has settled, as a bake holds
    /// them.
    /// </summary>
    internal sealed class SteadyFlight
    {
        /// <summary>
        /// Seconds and beats until a flight has settled, beats that are averaged, and samples of each; no divisor of the substeps, so that
        /// all phases count.
        /// </summary>
        private const float k_SettleSeconds = 3f, k_SettleBeats = 24f, k_Samples = 20.8f;

        private const int k_Averaged = 16;

        /// <summary>Error of velocity at which an insect is lost, m/s.</summary>
        private const float k_Lost = 0.5f;

        /// <summary>
        /// Angle by which the wanted course is ahead of the heading at most, radians: an insect that turns slower than the motion says,
        /// such as a fish, turns as fast as it can.
        /// </summary>
        private const float k_Ahead = 1f;

        private float3 m_Velocity, m_Ahead, m_Up;
        private float m_Turning;

        /// <summary>Beat of the right and of the left wings.</summary>
        public WingDrive Right { get; private set; }

        /// <inheritdoc cref="Right"/>
        public WingDrive Left { get; private set; }

        /// <summary>Rotation of the body out of its heading.</summary>
        public quaternion Attitude { get; private set; }

        /// <summary>Flies an insect as a motion says, until it has settled.</summary>
        /// <param name="model">The insect.</param>
        /// <param name="table">Its trims.</param>
        /// <param name="motion">Shares of the table's top speed, and the turn.</param>
        /// <exception cref="BakeException">The insect is lost.</exception>
        public static SteadyFlight Fly(FlightModel model, TrimTable table, BakeMotion motion)
        {
            float speed = motion.Speed * table.TopSpeed;
            table.Climbs(speed, out float least, out float most);
            float climb = math.clamp(motion.Climb * table.TopSpeed, least, most), turning = math.radians(motion.TurnDegrees);
            using var flight = new FreeFlight(model, table, new FlightCondition(speed, climb));
            var steady = new SteadyFlight();
            float dt = 1f / (k_Samples * model.Frequency), settled = math.max(k_SettleSeconds, k_SettleBeats / model.Frequency);
            int first = -1;
            float waited = 0f, waitedBefore = 0f;
            double samples = 0.0, from = 0.0;
            while (first < 0 || flight.Beats < first + k_Averaged)
            {
                float course = turning * (float)flight.Time - waited, ahead = Headings.Wrap(course - flight.Reference.Heading);
                float beyond = ahead - math.clamp(ahead, -k_Ahead, k_Ahead);
                waited += beyond;
                course -= beyond;
                flight.Step(FlightCommand.Fly(Along(course, new float3(0f, climb, speed)), course), dt);
                if (first < 0 && flight.Time > settled)
                {
                    first = flight.Beats + 1;
                    (from, waitedBefore) = (flight.Time, waited);
                }

                if (flight.State == FlightState.Tumbling || !(math.length(flight.VelocityError) < k_Lost))
                {
                    throw new BakeException($"Clip '{motion.Name}' cannot be flown: the insect is lost after "
                        + $"{flight.Time:0.0} s at {speed:0.##} m/s ahead and {climb:0.##} m/s up.");
                }
                if (first < 0 || flight.Beats < first)
                    continue;
                samples++;
                steady.Add(flight, model);
            }

            steady.m_Turning = turning - (waited - waitedBefore) / (float)(flight.Time - from);
            steady.Average((float)(1.0 / samples));
            return steady;
        }

        /// <summary>Motion of the body and the air around it, in the insect's own space.</summary>
        /// <param name="toldMetresPerUnit">What the insect is told; 0 takes each wing's own size for life size.</param>
        /// <param name="metresPerUnit">Metres of a unit of the insect's space.</param>
        public BodyFlight FlightOf(float toldMetresPerUnit, float metresPerUnit)
        {
            quaternion back = math.conjugate(Attitude);
            return new BodyFlight
            {
                velocity = math.rotate(back, m_Velocity) / metresPerUnit,
                angularVelocity = math.rotate(back, new float3(0f, m_Turning, 0f)),
                gravity = math.rotate(back, EarthGravity.Down),
                forward = new float3(0f, 0f, 1f),
                metresPerUnit = toldMetresPerUnit,
            };
        }

        private void Add(FreeFlight flight, FlightModel model)
        {
            float heading = flight.Reference.Heading;
            m_Velocity += Along(-heading, flight.Velocity);
            m_Ahead += Along(-heading, math.rotate(flight.Rotation, new float3(0f, 0f, 1f)));
            m_Up += Along(-heading, math.rotate(flight.Rotation, new float3(0f, 1f, 0f)));
            for (int wing = 0; wing < 2; wing++)
            {
                WingDrive drive = flight.World.Drive(flight.Wings[wing]);
                if (model.Wings[wing].IsLeft)
                    Left = Sum(Left, drive);
                else
                    Right = Sum(Right, drive);
            }
        }

        private void Average(float share)
        {
            m_Velocity *= share;
            Attitude = quaternion.LookRotation(math.normalize(m_Ahead), math.normalize(m_Up));
            Right = Scaled(Right, share);
            Left = Scaled(Left, share);
        }

        private static float3 Along(float heading, float3 vector) => math.rotate(Rotations.AboutY(heading), vector);

        /// <summary>Sums of the numbers of two beats.</summary>
        internal static WingDrive Sum(in WingDrive a, in WingDrive b) => new WingDrive
        {
            frequency = a.frequency + b.frequency,
            amplitude = a.amplitude + b.amplitude,
            meanFlap = a.meanFlap + b.meanFlap,
            meanSweep = a.meanSweep + b.meanSweep,
            meanFeather = a.meanFeather + b.meanFeather,
            tilt = a.tilt + b.tilt,
        };

        /// <summary>A beat's numbers times a share.</summary>
        internal static WingDrive Scaled(in WingDrive drive, float share) => new WingDrive
        {
            frequency = drive.frequency * share,
            amplitude = drive.amplitude * share,
            meanFlap = drive.meanFlap * share,
            meanSweep = drive.meanSweep * share,
            meanFeather = drive.meanFeather * share,
            tilt = drive.tilt * share,
        };
    }
}
