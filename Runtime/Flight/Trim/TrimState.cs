using System;
using System.Collections.Generic;
using Alate.Geometry;
using Unity.Mathematics;

namespace Alate.Flight
{
    /// <summary>
    /// Attitude and beat that may carry an insect: pitch, frequency, amplitude, tilt and mean sweep, and the bob of the body in the beat.
    /// </summary>
    public sealed class TrimState
    {
        internal const int Unknowns = 5;

        private static readonly double[] s_Least = { Degrees(-20), 0.85, 0.55, Degrees(-40), Degrees(-30) };
        private static readonly double[] s_Most = { Degrees(88), 1.20, 1.25, Degrees(60), Degrees(30) };

        /// <summary>Pitch, radians; f/F0; factor of the amplitude; tilt and mean sweep, radians.</summary>
        internal readonly double[] z = { Degrees(45), 1, 1, 0, 0 };

        /// <summary>[coordinate][harmonic] cosine, sine, as in <see cref="TrimPoint"/>.</summary>
        internal readonly double[] bob = new double[2 * TrimPoint.Harmonics * TrimPoint.Bobbing];

        /// <summary>[pair] Air that the wake sets moving at the wings, wing lengths per second.</summary>
        internal readonly WingInflow[] inflow = new WingInflow[TrimPoint.Pairs];

        /// <summary>Pitch of the body, radians, nose up.</summary>
        public double Pitch => z[0];

        /// <summary>Frequency over that of the parameters.</summary>
        public double FrequencyScale => z[1];

        /// <summary>Factor on the amplitudes of the parameters.</summary>
        public double AmplitudeScale => z[2];

        /// <summary>Tilt of the stroke plane, radians, nose up.</summary>
        public double Tilt => z[3];

        /// <summary>Middle of the stroke ahead, radians.</summary>
        public double MeanSweep => z[4];

        /// <summary>[pair of wings] Air that the wake sets moving at them, in the frame of a right wing, wing lengths per second.</summary>
        public IReadOnlyList<WingInflow> Inflow => inflow;

        /// <summary>Half of what the pitch bobs by in a beat, radians.</summary>
        public double PitchBob
        {
            get
            {
                double least = 0, most = 0;
                for (int step = 0; step < 90; step++)
                {
                    double turn = Bob(2, step / 90.0, false);
                    least = Math.Min(least, turn);
                    most = Math.Max(most, turn);
                }

                return 0.5 * (most - least);
            }
        }

        /// <summary>Rotation of the body without its bob, its heading ahead.</summary>
        internal quaternion MeanRotation => Rotations.AboutX(-(float)z[0]);

        /// <summary>Rotation of the body at a time, its heading ahead.</summary>
        /// <param name="beats">Time, beats.</param>
        internal quaternion RotationAt(double beats) => Rotations.AboutX((float)(Bob(2, beats, false) - z[0]));

        /// <summary>Place of the centre of mass about the steady motion at a time, metres.</summary>
        /// <param name="beats">Time, beats.</param>
        /// <param name="period">Seconds of a beat.</param>
        internal float3 PlaceAt(double beats, double period) =>
            new float3(0f, (float)(period * Bob(0, beats, true)), (float)(period * Bob(1, beats, true)));

        // Sum of a coordinate's harmonics, or of their integrals over time in beats.
        private double Bob(int coordinate, double beats, bool isIntegral)
        {
            double sum = 0;
            for (int k = 1; k <= TrimPoint.Harmonics; k++)
            {
                int place = 2 * (coordinate * TrimPoint.Harmonics + k - 1);
                double turn = 2 * Math.PI * k * (beats - Math.Floor(beats)), cos = Elementary.Cos(turn), sin = Elementary.Sin(turn);
                sum += isIntegral ? (bob[place] * sin - bob[place + 1] * cos) / (2 * Math.PI * k) : bob[place] * cos + bob[place + 1] * sin;
            }

            return sum;
        }

        /// <summary>A start for slow flight: steep, with a tilted stroke.</summary>
        internal static TrimState Tilted()
        {
            var state = new TrimState();
            state.z[0] = Degrees(58);
            state.z[1] = 0.95;
            state.z[2] = 0.9;
            state.z[3] = Degrees(40);
            return state;
        }

        /// <summary>A copy.</summary>
        public TrimState Copy()
        {
            var copy = new TrimState();
            Array.Copy(z, copy.z, z.Length);
            Array.Copy(bob, copy.bob, bob.Length);
            Array.Copy(inflow, copy.inflow, inflow.Length);
            return copy;
        }

        /// <summary>The state in the middle between two.</summary>
        internal static TrimState Middle(TrimState a, TrimState b)
        {
            TrimState middle = a.Copy();
            for (int k = 0; k < middle.z.Length; k++)
                middle.z[k] = 0.5 * (a.z[k] + b.z[k]);
            for (int k = 0; k < middle.bob.Length; k++)
                middle.bob[k] = 0.5 * (a.bob[k] + b.bob[k]);
            for (int pair = 0; pair < middle.inflow.Length; pair++)
                middle.inflow[pair] = (a.inflow[pair] + b.inflow[pair]) * 0.5f;
            return middle;
        }

        /// <summary>Least and most of an unknown.</summary>
        internal static double Least(int unknown) => s_Least[unknown];

        internal static double Most(int unknown) => s_Most[unknown];

        /// <summary>Writes the state into a point of a table.</summary>
        internal void Write(float[] point, float frequency)
        {
            point[TrimPoint.Pitch] = (float)z[0];
            point[TrimPoint.Drive] = (float)(z[1] * frequency);
            point[TrimPoint.Drive + 1] = (float)z[2];
            point[TrimPoint.Drive + 2] = (float)z[3];
            point[TrimPoint.Drive + 3] = (float)z[4];
            for (int k = 0; k < bob.Length; k++)
                point[TrimPoint.Bob + k] = (float)bob[k];
            for (int pair = 0; pair < inflow.Length; pair++)
                BodyWake.Write(point, pair, inflow[pair]);
        }

        /// <summary>The state of a table's point.</summary>
        internal static TrimState Read(float[] point, float frequency)
        {
            var state = new TrimState();
            state.z[0] = point[TrimPoint.Pitch];
            state.z[1] = point[TrimPoint.Drive] / frequency;
            for (int k = 1; k < TrimPoint.LongCommands; k++)
                state.z[k + 1] = point[TrimPoint.Drive + k];
            for (int k = 0; k < state.bob.Length; k++)
                state.bob[k] = point[TrimPoint.Bob + k];
            for (int pair = 0; pair < state.inflow.Length; pair++)
                state.inflow[pair] = BodyWake.Read(point, pair);
            return state;
        }

        /// <summary>The beat of a wing.</summary>
        internal WingDrive Drive(float frequency) => new WingDrive
        {
            frequency = (float)(z[1] * frequency),
            amplitude = (float)z[2],
            tilt = (float)z[3],
            meanSweep = (float)z[4],
        };

        private static double Degrees(double degrees) => degrees * math.PI / 180.0;
    }
}
