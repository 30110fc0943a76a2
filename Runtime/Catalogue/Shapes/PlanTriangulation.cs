using System;
using System.Collections.Generic;
using Alate.Geometry;

namespace Alate.Catalogue
{
    /// <summary>
    /// A triangulation of a polygon in plan that takes further points inside it and stays the constrained Delaunay triangulation of them all (Lawson 1977):
    /// among all triangulations that keep the polygon's edges it is the one whose smallest angles are largest. Triangles face up.
    /// </summary>
    internal sealed class PlanTriangulation
    {
        private const int k_Border = -1;

        private readonly List<PlanPoint> m_Points;
        private readonly List<int> m_Corners = new List<int>();

        /// <summary>[3 t + k] The triangle across the edge from corner k to corner k + 1 of triangle t.</summary>
        private readonly List<int> m_Neighbours = new List<int>();

        private readonly Stack<int> m_Suspects = new Stack<int>();
        private int m_Last;

        /// <param name="polygon">Corners of a simple polygon, clockwise when seen with x to the right and z up.</param>
        public PlanTriangulation(IReadOnlyList<PlanPoint> polygon)
        {
            m_Points = new List<PlanPoint>(polygon);
            BorderCount = polygon.Count;
            m_Corners.AddRange(EarClipping.Triangles(polygon));
            Connect();
            MakeDelaunay();
        }

        /// <summary>Points of the polygon; they come first.</summary>
        public int BorderCount { get; }

        /// <summary>The polygon's corners, then the points that were added.</summary>
        public IReadOnlyList<PlanPoint> Points => m_Points;

        /// <summary>Three point indices a triangle.</summary>
        public IReadOnlyList<int> Corners => m_Corners;

        /// <summary>Adds a point that lies inside the polygon.</summary>
        public void Insert(PlanPoint point)
        {
            var triangle = Find(point);
            var added = m_Points.Count;
            m_Points.Add(point);
            Split(triangle, added);
            MakeDelaunay();
        }

        /// <summary>
        /// Moves every point inside the polygon to the middle of its neighbours, as far as no triangle turns over, and mends the triangulation.
        /// </summary>
        public void Relax()
        {
            var sums = new PlanPoint[m_Points.Count];
            var weights = new double[m_Points.Count];
            for (var corner = 0; corner < m_Corners.Count; corner++)
            {
                var here = m_Corners[corner];
                var next = m_Corners[Next(corner)];
                sums[here] += m_Points[next];
                sums[next] += m_Points[here];
                weights[here]++;
                weights[next]++;
            }

            var fans = Fans();
            for (var point = BorderCount; point < m_Points.Count; point++)
            {
                var from = m_Points[point];
                m_Points[point] = sums[point] * (1 / weights[point]);
                if (fans[point].Exists(triangle => DoubledArea(triangle) <= 0))
                {
                    m_Points[point] = from;
                }
            }

            for (var corner = 0; corner < m_Corners.Count; corner++)
            {
                m_Suspects.Push(corner);
            }

            MakeDelaunay();
        }

        private List<int>[] Fans()
        {
            var fans = new List<int>[m_Points.Count];
            for (var corner = 0; corner < m_Corners.Count; corner++)
            {
                (fans[m_Corners[corner]] ??= new List<int>()).Add(corner / 3);
            }

            return fans;
        }

        private double DoubledArea(int triangle) =>
            DoubledArea(m_Points[m_Corners[3 * triangle]], m_Points[m_Corners[3 * triangle + 1]], m_Points[m_Corners[3 * triangle + 2]]);

        /// <summary>Positive where a, b, c run clockwise, so that their triangle faces up.</summary>
        private static double DoubledArea(PlanPoint a, PlanPoint b, PlanPoint c) => PlanPoint.Cross(c - a, b - a);

        private void Connect()
        {
            var open = new Dictionary<(int, int), int>();
            for (var corner = 0; corner < m_Corners.Count; corner++)
            {
                var from = m_Corners[corner];
                var to = m_Corners[Next(corner)];
                m_Neighbours.Add(k_Border);
                if (open.TryGetValue((to, from), out var other))
                {
                    m_Neighbours[corner] = other / 3;
                    m_Neighbours[other] = corner / 3;
                }

                open[(from, to)] = corner;
                m_Suspects.Push(corner);
            }
        }

        private int Find(PlanPoint point)
        {
            var triangle = m_Last;
            for (var step = 0; step <= m_Corners.Count; step++)
            {
                var across = Towards(triangle, point);
                if (across < 0)
                {
                    m_Last = triangle;
                    return triangle;
                }

                if (m_Neighbours[across] == k_Border)
                {
                    break;
                }

                triangle = m_Neighbours[across];
            }

            return m_Last = FindAmongAll(point);
        }

