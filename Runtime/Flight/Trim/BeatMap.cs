using System;
using Unity.Mathematics;

namespace Alate.Flight
{
    /// <summary>
    /// Map of one beat of free flight from small departures from a trim, and commands of this beat and of the last one, to the departures
    /// of the next beat: x' = A x + B u + B1 u₋₁, by finite differences at equal phase in just the coordinates that the feedback measures.
    /// Longitudinal and lateral motion apart.
    /// </summary>
    internal sealed class BeatMap
    {
        private const int k_Long = 4, k_Side = 5;

        /// <summary>Beats in which the held wings settle.</summary>
        private const int k_SettledBeats = 3;

        /// <summary>Departures: velocity (m/s), turn (radians), rate (rad/s), command (units).</summary>
        private const float k_Velocity = 0.05f, k_Turn = 2f * math.PI / 180f, k_Rate = 1f, k_Command = 0.5f;

        private const int k_Longs = k_Long + TrimPoint.LongCommands, k_Sides = k_Side + TrimPoint.SideCommands;

        /// <summary>Insects that fly it: longitudinal departures both ways, lateral ones one way.</summary>
        public const int Insects = 2 * k_Longs + k_Sides;

        private BeatMap(double period)
        {
            Period = period;
        }

        /// <summary>Seconds of the beat.</summary>
        public double Period { get; }

        /// <summary>Longitudinal A, B and B1.</summary>
        public double[,] A { get; } = new double[k_Long, k_Long];

        public double[,] B { get; } = new double[k_Long, TrimPoint.LongCommands];

        public double[,] B1 { get; } = new double[k_Long, TrimPoint.LongCommands];

        /// <summary>Lateral A, B and B1.</summary>
        public double[,] SideA { get; } = new double[k_Side, k_Side];

        public double[,] SideB { get; } = new double[k_Side, TrimPoint.SideCommands];

        public double[,] SideB1 { get; } = new double[k_Side, TrimPoint.SideCommands];

        /// <summary>Flies the departures.</summary>
        /// <param name="tunnel">With <see cref="Insects"/> insects.</param>
        /// <param name="model">Of the insects.</param>
        /// <param name="trim">From which they depart.</param>
        /// <param name="condition">Of the trim.</param>
        public static BeatMap Fly(FlightTunnel tunnel, FlightModel model, TrimState trim, in FlightCondition condition)
        {
            double frequency = model.Frequency * trim.z[1];
            int substeps = FlightTunnel.Substeps(model, frequency);
            float h = (float)(1 / (frequency * substeps));
            Settle(tunnel, trim, condition, substeps, h);
            var map = new BeatMap(1 / frequency);
            double start = Release(tunnel);
            double[][,] ends = Follow(tunnel, start, substeps, h);
            map.Derive(ends[0], ends[1]);
            return map;
        }

        private static void Settle(FlightTunnel tunnel, TrimState trim, in FlightCondition condition, int substeps, float h)
        {
            for (int k = 0; k < Insects; k++)
            {
                tunnel.Set(k, trim, condition);
                ref FlyingBody body = ref tunnel.World.Body(tunnel.Body(k));
                body.mode = BodyMode.Held;
            }

            // Half a substep ahead: the latch falls into the middle of a substep, whatever the rounding.
            tunnel.Restart();
            tunnel.Resume(0.5f * h);
            for (int step = 0; step < k_SettledBeats * substeps - 1; step++)
                tunnel.World.StepOnce(h);
        }

        private static double Release(FlightTunnel tunnel)
        {
            for (int k = 0; k < Insects; k++)
            {
                tunnel.World.PlaceOnBob(tunnel.Body(k));
                ref FlyingBody body = ref tunnel.World.Body(tunnel.Body(k));
                body.mode = BodyMode.Free;
                body.latched = 0;
                body.steered = 0;
                for (int c = 0; c < FlightCommands.Count; c++)
                    tunnel.World.SetLast(tunnel.Body(k), c, 0f);
                Depart(tunnel, k);
            }

            return tunnel.World.MeasureErrors(tunnel.Body(0));
        }

