using System;
using System.Numerics;
using Unity.Mathematics;

namespace Alate.Flight
{
    /// <summary>Trim by flight: the loop is closed for some seconds, and what it settles on is the trim and the bob.</summary>
    internal static class FlownTrim
    {
        /// <summary>Seconds flown and averaged at the end; slow beats take longer.</summary>
        private const double k_Seconds = 5, k_Averaged = 2, k_LeastBeats = 24;

        /// <summary>Step of the games that it is flown in, seconds.</summary>
        private const float k_Step = 0.01f;

        /// <summary>Error of velocity at which an insect is lost, m/s.</summary>
        private const double k_Lost = 0.6;

        /// <summary>Flies at a point from its trim.</summary>
        /// <returns>The trim that it settled on; null where it is lost.</returns>
        public static TrimState Fly(FlightModel model, float[] point, TrimState trim, in FlightCondition condition, out string lost)
        {
            using var flight = new FlightTunnel(model, 1);
            flight.Set(0, trim, condition, point);
            flight.Restart();
            double frequency = model.Frequency * trim.z[1];
            int settle = (int)Math.Ceiling(4 / (frequency * k_Step));
            for (int k = 0; k < settle; k++)
                flight.World.Step(k_Step);
            flight.World.PlaceOnBob(flight.Body(0));
            flight.World.Body(flight.Body(0)).mode = BodyMode.Free;
            flight.World.Body(flight.Body(0)).steered = 1;
            double seconds = Math.Max(k_Seconds, k_LeastBeats / frequency * k_Seconds / k_Averaged);
            var mean = new FlownMean(trim);
            float h = (float)(1 / (frequency * Math.Ceiling(20.8 * model.Frequency / frequency)));
            lost = null;
            for (double time = 0; time < seconds; time += h)
            {
                flight.World.StepOnce(h);
                flight.World.MeasureErrors(flight.Body(0));
                ref FlyingBody body = ref flight.World.Body(flight.Body(0));
                double error = math.length(body.velocityError);
                if (!(error < k_Lost) || !(math.length(body.turnError) < 1.5f))
                {
                    lost = FormattableString.Invariant($"is lost after {time:0.0} s.");
                    return null;
                }

                if (time > seconds * (1 - k_Averaged / k_Seconds))
                    mean.Add(body, flight.Wing(0), h);
            }

            return mean.Trim(model.Frequency);
        }

        // Sums of commands, attitude and motion over the beats, with the harmonics of the motion.
        private sealed class FlownMean
        {
            private readonly TrimState m_From;
            private readonly double[] m_Commands = new double[TrimPoint.LongCommands], m_Motion = new double[TrimPoint.Bobbing];
            private readonly Complex[,] m_Harmonics = new Complex[TrimPoint.Bobbing, TrimPoint.Harmonics];
            private double m_Weight;

            public FlownMean(TrimState from) => m_From = from;

            public void Add(in FlyingBody body, in WingReading wing, double h)
            {
                // By phase, not by time: every part of the beat weighs the same.
                double share = h * wing.Frequency, phase = wing.Phase;
                float3 v = body.velocityError;
                double[] motion = { v.y, v.z, body.turnError.x, body.rateError.x };
                m_Weight += share;
                for (int q = 0; q < motion.Length; q++)
                {
                    m_Motion[q] += share * motion[q];
                    for (int k = 0; k < TrimPoint.Harmonics; k++)
                        m_Harmonics[q, k] += 2 * share * motion[q] * Complex.FromPolarCoordinates(1, -(k + 1) * phase);
                }

                for (int k = 0; k < m_Commands.Length; k++)
                    m_Commands[k] += share * body.Last(k) * FlightCommands.Unit(k, body.frequency);
            }

            public TrimState Trim(float frequency)
            {
                TrimState trim = m_From.Copy();
                // Errors are departures from the old trim and bob: what is left of them on average belongs to the new ones.
                trim.z[0] -= m_Motion[2] / m_Weight;
                trim.z[1] += m_Commands[0] / m_Weight / frequency;
                for (int k = 1; k < m_Commands.Length; k++)
                    trim.z[k + 1] += m_Commands[k] / m_Weight;
                for (int q = 0; q < TrimPoint.Bobbing; q++)
                {
                    for (int k = 0; k < TrimPoint.Harmonics; k++)
                    {
                        int at = 2 * (q * TrimPoint.Harmonics + k);
                        trim.bob[at] += m_Harmonics[q, k].Real / m_Weight;
                        trim.bob[at + 1] -= m_Harmonics[q, k].Imaginary / m_Weight;
                    }
                }

                return trim;
            }
        }
    }
}
