using System;
using System.Collections.Generic;

namespace Alate.Geometry
{
    /// <summary>The edges of a polygon sorted into rows across z, to tell quickly whether a point lies inside.</summary>
    internal sealed class PolygonRows
    {
        private const int k_Rows = 256;

        private static readonly List<int> s_None = new List<int>();

        private readonly IReadOnlyList<PlanPoint> m_Corners;
        private readonly List<int>[] m_Edges = new List<int>[k_Rows];
        private readonly double m_Low;
        private readonly double m_PerRow;

        public PolygonRows(IReadOnlyList<PlanPoint> corners)
        {
            m_Corners = corners;
            double high = double.MinValue;
            m_Low = double.MaxValue;
            foreach (PlanPoint corner in corners)
            {
                m_Low = Math.Min(m_Low, corner.z);
                high = Math.Max(high, corner.z);
            }

            m_PerRow = Math.Max((high - m_Low) / k_Rows, double.Epsilon);
            for (int k = 0; k < corners.Count; k++)
            {
                double from = corners[k].z, to = corners[(k + 1) % corners.Count].z;
                for (int row = Row(Math.Min(from, to)); row <= Row(Math.Max(from, to)); row++)
                    (m_Edges[row] ??= new List<int>()).Add(k);
            }
        }

        /// <summary>Whether p lies inside.</summary>
        public bool Contains(PlanPoint p)
        {
            bool inside = false;
            List<int> edges = EdgesAt(p.z);
            for (int k = 0; k < edges.Count; k++)
                inside ^= Crosses(edges[k], p.z, out double x) && p.x < x;
            return inside;
        }

        /// <summary>Where the polygon crosses the line of this z, from left to right.</summary>
        public void FindCrossings(double z, List<double> found)
        {
            found.Clear();
            foreach (int edge in EdgesAt(z))
            {
                if (Crosses(edge, z, out double x))
                    found.Add(x);
            }

            found.Sort();
        }

        private bool Crosses(int edge, double z, out double x)
        {
            PlanPoint from = m_Corners[edge], to = m_Corners[edge + 1 < m_Corners.Count ? edge + 1 : 0];
            bool crosses = from.z > z != to.z > z;
            x = crosses ? from.x + (to.x - from.x) * (z - from.z) / (to.z - from.z) : 0.0;
            return crosses;
        }

        private List<int> EdgesAt(double z) =>
            z < m_Low || z > m_Low + k_Rows * m_PerRow ? s_None : m_Edges[Row(z)] ?? s_None;

        private int Row(double z) => Math.Min(Math.Max((int)((z - m_Low) / m_PerRow), 0), k_Rows - 1);
    }
}
