using System;
using System.Collections.Generic;

namespace Alate.Geometry
{
    /// <summary>
    /// Delaunay triangulation of points in a plane, inserted one by one with flips in their neighbourhood (Lawson, 1977); some sides are
    /// then forced in by flips (Sloan, 1993).
    /// </summary>
    internal sealed class DelaunayTriangulation
    {
        private readonly TriangleLinks m_Links;
        private readonly Stack<int> m_Doubtful = new Stack<int>();
        private readonly HashSet<long> m_Forced = new HashSet<long>();
        private int m_Last;

        private DelaunayTriangulation(PlanPoint[] points)
        {
            m_Links = new TriangleLinks(WithCorners(points));
            m_Links.Add(points.Length, points.Length + 1, points.Length + 2, -1, -1, -1);
        }

        /// <summary>The triangles inside a rim that runs counterclockwise through the first points in their order.</summary>
        /// <param name="points">No two of them in one place.</param>
        /// <param name="rimCount">How many of them are the rim.</param>
        /// <exception cref="ArgumentException">The rim crosses itself.</exception>
        public static TriangleLinks Inside(PlanPoint[] points, int rimCount)
        {
            var triangulation = new DelaunayTriangulation(points);
            foreach (int point in SpatialOrder.Of(points))
                triangulation.Insert(point);
            for (int k = 0; k < rimCount; k++)
                triangulation.Force(k, (k + 1) % rimCount);
            return triangulation.Carve(points);
        }

        // A triangle around all points, so wide that it bends no side between them.
        private static PlanPoint[] WithCorners(PlanPoint[] points)
        {
            var bounds = new PlanBounds(points);
            double x = 0.5 * (bounds.left + bounds.right), z = 0.5 * (bounds.low + bounds.high), reach = 50.0 * bounds.Extent;
            var all = new PlanPoint[points.Length + 3];
            points.CopyTo(all, 0);
            all[points.Length] = new PlanPoint(x - 1.1 * reach, z - 0.9 * reach);
            all[points.Length + 1] = new PlanPoint(x + 1.2 * reach, z - reach);
            all[points.Length + 2] = new PlanPoint(x + 0.1 * reach, z + 1.3 * reach);
            return all;
        }

        private void Insert(int point)
        {
            int first = 3 * (Locate(point) / 3);
            int a = m_Links.corners[first], b = m_Links.corners[first + 1], c = m_Links.corners[first + 2];
            int ab = m_Links.twins[first], bc = m_Links.twins[first + 1], ca = m_Links.twins[first + 2];
            m_Links.Replace(first, a, b, point, ab, -1, -1);
            int second = m_Links.Add(b, c, point, bc, -1, first + 1);
            m_Links.Add(c, a, point, ca, first + 2, second + 1);
            m_Doubtful.Push(first);
            m_Doubtful.Push(second);
            m_Doubtful.Push(second + 3);
            Legalise(point);
            m_Last = first;
        }

        // Walks towards the point, across any side that has it on the other hand.
        private int Locate(int point)
        {
            int triangle = m_Last / 3;
            for (int steps = 0; steps <= m_Links.SideCount; steps++)
            {
                int crossed = -1;
                for (int k = 0; k < 3 && crossed < 0; k++)
                {
                    int side = 3 * triangle + (k + steps) % 3;
                    if (m_Links.twins[side] >= 0 && m_Links.Area(m_Links.corners[side], m_Links.End(side), point) < 0.0)
                        crossed = side;
                }

                if (crossed < 0)
                    return 3 * triangle;
                triangle = m_Links.twins[crossed] / 3;
            }

            throw new ArgumentException("The points to triangulate are not finite.");
        }

        private void Legalise(int point)
        {
            while (m_Doubtful.Count > 0)
            {
                int side = m_Doubtful.Pop();
                if (!m_Links.IsAgainstDelaunay(side) || !m_Links.CanFlip(side))
                    continue;
                int diagonal = m_Links.Flip(side), twin = m_Links.twins[diagonal];
                PushOpposite(diagonal, point);
                PushOpposite(twin, point);
            }
        }

        // Of a triangle with the new point, only the side across from that point may have become wrong.
        private void PushOpposite(int side, int point)
        {
            int opposite = m_Links.corners[side] == point ? TriangleLinks.Next(side) : TriangleLinks.Previous(side);
            m_Doubtful.Push(opposite);
        }

