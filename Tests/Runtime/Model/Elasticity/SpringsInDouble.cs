using System;

namespace Alate.Tests
{
    /// <summary>
    /// Newton's method in double precision for a chain whose first joint is pinned at the origin: what the solver of the elastic step is
    /// compared with.
    /// </summary>
    internal sealed class SpringsInDouble
    {
        private readonly double m_Stiffness, m_Length;
        private readonly double[] m_Inertia, m_Anchors;

        /// <param name="stiffness">Of every spring.</param>
        /// <param name="length">Of every spring at rest.</param>
        /// <param name="inertia">[joint] Stiffness that holds each free joint at its anchor.</param>
        /// <param name="anchors">[3 · joint + axis] Where each free joint is held.</param>
        public SpringsInDouble(double stiffness, double length, double[] inertia, double[] anchors)
        {
            m_Stiffness = stiffness;
            m_Length = length;
            m_Inertia = inertia;
            m_Anchors = anchors;
        }

        /// <summary>Full steps from a place, [3 · joint + axis].</summary>
        public double[] Minimise(double[] start, int steps)
        {
            double[] x = (double[])start.Clone();
            for (int k = 0; k < steps; k++)
            {
                double[] step = Step(x);
                for (int i = 0; i < x.Length; i++)
                    x[i] += step[i];
            }

            return x;
        }

        private double[] Step(double[] x)
        {
            int count = x.Length;
            double[,] system = new double[count, count + 1];
            for (int i = 0; i < count; i++)
            {
                system[i, i] = m_Inertia[i / 3];
                system[i, count] = -m_Inertia[i / 3] * (x[i] - m_Anchors[i]);
            }

            for (int b = 0; b < count; b += 3)
                AddSpring(system, x, b - 3, b);
            return Solve(system);
        }

        // Between joint b and the one before, which is the pinned root where a is negative.
        private void AddSpring(double[,] system, double[] x, int a, int b)
        {
            int count = x.Length;
            double[] axis = new double[3];
            double length = 0.0;
            for (int i = 0; i < 3; i++)
            {
                axis[i] = x[b + i] - (a < 0 ? 0.0 : x[a + i]);
                length += axis[i] * axis[i];
            }

            length = Math.Sqrt(length);
            for (int i = 0; i < 3; i++)
            {
                double pull = m_Stiffness * (length - m_Length) * axis[i] / length;
                system[b + i, count] -= pull;
                if (a >= 0)
                    system[a + i, count] += pull;
                for (int j = 0; j < 3; j++)
                {
                    double outer = axis[i] * axis[j] / (length * length);
                    double block = m_Stiffness * (outer + (1.0 - m_Length / length) * ((i == j ? 1.0 : 0.0) - outer));
                    system[b + i, b + j] += block;
                    if (a < 0)
                        continue;
                    system[a + i, a + j] += block;
                    system[a + i, b + j] -= block;
                    system[b + i, a + j] -= block;
                }
            }
        }

        // Gauss and Jordan; the system is positive definite.
        private static double[] Solve(double[,] system)
        {
            int count = system.GetLength(0);
            for (int pivot = 0; pivot < count; pivot++)
            {
                for (int row = 0; row < count; row++)
                {
                    double factor = row == pivot ? 0.0 : system[row, pivot] / system[pivot, pivot];
                    for (int column = pivot; column <= count; column++)
                        system[row, column] -= factor * system[pivot, column];
                }
            }

            double[] solution = new double[count];
            for (int k = 0; k < count; k++)
                solution[k] = system[k, count] / system[k, k];
            return solution;
        }
    }
}
