using System;
using Alate.Geometry;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>Finds a point's cell of the skeleton and its coordinates there, in the plan of the wing frame.</summary>
    internal sealed class CellMap
    {
        private readonly BilinearCell[] m_Cells;

        /// <param name="rest">The skeleton.</param>
        public CellMap(RestSkeleton rest)
        {
            m_Cells = new BilinearCell[rest.CellCount];
            for (int cell = 0; cell < m_Cells.Length; cell++)
            {
                int joint = rest.FirstJoint(cell), next = joint + rest.jointsPerChain;
                m_Cells[cell] = new BilinearCell(
                    Plan(rest.joints[joint]), Plan(rest.joints[joint + 1]), Plan(rest.joints[next]), Plan(rest.joints[next + 1]));
            }
        }

        /// <summary>Finds the closest cell of a point, of equally close ones the first.</summary>
        public CellPoint Locate(float3 point)
        {
            PlanPoint p = Plan(point);
            CellPoint found = default;
            double least = double.PositiveInfinity;
            for (int cell = 0; cell < m_Cells.Length && least > 0.0; cell++)
            {
                if (m_Cells[cell].LeastDistanceSquared(p) >= least)
                    continue;
                double distance = m_Cells[cell].Locate(p, out double u, out double v);
                if (distance >= least)
                    continue;
                least = distance;
                found = Point(cell, u, v, distance);
            }

            return found;
        }

        /// <summary>Finds the coordinates of a point in a given cell, clamped to it.</summary>
        public CellPoint LocateIn(int cell, float3 point)
        {
            double distance = m_Cells[cell].Locate(Plan(point), out double u, out double v);
            return Point(cell, u, v, distance);
        }

        /// <summary>Locates each point.</summary>
        public CellPoint[] Locate(float3[] points)
        {
            var located = new CellPoint[points.Length];
            for (int k = 0; k < points.Length; k++)
                located[k] = Locate(points[k]);
            return located;
        }

        private static PlanPoint Plan(float3 point) => new PlanPoint(point.x, point.z);

        private static CellPoint Point(int cell, double u, double v, double distanceSquared) =>
            new CellPoint { cell = cell, u = (float)u, v = (float)v, distance = (float)Math.Sqrt(distanceSquared) };
    }
}