        private void Force(int from, int to)
        {
            m_Forced.Add(Key(from, to));
            if (m_Links.Find(from, to) >= 0 || m_Links.Find(to, from) >= 0)
                return;
            List<(int A, int B)> made = FlipCrossings(from, to, Crossings(from, to));
            // The new sides but the forced one may be flipped right again.
            for (bool changed = true; changed;)
            {
                changed = false;
                for (int k = 0; k < made.Count; k++)
                {
                    int side = m_Links.Find(made[k].A, made[k].B);
                    if (m_Forced.Contains(Key(made[k].A, made[k].B)) || !m_Links.IsAgainstDelaunay(side) || !m_Links.CanFlip(side))
                        continue;
                    side = m_Links.Flip(side);
                    made[k] = (m_Links.corners[side], m_Links.End(side));
                    changed = true;
                }
            }
        }

        // The ends of the sides that the line between two points crosses, in order.
        private Queue<(int A, int B)> Crossings(int from, int to)
        {
            var crossed = new Queue<(int A, int B)>();
            int first = m_Links.firstSides[from], side = first;
            while (!IsBetween(side, from, to))
            {
                side = m_Links.twins[TriangleLinks.Previous(side)];
                if (side < 0 || side == first)
                    throw new ArgumentException("The rim of the mesh passes through a point.");
            }

            int across = TriangleLinks.Next(side);
            while (true)
            {
                crossed.Enqueue((m_Links.corners[across], m_Links.End(across)));
                int twin = m_Links.twins[across], apex = m_Links.Apex(twin);
                if (apex == to)
                    return crossed;
                // On which hand of the line the next corner lies tells which of the two further sides is crossed.
                across = m_Links.Area(from, to, apex) > 0.0 == m_Links.Area(from, to, m_Links.corners[twin]) > 0.0
                    ? TriangleLinks.Next(twin)
                    : TriangleLinks.Previous(twin);
            }
        }

        // No point lies within a triangle: one between two of its sides is beyond the third.
        private bool IsBetween(int side, int from, int to) =>
            m_Links.Area(from, m_Links.End(side), to) >= 0.0 && m_Links.Area(from, to, m_Links.Apex(side)) >= 0.0;

        private List<(int A, int B)> FlipCrossings(int from, int to, Queue<(int A, int B)> crossed)
        {
            var made = new List<(int A, int B)>();
            for (int patience = 100 + crossed.Count * crossed.Count * 4; crossed.Count > 0; patience--)
            {
                (int a, int b) = crossed.Dequeue();
                int side = m_Links.Find(a, b);
                if (patience == 0 || m_Forced.Contains(Key(a, b)))
                    throw new ArgumentException("The rim of the mesh crosses itself.");
                if (!m_Links.CanFlip(side))
                {
                    crossed.Enqueue((a, b));
                    continue;
                }

                int diagonal = m_Links.Flip(side), c = m_Links.corners[diagonal], d = m_Links.End(diagonal);
                bool ends = c == from || c == to || d == from || d == to;
                if (!ends && m_Links.Area(from, to, c) > 0.0 != m_Links.Area(from, to, d) > 0.0)
                    crossed.Enqueue((c, d));
                else
                    made.Add((c, d));
            }

            return made;
        }

        // Keeps what lies within the rim: all that cannot be reached from the outermost triangles without crossing it.
        private TriangleLinks Carve(PlanPoint[] points)
        {
            bool[] outside = new bool[m_Links.SideCount / 3];
            var open = new Stack<int>();
            open.Push(m_Links.firstSides[points.Length] / 3);
            outside[open.Peek()] = true;
            while (open.Count > 0)
            {
                int triangle = open.Pop();
                for (int side = 3 * triangle; side < 3 * triangle + 3; side++)
                {
                    int next = m_Links.twins[side] / 3;
                    if (m_Links.twins[side] < 0 || outside[next] || m_Forced.Contains(Key(m_Links.corners[side], m_Links.End(side))))
                        continue;
                    outside[next] = true;
                    open.Push(next);
                }
            }

            return Kept(points, outside);
        }

        private TriangleLinks Kept(PlanPoint[] points, bool[] outside)
        {
            var kept = new TriangleLinks(points);
            int[] renumbered = new int[outside.Length];
            for (int t = 0; t < outside.Length; t++)
            {
                if (outside[t])
                    continue;
                renumbered[t] = kept.SideCount / 3;
                kept.Add(m_Links.corners[3 * t], m_Links.corners[3 * t + 1], m_Links.corners[3 * t + 2], -1, -1, -1);
            }

            for (int side = 0; side < m_Links.SideCount; side++)
            {
                int twin = m_Links.twins[side];
                if (!outside[side / 3] && twin >= 0 && !outside[twin / 3])
                    kept.twins[3 * renumbered[side / 3] + side % 3] = 3 * renumbered[twin / 3] + twin % 3;
            }

            return kept;
        }

        private static long Key(int a, int b) => ((long)Math.Min(a, b) << 32) | (uint)Math.Max(a, b);
    }
}
