using System;
using System.Collections.Generic;
using MathNet.Numerics.LinearAlgebra;

namespace Alate.Tests
{
    /// <summary>
    /// The bends that minimise Σ ½ (θ − θ*)²/c + Σ ½ K max(|s| − s₀, 0)² with s linear in the bends: by Newton on the set of strips that
    /// are beyond s₀, dense and in double precision.
    /// </summary>
    internal sealed class DenseCoupling
    {
        private readonly List<(double[] Levers, double Stiffness)> m_Strips = new List<(double[], double)>();
        private readonly double[] m_Wanted;
        private readonly double[] m_Compliance;
        private readonly double m_Free;

        /// <param name="wanted">[bone] θ*.</param>
        /// <param name="compliance">[bone] c.</param>
        /// <param name="free">s₀.</param>
        public DenseCoupling(double[] wanted, double[] compliance, double free)
        {
            m_Wanted = wanted;
            m_Compliance = compliance;
            m_Free = free;
        }

        /// <param name="levers">[bone] Slope for a radian of each bend.</param>
        /// <param name="stiffness">K.</param>
        public void Add(double[] levers, double stiffness) => m_Strips.Add((levers, stiffness));

        /// <summary>The bends at the minimum.</summary>
        public double[] Minimum()
        {
            double[] bends = (double[])m_Wanted.Clone();
            for (int iteration = 0; iteration < 200; iteration++)
            {
                Vector<double> gradient = Linearise(bends, out Matrix<double> hessian);
                if (gradient.L2Norm() < 1e-13 * Scale)
                    return bends;
                Vector<double> step = -hessian.Cholesky().Solve(gradient);
                double slope = gradient * step, energy = Energy(bends), share = 1.0;
                double[] moved = new double[bends.Length];
                for (; share > 1e-12; share *= 0.5)
                {
                    for (int k = 0; k < moved.Length; k++)
                        moved[k] = bends[k] + share * step[k];
                    if (Energy(moved) <= energy + 1e-4 * share * slope)
                        break;
                }

                if (Math.Abs(slope) < 1e-14 * energy)
                    return bends;
                bends = moved;
            }

            throw new InvalidOperationException("The minimum was not found.");
        }

        /// <summary>The function.</summary>
        public double Energy(double[] bends)
        {
            double energy = 0.0;
            for (int k = 0; k < bends.Length; k++)
                energy += 0.5 * (bends[k] - m_Wanted[k]) * (bends[k] - m_Wanted[k]) / m_Compliance[k];
            foreach ((double[] levers, double stiffness) in m_Strips)
            {
                double over = Math.Max(Math.Abs(Slope(levers, bends)) - m_Free, 0.0);
                energy += 0.5 * stiffness * over * over;
            }

            return energy;
        }

        private double Scale
        {
            get
            {
                double scale = 0.0;
                for (int k = 0; k < m_Compliance.Length; k++)
                    scale += Math.Abs(m_Wanted[k]) / m_Compliance[k];
                return scale;
            }
        }

        private Vector<double> Linearise(double[] bends, out Matrix<double> hessian)
        {
            int count = bends.Length;
            hessian = Matrix<double>.Build.Dense(count, count);
            Vector<double> gradient = Vector<double>.Build.Dense(count);
            for (int k = 0; k < count; k++)
            {
                hessian[k, k] = 1.0 / m_Compliance[k];
                gradient[k] = (bends[k] - m_Wanted[k]) / m_Compliance[k];
            }

            foreach ((double[] levers, double stiffness) in m_Strips)
            {
                double slope = Slope(levers, bends), over = slope - Math.Clamp(slope, -m_Free, m_Free);
                if (over == 0.0)
                    continue;
                for (int a = 0; a < count; a++)
                {
                    gradient[a] += stiffness * over * levers[a];
                    for (int b = 0; b < count; b++)
                        hessian[a, b] += stiffness * levers[a] * levers[b];
                }
            }

            return gradient;
        }

        private static double Slope(double[] levers, double[] bends)
        {
            double slope = 0.0;
            for (int k = 0; k < bends.Length; k++)
                slope += levers[k] * bends[k];
            return slope;
        }
    }
}
