using System;

namespace Alate.Flight
{
    /// <summary>Gains of the discrete linear regulator: u = −K x minimises Σ xᵀQx + uᵀu for x' = A x + B u.</summary>
    internal static class Riccati
    {
        private const int k_Iterations = 60;
        private const double k_Tolerance = 1e-12;

        /// <summary>Solves by doubling; the cost of a horizon of 2ⁿ beats after n rounds.</summary>
        /// <param name="a">[state][state].</param>
        /// <param name="b">[state][command].</param>
        /// <param name="q">[state] Diagonal of Q.</param>
        /// <returns>[command][state] K; null where no gains hold the system.</returns>
        public static double[,] Gains(double[,] a, double[,] b, double[] q)
        {
            double[,] cost = Cost(a, b, q);
            if (cost == null)
                return null;
            double[,] bt = Dense.Transpose(b), btp = Dense.Multiply(bt, cost);
            double[,] inner = Dense.Multiply(btp, b);
            for (int k = 0; k < inner.GetLength(0); k++)
                inner[k, k] += 1;
            return Dense.SolveMany(inner, Dense.Multiply(btp, a));
        }

        /// <summary>P of the cost xᵀPx by the structure-preserving doubling algorithm; null where it does not settle.</summary>
        public static double[,] Cost(double[,] a, double[,] b, double[] q)
        {
            int n = a.GetLength(0);
            double[,] g = Dense.Multiply(b, Dense.Transpose(b)), h = new double[n, n];
            for (int k = 0; k < n; k++)
                h[k, k] = q[k];
            for (int iteration = 0; iteration < k_Iterations; iteration++)
            {
                double[,] w = Dense.Multiply(g, h);
                for (int k = 0; k < n; k++)
                    w[k, k] += 1;
                double[,] at = Dense.Transpose(a), wa = Dense.SolveMany(w, a), wg = Dense.SolveMany(w, g);
                double[,] next = Dense.Add(h, Dense.Multiply(Dense.Multiply(at, h), wa));
                g = Dense.Add(g, Dense.Multiply(Dense.Multiply(a, wg), at));
                a = Dense.Multiply(a, wa);
                double change = 0, size = 0;
                for (int i = 0; i < n; i++)
                {
                    for (int j = 0; j < n; j++)
                    {
                        change = Math.Max(change, Math.Abs(next[i, j] - h[i, j]));
                        size = Math.Max(size, Math.Abs(next[i, j]));
                    }
                }

                if (double.IsNaN(size) || double.IsInfinity(size))
                    return null;
                h = next;
                if (change <= k_Tolerance * size)
                    return h;
            }

            return null;
        }
    }
}
