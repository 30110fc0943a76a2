using System;
using System.Collections.Generic;

namespace Alate.Geometry
{
    /// <summary>A closed line sorted into square cells, to tell quickly how far inside a point lies.</summary>
    internal sealed class RimGrid
    {
        /// <summary>Most cells along a side.</summary>
        private const int k_MostCells = 1024;

        private readonly IReadOnlyList<PlanPoint> m_Rim;
        private readonly List<int>[] m_Cells;
        private readonly List<int>[] m_Rows;
        private readonly double m_Cell;
        private readonly int m_Columns;

        /// <param name="rim">Closed; either way round.</param>
        /// <param name="cell">Side of a cell.</param>
        public RimGrid(IReadOnlyList<PlanPoint> rim, double cell)
        {
            m_Rim = rim;
            Left = Low = double.MaxValue;
            Right = High = double.MinValue;
            foreach (PlanPoint point in rim)
            {
                Left = Math.Min(Left, point.x);
                Right = Math.Max(Right, point.x);
                Low = Math.Min(Low, point.z);
                High = Math.Max(High, point.z);
            }

            m_Cell = Math.Max(cell, Math.Max(Right - Left, High - Low) / k_MostCells);
            m_Columns = 1 + (int)((Right - Left) / m_Cell);
            m_Cells = new List<int>[m_Columns * (1 + (int)((High - Low) / m_Cell))];
            m_Rows = new List<int>[m_Cells.Length / m_Columns];
            for (int k = 0; k < rim.Count; k++)
                Sort(k);
        }

        public double Left { get; }

        public double Right { get; }

        public double Low { get; }

        public double High { get; }

        /// <summary>Distance of a point inside from the line, at most a limit; −1 outside.</summary>
        public double Clearance(PlanPoint point, double limit)
        {
            if (!Contains(point))
                return -1.0;
            double least = limit * limit;
            int reach = (int)Math.Ceiling(limit / m_Cell), column = Column(point.x), row = Row(point.z);
            for (int y = Math.Max(0, row - reach); y <= Math.Min(m_Rows.Length - 1, row + reach); y++)
            {
                for (int x = Math.Max(0, column - reach); x <= Math.Min(m_Columns - 1, column + reach); x++)
                {
                    foreach (int k in m_Cells[y * m_Columns + x] ?? s_None)
                        least = Math.Min(least, PlanPoint.DistanceSquared(point, m_Rim[k], m_Rim[(k + 1) % m_Rim.Count]));
                }
            }

            return Math.Sqrt(least);
        }

        /// <summary>Whether a point lies inside (even and odd crossings).</summary>
        public bool Contains(PlanPoint point)
        {
            bool inside = false;
            if (point.x < Left || point.x > Right || point.z < Low || point.z > High)
                return false;
            foreach (int k in m_Rows[Row(point.z)] ?? s_None)
            {
                PlanPoint a = m_Rim[k], b = m_Rim[(k + 1) % m_Rim.Count];
                if (a.z > point.z != b.z > point.z && point.x < a.x + (point.z - a.z) / (b.z - a.z) * (b.x - a.x))
                    inside = !inside;
            }

            return inside;
        }

        private static readonly List<int> s_None = new List<int>();

        private void Sort(int k)
        {
            PlanPoint a = m_Rim[k], b = m_Rim[(k + 1) % m_Rim.Count];
            for (int row = Row(Math.Min(a.z, b.z)); row <= Row(Math.Max(a.z, b.z)); row++)
            {
                (m_Rows[row] ??= new List<int>()).Add(k);
                for (int column = Column(Math.Min(a.x, b.x)); column <= Column(Math.Max(a.x, b.x)); column++)
                    (m_Cells[row * m_Columns + column] ??= new List<int>()).Add(k);
            }
        }

        private int Column(double x) => Math.Min(m_Columns - 1, Math.Max(0, (int)((x - Left) / m_Cell)));

        private int Row(double z) => Math.Min(m_Rows.Length - 1, Math.Max(0, (int)((z - Low) / m_Cell)));
    }
}
