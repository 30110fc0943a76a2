using System;
using System.Collections.Generic;

namespace Alate.Geometry
{
    /// <summary>
    /// Triangles in a plane, counterclockwise, and how they join. Side s of triangle t is the number 3 t + s; it begins at
    /// <see cref="corners"/>[3 t + s] and its other face is <see cref="twins"/>[3 t + s], or −1 on the rim.
    /// </summary>
    internal sealed class TriangleLinks
    {
        /// <summary>[side] The point at which the side begins.</summary>
        public readonly List<int> corners = new List<int>();

        /// <summary>[side] Twin of the side in the triangle across it; −1 for none.</summary>
        public readonly List<int> twins = new List<int>();

        /// <summary>[point] Any side that begins at the point; −1 when none does.</summary>
        public readonly int[] firstSides;

        public readonly PlanPoint[] points;

        public TriangleLinks(PlanPoint[] points)
        {
            this.points = points;
            firstSides = new int[points.Length];
            Array.Fill(firstSides, -1);
        }

        public int SideCount => corners.Count;

        public static int Next(int side) => side % 3 == 2 ? side - 2 : side + 1;

        public static int Previous(int side) => side % 3 == 0 ? side + 2 : side - 1;

        /// <summary>Twice the signed area of the triangle of three points.</summary>
        public double Area(int a, int b, int c) => PlanPoint.Cross(points[b] - points[a], points[c] - points[a]);

        /// <summary>The point at which a side ends.</summary>
        public int End(int side) => corners[Next(side)];

        /// <summary>The corner of the side's triangle that is not on the side.</summary>
        public int Apex(int side) => corners[Previous(side)];

        /// <summary>Adds a triangle and returns its first side.</summary>
        public int Add(int a, int b, int c, int twinAb, int twinBc, int twinCa)
        {
            int side = corners.Count;
            for (int k = 0; k < 3; k++)
            {
                corners.Add(-1);
                twins.Add(-1);
            }

            Replace(side, a, b, c, twinAb, twinBc, twinCa);
            return side;
        }

        /// <summary>Replaces a triangle's corners and neighbours.</summary>
        public void Replace(int firstSide, int a, int b, int c, int twinAb, int twinBc, int twinCa)
        {
            corners[firstSide] = a;
            corners[firstSide + 1] = b;
            corners[firstSide + 2] = c;
            Join(firstSide, twinAb);
            Join(firstSide + 1, twinBc);
            Join(firstSide + 2, twinCa);
            firstSides[a] = firstSide;
            firstSides[b] = firstSide + 1;
            firstSides[c] = firstSide + 2;
        }

        /// <summary>
        /// Returns true where the two triangles on a side form a convex quadrilateral, so that its other diagonal lies inside.
        /// </summary>
        public bool CanFlip(int side)
        {
            int twin = twins[side];
            if (twin < 0)
                return false;
            int near = Apex(side), far = Apex(twin);
            return Area(near, corners[side], far) > 0.0 && Area(near, far, End(side)) > 0.0;
        }

        /// <summary>
        /// Returns true where the circle through a side's triangle holds the corner across the side (Delaunay's condition is broken).
        /// </summary>
        public bool IsAgainstDelaunay(int side)
        {
            int twin = twins[side];
            if (twin < 0)
                return false;
            PlanPoint d = points[Apex(twin)];
            PlanPoint a = points[corners[side]] - d, b = points[End(side)] - d, c = points[Apex(side)] - d;
            double aa = a.LengthSquared, bb = b.LengthSquared, cc = c.LengthSquared;
            double inside = aa * PlanPoint.Cross(b, c) - bb * PlanPoint.Cross(a, c) + cc * PlanPoint.Cross(a, b);
            return inside > 1e-10 * (aa + bb) * (bb + cc);
        }

        /// <summary>Replaces the side shared by two triangles by the other diagonal of their quadrilateral, which must be convex.</summary>
        /// <returns>The new side, seen from one of the triangles; its twin is the other.</returns>
        public int Flip(int side)
        {
            int twin = twins[side], before = Previous(side), twinBefore = Previous(twin);
            int near = corners[before], far = corners[twinBefore], start = corners[side], end = corners[twin];
            int twinOfBefore = twins[before], twinOfTwinBefore = twins[twinBefore];
            corners[side] = far;
            corners[twin] = near;
            Join(side, twinOfTwinBefore);
            Join(twin, twinOfBefore);
            Join(before, twinBefore);
            firstSides[near] = before;
            firstSides[far] = twinBefore;
            firstSides[start] = Next(twin);
            firstSides[end] = Next(side);
            return before;
        }

        /// <summary>The side from one point to another, or −1.</summary>
        public int Find(int from, int to)
        {
            int first = firstSides[from], side = first;
            do
            {
                if (End(side) == to)
                    return side;
                side = twins[Previous(side)];
            }
            while (side >= 0 && side != first);
            return -1;
        }

        /// <summary>Point indices, three a triangle, clockwise: facing up where z points up in the plan.</summary>
        public int[] Clockwise()
        {
            int[] triangles = corners.ToArray();
            for (int k = 0; k < triangles.Length; k += 3)
                (triangles[k + 1], triangles[k + 2]) = (triangles[k + 2], triangles[k + 1]);
            return triangles;
        }

        private void Join(int side, int twin)
        {
            twins[side] = twin;
            if (twin >= 0)
                twins[twin] = side;
        }
    }
}
