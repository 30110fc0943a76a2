using System;
using System.Collections.Generic;

namespace Alate.Catalogue
{
    /// <summary>
    /// Square cells over strokes; each lists the strokes that may be nearest to a place in it, in their order. Threads may share it: all
    /// find the same of a cell, and one that sees the strokes before their clearance looks at strokes that are too far.
    /// </summary>
    internal sealed class StrokeGrid
    {
        /// <summary>Cells along the longer side.</summary>
        private const int k_Cells = 64;

        /// <summary>Reach of the cells beyond the strokes, as a share of the longer side.</summary>
        private const double k_Margin = 0.1;

        private readonly Stroke[] m_Strokes;
        private readonly Stroke[][] m_Found;

        /// <summary>[cell] Less than the distance of the nearest stroke from any place in the cell.</summary>
        private readonly double[] m_Clearances;

        private readonly double m_Left, m_Low, m_Size;
        private readonly int m_Columns, m_Rows;

        public StrokeGrid(Stroke[] strokes)
        {
            m_Strokes = strokes;
            double left = double.MaxValue, right = double.MinValue, low = double.MaxValue, high = double.MinValue;
            foreach (Stroke stroke in strokes)
            {
                left = Math.Min(left, Math.Min(stroke.x, stroke.x + stroke.dx));
                right = Math.Max(right, Math.Max(stroke.x, stroke.x + stroke.dx));
                low = Math.Min(low, Math.Min(stroke.z, stroke.z + stroke.dz));
                high = Math.Max(high, Math.Max(stroke.z, stroke.z + stroke.dz));
            }

            double margin = k_Margin * Math.Max(right - left, high - low);
            m_Left = left - margin;
            m_Low = low - margin;
            m_Size = Math.Max((Math.Max(right - left, high - low) + 2 * margin) / k_Cells, 1e-9);
            m_Columns = (int)Math.Ceiling((right + margin - m_Left) / m_Size);
            m_Rows = (int)Math.Ceiling((high + margin - m_Low) / m_Size);
            m_Found = new Stroke[m_Columns * m_Rows][];
            m_Clearances = new double[m_Found.Length];
        }

        /// <summary>
        /// Strokes that may be nearest to a place; none where all are known to be beyond the reach; all of them for a place outside of the
        /// cells.
        /// </summary>
        public Stroke[] Around(double x, double z, double reach)
        {
            double column = Math.Floor((x - m_Left) / m_Size), row = Math.Floor((z - m_Low) / m_Size);
            if (!(column >= 0 && column < m_Columns && row >= 0 && row < m_Rows))
                return m_Strokes;

            int cell = (int)row * m_Columns + (int)column;
            Stroke[] found = m_Found[cell] ??= Find(m_Left + (column + 0.5) * m_Size, m_Low + (row + 0.5) * m_Size, out m_Clearances[cell]);
            return m_Clearances[cell] < reach ? found : Array.Empty<Stroke>();
        }

        // From any place of a cell the nearest stroke is at most a cell's diagonal farther from the middle than the one nearest to that.
        private Stroke[] Find(double middleX, double middleZ, out double clearance)
        {
            double[] distances = new double[m_Strokes.Length];
            double nearest = double.MaxValue;
            for (int k = 0; k < distances.Length; k++)
            {
                distances[k] = Math.Sqrt(m_Strokes[k].DistanceSquared(middleX, middleZ, out _));
                nearest = Math.Min(nearest, distances[k]);
            }

            clearance = nearest - 0.75 * m_Size;
            var found = new List<Stroke>();
            for (int k = 0; k < distances.Length; k++)
            {
                if (distances[k] <= nearest + 1.5 * m_Size)
                    found.Add(m_Strokes[k]);
            }

            return found.ToArray();
        }
    }
}
