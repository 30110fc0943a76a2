using System;
using System.Collections.Generic;

namespace Alate.Catalogue
{
    /// <summary>
    /// Square cells over strokes, each divided into smaller ones; each lists the strokes that may be nearest to a place in it, in their
    /// order. Cells are made where they are first asked for; threads may share them, as all make the same of a cell.
    /// </summary>
    internal sealed class StrokeGrid
    {
        /// <summary>Cells along the longer side, and parts along a side of each.</summary>
        private const int k_Cells = 64, k_Parts = 8;

        /// <summary>Reach of the cells beyond the strokes, as a share of the longer side.</summary>
        private const double k_Margin = 0.1;

        /// <summary>Up to so many strokes a cell is not divided.</summary>
        private const int k_Few = 3;

        private readonly Cell m_All;
        private readonly Cell[] m_Cells;
        private readonly double m_Left, m_Low, m_Size;
        private readonly int m_Columns, m_Rows;

        public StrokeGrid(Stroke[] strokes)
        {
            m_All = new Cell(strokes, double.MinValue, 0);
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
            m_Cells = new Cell[m_Columns * m_Rows];
        }

        /// <summary>
        /// Strokes that may be nearest to a place; none where all are known to be beyond the reach; all of them for a place outside of the
        /// cells.
        /// </summary>
        public Stroke[] Around(double x, double z, double reach)
        {
            double across = (x - m_Left) / m_Size, up = (z - m_Low) / m_Size;
            if (!(across >= 0 && across < m_Columns && up >= 0 && up < m_Rows))
                return m_All.Strokes;

            int column = (int)across, row = (int)up;
            Cell cell = m_Cells[row * m_Columns + column] ??= Find(m_All, column, row, m_Size, k_Parts * k_Parts);
            if (cell.Parts.Length == 0 || cell.Clearance >= reach)
                return cell.Within(reach);
            int partColumn = (int)((across - column) * k_Parts), partRow = (int)((up - row) * k_Parts);
            Cell part = cell.Parts[partRow * k_Parts + partColumn] ??=
                Find(cell, column * k_Parts + partColumn, row * k_Parts + partRow, m_Size / k_Parts, 0);
            return part.Within(reach);
        }

        // From any place of a cell the nearest stroke is at most a cell's diagonal farther from the middle than the one nearest to that.
        private Cell Find(Cell among, int column, int row, double size, int parts)
        {
            double x = m_Left + (column + 0.5) * size, z = m_Low + (row + 0.5) * size, nearest = double.MaxValue;
            double[] distances = new double[among.Strokes.Length];
            for (int k = 0; k < distances.Length; k++)
            {
                distances[k] = Math.Sqrt(among.Strokes[k].DistanceSquared(x, z, out _));
                nearest = Math.Min(nearest, distances[k]);
            }

            var found = new List<Stroke>();
            for (int k = 0; k < distances.Length; k++)
            {
                if (distances[k] <= nearest + 1.5 * size)
                    found.Add(among.Strokes[k]);
            }

            return new Cell(found.ToArray(), nearest - 0.75 * size, found.Count > k_Few ? parts : 0);
        }

        private sealed class Cell
        {
            public readonly Stroke[] Strokes;

            /// <summary>Less than the distance of the nearest stroke from any place in the cell.</summary>
            public readonly double Clearance;

            /// <summary>Smaller cells within it, or none.</summary>
            public readonly Cell[] Parts;

            public Cell(Stroke[] strokes, double clearance, int parts)
            {
                Strokes = strokes;
                Clearance = clearance;
                Parts = parts > 0 ? new Cell[parts] : Array.Empty<Cell>();
            }

            public Stroke[] Within(double reach) => Clearance < reach ? Strokes : Array.Empty<Stroke>();
        }
    }
}
