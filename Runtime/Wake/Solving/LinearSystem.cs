using System;

namespace Alate.Wake
{
    /// <summary>Dense system of equations, solved by LU with row pivots in double precision; its memory is taken once.</summary>
    internal sealed class LinearSystem
    {
        private readonly double[] m_Matrix, m_Right;

        public LinearSystem(int size)
        {
            Size = size;
            m_Matrix = new double[size * size];
            m_Right = new double[size];
        }

        public int Size { get; }

        /// <summary>Sets an entry of the matrix.</summary>
        public void Set(int row, int column, double value) => m_Matrix[row * Size + column] = value;

        /// <summary>Sets an entry of the right side.</summary>
        public void SetRight(int row, double value) => m_Right[row] = value;

        /// <summary>Solves the system; matrix and right side are used up.</summary>
        /// <param name="solution">[column] Solution.</param>
        /// <returns>False where the matrix is singular or holds what is no number; the solution is 0 then.</returns>
        public bool Solve(Span<float> solution)
        {
            for (int k = 0; k < Size; k++)
            {
                int pivot = Pivot(k);
                double diagonal = m_Matrix[pivot * Size + k];
                if (!(Math.Abs(diagonal) > 1e-12) || double.IsInfinity(diagonal))
                {
                    solution.Clear();
                    return false;
                }

                if (pivot != k)
                    Swap(k, pivot);
                Span<double> top = m_Matrix.AsSpan(k * Size, Size);
                for (int row = k + 1; row < Size; row++)
                    Subtract(top, row, k, diagonal);
            }

            for (int k = Size - 1; k >= 0; k--)
            {
                double sum = m_Right[k];
                for (int j = k + 1; j < Size; j++)
                    sum -= m_Matrix[k * Size + j] * m_Right[j];
                m_Right[k] = sum / m_Matrix[k * Size + k];
                solution[k] = (float)m_Right[k];
            }

            return true;
        }

        private int Pivot(int column)
        {
            int best = column;
            for (int row = column + 1; row < Size; row++)
            {
                if (Math.Abs(m_Matrix[row * Size + column]) > Math.Abs(m_Matrix[best * Size + column]))
                    best = row;
            }

            return best;
        }

        private void Swap(int a, int b)
        {
            for (int j = 0; j < Size; j++)
                (m_Matrix[a * Size + j], m_Matrix[b * Size + j]) = (m_Matrix[b * Size + j], m_Matrix[a * Size + j]);
            (m_Right[a], m_Right[b]) = (m_Right[b], m_Right[a]);
        }

        private void Subtract(ReadOnlySpan<double> top, int row, int k, double diagonal)
        {
            Span<double> line = m_Matrix.AsSpan(row * Size, Size);
            double factor = line[k] / diagonal;
            if (factor == 0.0)
                return;
            for (int j = k + 1; j < top.Length; j++)
                line[j] -= factor * top[j];
            m_Right[row] -= factor * m_Right[k];
        }
    }
}
