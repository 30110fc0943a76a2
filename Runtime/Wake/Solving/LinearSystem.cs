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
            for (int k = 0; k < Size; k += 2)
            {
                // Two columns at a time: what lies right of both is read and written once.
                if (!BringUp(k))
                    return None(solution);
                bool isLast = k + 1 == Size;
                for (int row = k + 1; row < Size; row++)
                {
                    double factor = m_Matrix[row * Size + k] /= m_Matrix[k * Size + k];
                    if (!isLast)
                        m_Matrix[row * Size + k + 1] -= factor * m_Matrix[k * Size + k + 1];
                }

                if (isLast)
                    break;
                if (!BringUp(k + 1))
                    return None(solution);
                Subtract(k, k + 1, -1);
                for (int row = k + 2; row < Size; row++)
                {
                    m_Matrix[row * Size + k + 1] /= m_Matrix[(k + 1) * Size + k + 1];
                    Subtract(k, row, k + 1);
                }
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

        // The row of the largest entry of a column, of those not yet used up, becomes that of the diagonal.
        private bool BringUp(int column)
        {
            int pivot = Pivot(column);
            if (pivot != column)
                Swap(column, pivot);
            double diagonal = m_Matrix[column * Size + column];
            return Math.Abs(diagonal) > 1e-12 && !double.IsInfinity(diagonal);
        }

        private static bool None(Span<float> solution)
        {
            solution.Clear();
            return false;
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

        // From a row, right of column + 1, the rows of one column or of two, whose factors stand in the row itself.
        private void Subtract(int column, int row, int other)
        {
            int from = column + 2, length = Size - from;
            double factor = m_Matrix[row * Size + column];
            Span<double> line = m_Matrix.AsSpan(row * Size + from, length);
            ReadOnlySpan<double> top = m_Matrix.AsSpan(column * Size + from, length);
            m_Right[row] -= factor * m_Right[column];
            if (other < 0)
            {
                for (int j = 0; j < line.Length; j++)
                    line[j] -= factor * top[j];
                return;
            }

            double second = m_Matrix[row * Size + other];
            ReadOnlySpan<double> next = m_Matrix.AsSpan(other * Size + from, length);
            m_Right[row] -= second * m_Right[other];
            for (int j = 0; j < line.Length; j++)
                line[j] = line[j] - factor * top[j] - second * next[j];
        }
    }
}
