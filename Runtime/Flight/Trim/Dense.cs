using System;
using System.Numerics;

namespace Alate.Flight
{
    /// <summary>Small dense matrices in double precision.</summary>
    internal static class Dense
    {
        /// <summary>Solves the system whose right side is its last column, by elimination with pivoting.</summary>
        public static double[] Solve(double[,] system)
        {
            int n = system.GetLength(0);
            var complex = new Complex[n, n + 1];
            for (int i = 0; i < n; i++)
            {
                for (int j = 0; j <= n; j++)
                    complex[i, j] = system[i, j];
            }

            return Array.ConvertAll(Solve(complex), value => value.Real);
        }

        /// <summary>Solves the system whose right side is its last column, by elimination with pivoting.</summary>
        public static Complex[] Solve(Complex[,] system)
        {
            int n = system.GetLength(0);
            for (int i = 0; i < n; i++)
            {
                int pivot = i;
                for (int k = i + 1; k < n; k++)
                    pivot = system[k, i].Magnitude > system[pivot, i].Magnitude ? k : pivot;
                for (int j = 0; j <= n; j++)
                    (system[i, j], system[pivot, j]) = (system[pivot, j], system[i, j]);
                for (int k = i + 1; k < n; k++)
                {
                    Complex factor = system[k, i] / system[i, i];
                    for (int j = i; j <= n; j++)
                        system[k, j] -= factor * system[i, j];
                }
            }

            var x = new Complex[n];
            for (int i = n - 1; i >= 0; i--)
            {
                x[i] = system[i, n];
                for (int k = i + 1; k < n; k++)
                    x[i] -= system[i, k] * x[k];
                x[i] /= system[i, i];
            }

            return x;
        }

        /// <summary>A B.</summary>
        public static double[,] Multiply(double[,] a, double[,] b)
        {
            int n = a.GetLength(0), m = b.GetLength(1), inner = b.GetLength(0);
            double[,] product = new double[n, m];
            for (int i = 0; i < n; i++)
            {
                for (int k = 0; k < inner; k++)
                {
                    double factor = a[i, k];
                    for (int j = 0; j < m; j++)
                        product[i, j] += factor * b[k, j];
                }
            }

            return product;
        }

        /// <summary>Aᵀ.</summary>
        public static double[,] Transpose(double[,] a)
        {
            double[,] turned = new double[a.GetLength(1), a.GetLength(0)];
            for (int i = 0; i < a.GetLength(0); i++)
            {
                for (int j = 0; j < a.GetLength(1); j++)
                    turned[j, i] = a[i, j];
            }

            return turned;
        }

        /// <summary>A + s B.</summary>
        public static double[,] Add(double[,] a, double[,] b, double s = 1)
        {
            double[,] sum = new double[a.GetLength(0), a.GetLength(1)];
            for (int i = 0; i < a.GetLength(0); i++)
            {
                for (int j = 0; j < a.GetLength(1); j++)
                    sum[i, j] = a[i, j] + s * b[i, j];
            }

            return sum;
        }

        /// <summary>X with A X = B.</summary>
        public static double[,] SolveMany(double[,] a, double[,] b)
        {
            int n = a.GetLength(0), m = b.GetLength(1);
            double[,] x = new double[n, m];
            for (int j = 0; j < m; j++)
            {
                double[,] system = new double[n, n + 1];
                for (int i = 0; i < n; i++)
                {
                    for (int k = 0; k < n; k++)
                        system[i, k] = a[i, k];
                    system[i, n] = b[i, j];
                }

                double[] column = Solve(system);
                for (int i = 0; i < n; i++)
                    x[i, j] = column[i];
            }

            return x;
        }
    }
}
