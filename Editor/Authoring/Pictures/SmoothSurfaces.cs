using System;

namespace Alate.Authoring
{
    /// <summary>
    /// Quadratic polynomials over a picture, one for each channel, fitted to some of its pixels by least squares with weights.
    /// </summary>
    internal sealed class SmoothSurfaces
    {
        private const int k_Terms = 6;

        /// <summary>Number added to the diagonal, for pixels that all lie in a line; far below what a hundredth of a shade needs.</summary>
        private const double k_Damping = 1e-9;

        private readonly double[,] m_Normal = new double[k_Terms, k_Terms];
        private readonly double[] m_Basis = new double[k_Terms];
        private readonly double m_ScaleX;
        private readonly double m_ScaleY;

        /// <summary>[channel, term]</summary>
        private readonly double[,] m_Right;

        /// <summary>[channel, term]</summary>
        private readonly double[,] m_Coefficients;

        /// <param name="width">Of the picture.</param>
        /// <param name="height">Of the picture.</param>
        /// <param name="channels">Number of polynomials.</param>
        public SmoothSurfaces(int width, int height, int channels)
        {
            m_ScaleX = 2.0 / width;
            m_ScaleY = 2.0 / height;
            m_Right = new double[channels, k_Terms];
            m_Coefficients = new double[channels, k_Terms];
        }

        /// <summary>Value of a channel's polynomial at a pixel.</summary>
        public double At(int channel, int column, int row)
        {
            double x = column * m_ScaleX - 1.0, y = row * m_ScaleY - 1.0;
            double[,] c = m_Coefficients;
            return c[channel, 0] + y * (c[channel, 2] + c[channel, 5] * y) + x * (c[channel, 1] + c[channel, 4] * y + c[channel, 3] * x);
        }

        /// <summary>Adds a pixel to those that the next fit is made to.</summary>
        /// <param name="column">Of the pixel.</param>
        /// <param name="row">Of the pixel.</param>
        /// <param name="values">The pixel's value in each channel.</param>
        /// <param name="weight">0 or more.</param>
        public void Add(int column, int row, double[] values, double weight)
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
                double share = weight * m_Basis[i];
                for (int j = i; j < k_Terms; j++)
                    m_Normal[i, j] += share * m_Basis[j];
                for (int channel = 0; channel < values.Length; channel++)
                    m_Right[channel, i] += share * values[channel];
            }
        }

        /// <summary>Fits the polynomials to the pixels added since the last fit.</summary>
        public void Fit()
        {
            for (int k = 0; k < k_Terms; k++)
            {
                m_Normal[k, k] += k_Damping * (1.0 + m_Normal[0, 0]);
                for (int j = 0; j < k; j++)
                    m_Normal[k, j] = m_Normal[j, k];
            }

            Eliminate();
            for (int channel = 0; channel < m_Right.GetLength(0); channel++)
                SubstituteBack(channel);
            Array.Clear(m_Normal, 0, m_Normal.Length);
            Array.Clear(m_Right, 0, m_Right.Length);
        }

        // Without pivots: the matrix is positive definite.
        private void Eliminate()
        {
            for (int k = 0; k < k_Terms; k++)
            {
                for (int i = k + 1; i < k_Terms; i++)
                {
                    double factor = m_Normal[i, k] / m_Normal[k, k];
                    for (int j = k; j < k_Terms; j++)
                        m_Normal[i, j] -= factor * m_Normal[k, j];
                    for (int channel = 0; channel < m_Right.GetLength(0); channel++)
                        m_Right[channel, i] -= factor * m_Right[channel, k];
                }
            }
        }

        private void SubstituteBack(int channel)
        {
            for (int i = k_Terms - 1; i >= 0; i--)
            {
                double sum = m_Right[channel, i];
                for (int j = i + 1; j < k_Terms; j++)
                    sum -= m_Normal[i, j] * m_Coefficients[channel, j];
                m_Coefficients[channel, i] = sum / m_Normal[i, i];
            }
        }
    }
}