        private static void Depart(FlightTunnel tunnel, int insect)
        {
            bool isLong = insect < 2 * k_Longs;
            int state = isLong ? insect / 2 : insect - 2 * k_Longs;
            float sign = isLong && insect % 2 == 1 ? -1f : 1f;
            if (state >= (isLong ? k_Long : k_Side))
            {
                int command = isLong ? state - k_Long : state - k_Side + TrimPoint.LongCommands;
                tunnel.World.SetLast(tunnel.Body(insect), command, sign * k_Command);
                return;
            }

            float3 velocity = default, turn = default, rate = default;
            if (isLong)
            {
                velocity = new float3(0f, state == 0 ? k_Velocity : 0f, state == 1 ? k_Velocity : 0f);
                turn.x = state == 2 ? k_Turn : 0f;
                rate.x = state == 3 ? k_Rate : 0f;
            }
            else
            {
                velocity.x = state == 0 ? k_Velocity : 0f;
                turn = new float3(0f, state == 1 ? k_Turn : 0f, state == 2 ? k_Turn : 0f);
                rate = new float3(0f, state == 3 ? k_Rate : 0f, state == 4 ? k_Rate : 0f);
            }

            tunnel.World.Depart(tunnel.Body(insect), sign * velocity, sign * turn, sign * rate);
        }

        // Errors of all insects one and two beats after the start, at equal phase: [beat][insect, coordinate].
        private static double[][,] Follow(FlightTunnel tunnel, double start, int substeps, float h)
        {
            const int coordinates = k_Long + k_Side;
            double[][,] ends = new[] { new double[Insects, coordinates], new double[Insects, coordinates] };
            double[,] before = new double[Insects, coordinates];
            double[] phases = new double[Insects];
            int[] done = new int[Insects];
            for (int k = 0; k < Insects; k++)
                phases[k] = start;
            int left = Insects;
            for (int step = 0; left > 0 && step < 3 * substeps; step++)
            {
                tunnel.World.StepOnce(h);
                left = 0;
                for (int k = 0; k < Insects; k++)
                {
                    double phase = tunnel.World.MeasureErrors(tunnel.Body(k));
                    double[] errors = Errors(tunnel.World.Body(tunnel.Body(k)));
                    double target = start + 2 * Math.PI * (done[k] + 1);
                    bool passes = done[k] < 2 && phase >= target - 1e-4;
                    double share = passes ? (target - phases[k]) / (phase - phases[k]) : 0;
                    for (int c = 0; c < coordinates; c++)
                    {
                        if (passes)
                            ends[done[k]][k, c] = before[k, c] + share * (errors[c] - before[k, c]);
                        before[k, c] = errors[c];
                    }

                    phases[k] = phase;
                    done[k] += passes ? 1 : 0;
                    left += done[k] < 2 ? 1 : 0;
                }
            }

            return ends;
        }

        private static double[] Errors(in FlyingBody body)
        {
            float3 v = body.velocityError, e = body.turnError, w = body.rateError;
            return new double[] { v.y, v.z, e.x, w.x, v.x, e.y, e.z, w.y, w.z };
        }

        private void Derive(double[,] first, double[,] second)
        {
            for (int state = 0; state < k_Longs; state++)
            {
                for (int c = 0; c < k_Long; c++)
                {
                    double one = first[2 * state, c] - first[2 * state + 1, c], two = second[2 * state, c] - second[2 * state + 1, c];
                    if (state < k_Long)
                    {
                        A[c, state] = one / (2 * Size(state, true));
                    }
                    else
                    {
                        B[c, state - k_Long] = one / (2 * k_Command);
                        B1[c, state - k_Long] = two / (2 * k_Command);
                    }
                }
            }

            for (int state = 0; state < k_Sides; state++)
            {
                for (int c = 0; c < k_Side; c++)
                {
                    double one = first[2 * k_Longs + state, k_Long + c], two = second[2 * k_Longs + state, k_Long + c];
                    if (state < k_Side)
                    {
                        SideA[c, state] = one / Size(state, false);
                    }
                    else
                    {
                        SideB[c, state - k_Side] = one / k_Command;
                        SideB1[c, state - k_Side] = two / k_Command;
                    }
                }
            }

            Subtract(A, B, B1);
            Subtract(SideA, SideB, SideB1);
        }

        // With the command held, x2 = (A + 1) B u + B1 u.
        private static void Subtract(double[,] a, double[,] b, double[,] b1)
        {
            double[,] carried = Dense.Multiply(a, b);
            for (int i = 0; i < b.GetLength(0); i++)
            {
                for (int j = 0; j < b.GetLength(1); j++)
                    b1[i, j] -= carried[i, j] + b[i, j];
            }
        }

        private static double Size(int state, bool isLong) =>
            isLong ? (state < 2 ? k_Velocity : state == 2 ? k_Turn : k_Rate) : state == 0 ? k_Velocity : state < 3 ? k_Turn : k_Rate;
    }
}
