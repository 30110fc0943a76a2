using System;

namespace Alate.Flight
{
    /// <summary>
    /// Gains of the feedback at the beat by a linear regulator on the beat's map, with integrals of the velocity and the last command as
    /// states.
    /// </summary>
    internal static class FlightGains
    {
        private const double k_Degree = Math.PI / 180;

        /// <summary>
        /// Departures that weigh as much as a unit of command: velocity m/s, turn, heading, rate rad/s, integral m. One set for all
        /// insects.
        /// </summary>
        private const double k_Velocity = 0.35, k_Turn = 15 * k_Degree, k_Heading = 6 * k_Degree, k_Rate = 6, k_Integral = 0.21;

        /// <summary>Weight of the last command: none, but that of a well-posed problem.</summary>
        private const double k_Last = 1e-6;

        /// <summary>Fills the gains of a point.</summary>
        /// <returns>Whether there are any.</returns>
        public static bool Write(BeatMap map, float[] point)
        {
            double[,] gains = Of(map.A, map.B, map.B1, new[] { k_Velocity, k_Velocity, k_Turn, k_Rate }, 2, map.Period);
            double[,] side = Of(map.SideA, map.SideB, map.SideB1, new[] { k_Velocity, k_Heading, k_Turn, k_Rate, k_Rate }, 1, map.Period);
            if (gains == null || side == null)
                return false;
            Write(gains, point, TrimPoint.LongGains);
            Write(side, point, TrimPoint.SideGains);
            return true;
        }

        /// <summary>System of departures, integrals of the first of them, and last commands.</summary>
        public static void Augment(
            double[,] a, double[,] b, double[,] b1, int integrals, double period, out double[,] whole, out double[,] input)
        {
            int n = a.GetLength(0), m = b.GetLength(1), size = n + integrals + m;
            whole = new double[size, size];
            input = new double[size, m];
            for (int i = 0; i < n; i++)
            {
                for (int j = 0; j < n; j++)
                    whole[i, j] = a[i, j];
                for (int j = 0; j < m; j++)
                {
                    whole[i, n + integrals + j] = b1[i, j];
                    input[i, j] = b[i, j];
                }
            }

            for (int i = 0; i < integrals; i++)
            {
                whole[n + i, i] = period;
                whole[n + i, n + i] = 1;
            }

            for (int j = 0; j < m; j++)
                input[n + integrals + j, j] = 1;
        }

        private static double[,] Of(double[,] a, double[,] b, double[,] b1, double[] sizes, int integrals, double period)
        {
            Augment(a, b, b1, integrals, period, out double[,] whole, out double[,] input);
            double[] q = new double[whole.GetLength(0)];
            for (int k = 0; k < q.Length; k++)
            {
                double size = k < sizes.Length ? sizes[k] : k_Integral;
                q[k] = k < sizes.Length + integrals ? 1 / (size * size) : k_Last;
            }

            return Riccati.Gains(whole, input, q);
        }

        private static void Write(double[,] gains, float[] point, int at)
        {
            for (int i = 0; i < gains.GetLength(0); i++)
            {
                for (int j = 0; j < gains.GetLength(1); j++)
                    point[at++] = (float)gains[i, j];
            }
        }
    }
}
