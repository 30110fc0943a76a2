using System;
using System.Collections.Generic;
using System.Linq;

namespace Alate.Geometry
{
    /// <summary>The sides of a polygon sorted into square cells, to tell quickly whether and how far inside a point lies.</summary>
    internal sealed class PolygonGrid
    {
        /// <summary>Cells along the longer side of the bounds, and their most.</summary>
        private const int k_Cells = 256, k_MostCells = 1024;

        private static readonly List<int> s_None = new List<int>();

        public readonly PlanBounds bounds;

        private readonly PlanPoint[] m_Corners;
        private readonly double m_Cell;
        private readonly int m_Columns;
        private readonly List<int>[] m_Rows;
        private List<int>[] m_Cells;

        /// <param name="corners">Of the polygon, either way round.</param>
        /// <param name="cell">Side of a cell; by default a small share of the polygon's extent.</param>
        public PolygonGrid(IReadOnlyList<PlanPoint> corners, double cell = 0.0)
        {
            m_Corners = corners.ToArray();
            bounds = new PlanBounds(corners);
            m_Cell = cell > 0.0 ? Math.Max(cell, bounds.Extent / k_MostCells) : Math.Max(bounds.Extent / k_Cells, double.Epsilon);
            m_Columns = 1 + (int)((bounds.right - bounds.left) / m_Cell);
            m_Rows = new List<int>[1 + (int)((bounds.high - bounds.low) / m_Cell)];
            for (int side = 0; side < m_Corners.Length; side++)
            {
                for (int row = Row(Math.Min(m_Corners[side].z, End(side).z)); row <= Row(Math.Max(m_Corners[side].z, End(side).z)); row++)
                    (m_Rows[row] ??= new List<int>()).Add(side);
            }
        }

        /// <summary>Distance of a point inside from the sides, at most a limit; −1 outside.</summary>
        public double Clearance(PlanPoint point, double limit)
        {
            if (!Contains(point))
                return -1.0;
            m_Cells ??= SortIntoCells();
            double least = limit * limit;
            int reach = (int)Math.Ceiling(limit / m_Cell), column = Column(point.x), row = Row(point.z);
            for (int y = Math.Max(0, row - reach); y <= Math.Min(m_Rows.Length - 1, row + reach); y++)
            {
                for (int x = Math.Max(0, column - reach); x <= Math.Min(m_Columns - 1, column + reach); x++)
                {
                    foreach (int side in m_Cells[y * m_Columns + x] ?? s_None)
                        least = Math.Min(least, PlanPoint.DistanceSquared(point, m_Corners[side], End(side)));
                }
            }

            return Math.Sqrt(least);
        }

        /// <summary>Returns true where p lies inside.</summary>
        public bool Contains(PlanPoint p)
        {
            bool inside = false;
            foreach (int side in SidesAt(p.z))
                inside ^= Crosses(side, p.z, out double x) && p.x < x;
            return inside;
        }

        /// <summary>Finds the places where the polygon crosses the line of this z, from left to right.</summary>
        public void FindCrossings(double z, List<double> found)
        {
            found.Clear();
            foreach (int side in SidesAt(z))
            {
                if (Crosses(side, z, out double x))
                    found.Add(x);
            }

            found.Sort();
        }

        private bool Crosses(int side, double z, out double x)
        {
            PlanPoint from = m_Corners[side], to = End(side);
            bool crosses = from.z > z != to.z > z;
            x = crosses ? from.x + (to.x - from.x) * (z - from.z) / (to.z - from.z) : 0.0;
            return crosses;
        }

        private List<int>[] SortIntoCells()
        {
            var cells = new List<int>[m_Columns * m_Rows.Length];
            for (int row = 0; row < m_Rows.Length; row++)
            {
                foreach (int side in m_Rows[row] ?? s_None)
                {
                    double from = m_Corners[side].x, to = End(side).x;
                    for (int column = Column(Math.Min(from, to)); column <= Column(Math.Max(from, to)); column++)
                        (cells[row * m_Columns + column] ??= new List<int>()).Add(side);
                }
            }

            return cells;
        }

        private PlanPoint End(int side) => m_Corners[side + 1 < m_Corners.Length ? side + 1 : 0];

        private List<int> SidesAt(double z) => z < bounds.low || z > bounds.high ? s_None : m_Rows[Row(z)] ?? s_None;

        private int Column(double x) => Math.Min(m_Columns - 1, Math.Max(0, (int)((x - bounds.left) / m_Cell)));

        private int Row(double z) => Math.Min(m_Rows.Length - 1, Math.Max(0, (int)((z - bounds.low) / m_Cell)));
    }
}
