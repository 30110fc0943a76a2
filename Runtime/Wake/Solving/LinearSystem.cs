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
                Subtract(k, k + 1);
                for (int row = k + 2; row < Size; row++)
                {
                    m_Matrix[row * Size + k + 1] /= m_Matrix[(k + 1) * Size + k + 1];
                    SubtractTwo(k, row);
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

        // Takes a multiple of the row of a column from another, right of the column after it. The factor stands in the other row.
        private void Subtract(int column, int row)
        {
            double factor = m_Matrix[row * Size + column];
            Span<double> line = RightOf(column + 1, row);
            ReadOnlySpan<double> top = RightOf(column + 1, column);
            for (int j = 0; j < line.Length; j++)
                line[j] -= factor * top[j];
            m_Right[row] -= factor * m_Right[column];
        }

        // The same with the rows of a column and of the one after it.
        private void SubtractTwo(int column, int row)
        {
            double factor = m_Matrix[row * Size + column], next = m_Matrix[row * Size + column + 1];
            Span<double> line = RightOf(column + 1, row);
            ReadOnlySpan<double> top = RightOf(column + 1, column), below = RightOf(column + 1, column + 1);
            for (int j = 0; j < line.Length; j++)
                line[j] = line[j] - factor * top[j] - next * below[j];
            m_Right[row] = m_Right[row] - factor * m_Right[column] - next * m_Right[column + 1];
        }

        private Span<double> RightOf(int column, int row) => m_Matrix.AsSpan(row * Size + column + 1, Size - column - 1);
    }
}