        /// <summary>The edge with the point most behind it, or −1 when the point lies in the triangle.</summary>
        private int Towards(int triangle, PlanPoint point)
        {
            var worst = -1;
            var least = 0.0;
            for (var corner = 3 * triangle; corner < 3 * triangle + 3; corner++)
            {
                var area = DoubledArea(m_Points[m_Corners[corner]], m_Points[m_Corners[Next(corner)]], point);
                if (area < least)
                {
                    least = area;
                    worst = corner;
                }
            }

            return worst;
        }

        /// <summary>A concave rim can stop the walk on its far side.</summary>
        private int FindAmongAll(PlanPoint point)
        {
            for (var triangle = 0; 3 * triangle < m_Corners.Count; triangle++)
            {
                if (Towards(triangle, point) < 0)
                {
                    return triangle;
                }
            }

            throw new ArgumentException($"The point ({point.x}, {point.z}) lies outside the polygon.");
        }

        private void Split(int triangle, int point)
        {
            var first = 3 * triangle;
            var a = m_Corners[first];
            var b = m_Corners[first + 1];
            var c = m_Corners[first + 2];
            var acrossBc = m_Neighbours[first + 1];
            var acrossCa = m_Neighbours[first + 2];
            var second = m_Corners.Count / 3;
            var third = second + 1;
            m_Corners[first + 2] = point;
            m_Corners.AddRange(new[] { b, c, point, c, a, point });
            m_Neighbours[first + 1] = second;
            m_Neighbours[first + 2] = third;
            m_Neighbours.AddRange(new[] { acrossBc, third, triangle, acrossCa, triangle, second });
            Redirect(acrossBc, triangle, second);
            Redirect(acrossCa, triangle, third);
            m_Suspects.Push(first);
            m_Suspects.Push(3 * second);
            m_Suspects.Push(3 * third);
        }

        private void Redirect(int triangle, int from, int to)
        {
            if (triangle == k_Border)
            {
                return;
            }

            m_Neighbours[m_Neighbours.IndexOf(from, 3 * triangle, 3)] = to;
        }

        private void MakeDelaunay()
        {
            while (m_Suspects.Count > 0)
            {
                var edge = m_Suspects.Pop();
                var other = m_Neighbours[edge];
                if (other == k_Border)
                {
                    continue;
                }

                var back = m_Neighbours.IndexOf(edge / 3, 3 * other, 3);
                if (IsBetterFlipped(edge, back))
                {
                    Flip(edge, back);
                }
            }
        }

        private bool IsBetterFlipped(int edge, int back)
        {
            var a = m_Points[m_Corners[edge]];
            var b = m_Points[m_Corners[Next(edge)]];
            var c = m_Points[m_Corners[Next(Next(edge))]];
            var d = m_Points[m_Corners[Next(Next(back))]];
            if (DoubledArea(c, a, d) <= 0 || DoubledArea(d, b, c) <= 0)
            {
                return false;
            }

            const double k_Tie = 1e-12;
            return Cotangent(a, c, b) + Cotangent(b, d, a) < -k_Tie;
        }

        /// <summary>Cotangent of the angle at the apex; the edge is Delaunay where the two opposite cotangents do not add up to less than zero.</summary>
        private static double Cotangent(PlanPoint a, PlanPoint apex, PlanPoint b) =>
            PlanPoint.Dot(a - apex, b - apex) / Math.Abs(PlanPoint.Cross(a - apex, b - apex));

        /// <summary>Turns the diagonal of the two triangles at an edge.</summary>
        private void Flip(int edge, int back)
        {
            var one = edge / 3;
            var other = back / 3;
            var a = m_Corners[edge];
            var b = m_Corners[Next(edge)];
            var c = m_Corners[Next(Next(edge))];
            var d = m_Corners[Next(Next(back))];
            var bc = m_Neighbours[Next(edge)];
            var ca = m_Neighbours[Next(Next(edge))];
            var ad = m_Neighbours[Next(back)];
            var db = m_Neighbours[Next(Next(back))];
            Set(one, c, a, d, ca, ad, other);
            Set(other, d, b, c, db, bc, one);
            Redirect(ad, other, one);
            Redirect(bc, one, other);
            for (var k = 0; k < 2; k++)
            {
                m_Suspects.Push(3 * one + k);
                m_Suspects.Push(3 * other + k);
            }
        }

        private void Set(int triangle, int a, int b, int c, int acrossAb, int acrossBc, int acrossCa)
        {
            m_Corners[3 * triangle] = a;
            m_Corners[3 * triangle + 1] = b;
            m_Corners[3 * triangle + 2] = c;
            m_Neighbours[3 * triangle] = acrossAb;
            m_Neighbours[3 * triangle + 1] = acrossBc;
            m_Neighbours[3 * triangle + 2] = acrossCa;
        }

        private static int Next(int corner) => corner % 3 == 2 ? corner - 2 : corner + 1;
    }
}
