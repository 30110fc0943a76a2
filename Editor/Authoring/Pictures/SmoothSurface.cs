using System;

namespace Alate.Authoring
{
    /// <summary>A quadratic polynomial over a picture, fitted to some of its pixels by least squares with weights.</summary>
    internal sealed class SmoothSurface
    {
        private const int k_Terms = 6;

        /// <summary>Number added to the diagonal, for pixels that all lie in a line; far below what a hundredth of a shade needs.</summary>
        private const double k_Damping = 1e-9;

        private readonly double[,] m_Normal = new double[k_Terms, k_Terms];
        private readonly double[] m_Right = new double[k_Terms];
        private readonly double[] m_Basis = new double[k_Terms];
        private readonly double m_ScaleX;
        private readonly double m_ScaleY;
        private double[] m_Coefficients = new double[k_Terms];

        /// <param name="width">Of the picture.</param>
        /// <param name="height">Of the picture.</param>
        public SmoothSurface(int width, int height)
        {
            m_ScaleX = 2.0 / width;
            m_ScaleY = 2.0 / height;
        }

        /// <summary>Value of the polynomial at a pixel.</summary>
        public double At(int column, int row)
        {
            double x = column * m_ScaleX - 1.0, y = row * m_ScaleY - 1.0;
            double[] c = m_Coefficients;
            return c[0] + y * (c[2] + c[5] * y) + x * (c[1] + c[4] * y + c[3] * x);
        }

        /// <summary>Adds a pixel to those that the next fit is made to.</summary>
        public void Add(int column, int row, double value, double weight)
        {
            double x = column * m_ScaleX - 1.0, y = row * m_ScaleY - 1.0;
            m_Basis[0] = 1.0;
            m_Basis[1] = x;
            m_Basis[2] = y;
            m_Basis[3] = x * x;
            m_Basis[4] = x * y;
            m_Basis[5] = y * y;
            for (int i = 0; i < k_Terms; i++)
            {
                for (int j = 0; j < k_Terms; j++)
                    m_Normal[i, j] += weight * m_Basis[i] * m_Basis[j];
                m_Right[i] += weight * m_Basis[i] * value;
            }
        }

        /// <summary>Fits the polynomial to the pixels added since the last fit.</summary>
        public void Fit()
        {
            for (int k = 0; k < k_Terms; k++)
                m_Normal[k, k] += k_Damping * (1.0 + m_Normal[0, 0]);
            m_Coefficients = Solve();
            Array.Clear(m_Normal, 0, m_Normal.Length);
            Array.Clear(m_Right, 0, m_Right.Length);
        }

        // Elimination without pivots: the matrix is positive definite.
        private double[] Solve()
        {
            for (int k = 0; k < k_Terms; k++)
            {
                for (int i = k + 1; i < k_Terms; i++)
                {
                    double factor = m_Normal[i, k] / m_Normal[k, k];
                    for (int j = k; j < k_Terms; j++)
                        m_Normal[i, j] -= factor * m_Normal[k, j];
                    m_Right[i] -= factor * m_Right[k];
                }
            }

            double[] solution = new double[k_Terms];
            for (int i = k_Terms - 1; i >= 0; i--)
            {
                double sum = m_Right[i];
                for (int j = i + 1; j < k_Terms; j++)
                    sum -= m_Normal[i, j] * solution[j];
                solution[i] = sum / m_Normal[i, i];
            }

            return solution;
        }
    }
}
