using System;
using System.Collections.Generic;

namespace Alate.Geometry
{
    /// <summary>
    /// Places vertices inside an outline: on a lattice of equilateral triangles, an exact number of them, clear of the rim.
    /// </summary>
    internal static class InteriorPoints
    {
        /// <summary>Least distance from the rim, in steps of the lattice.</summary>
        private const double k_Clearance = 0.55;

        /// <summary>
        /// Least distance from a corner, in steps: a nearer point would be the only one joined to it, by a short side. At the base of a
        /// wing that side stretches more than all others: 6.4 % in place of 5.8 for the firefly's.
        /// </summary>
        private const double k_CornerClearance = 1.1;

        private const int k_Rounds = 30;

        /// <summary>
        /// Least step of the lattice over that of points spread evenly; where it leaves no room, a smaller one hardly does.
        /// </summary>
        private const double k_LeastStep = 0.2;

        /// <summary>Sideways shift of the lattice, in steps, so that it never lies on lines of the outline.</summary>
        private const double k_ShiftX = 0.137, k_ShiftZ = 0.291;

        /// <summary>Points inside the rim, as many as asked for; fewer where there is no room.</summary>
        /// <param name="rim">Counterclockwise.</param>
        /// <param name="corners">Corners from which they keep farther away than from the rest of the rim.</param>
        /// <param name="count">Number of points.</param>
        public static List<PlanPoint> Place(List<PlanPoint> rim, List<PlanPoint> corners, int count)
        {
            var found = new List<(double Clearance, PlanPoint Point)>();
            if (count <= 0)
                return new List<PlanPoint>();
            double area = Polygon.Area(rim), high = 2.0 * Math.Sqrt(area / count) + 2.0 * area / Polyline.LengthOf(rim, true);
            double low = k_LeastStep * Math.Sqrt(area / count);
            // The coarsest lattice that has them all; the ones nearest to the rim are left out then.
            for (int round = 0; round < k_Rounds && (round < 8 || found.Count != count); round++)
            {
                double step = 0.5 * (low + high);
                List<(double Clearance, PlanPoint Point)> lattice = Lattice(rim, corners, step, 50 + 8 * count);
                if (lattice.Count < count)
                {
                    high = step;
                    continue;
                }

                found = lattice;
                low = step;
            }

            found.Sort((a, b) => b.Clearance.CompareTo(a.Clearance));
            return found.ConvertAll(place => place.Point).GetRange(0, Math.Min(count, found.Count));
        }

        private static List<(double Clearance, PlanPoint Point)> Lattice(
            List<PlanPoint> rim, List<PlanPoint> corners, double step, int limit)
        {
            var places = new List<(double Clearance, PlanPoint Point)>();
            var grid = new PolygonGrid(rim, step);
            PlanBounds bounds = grid.bounds;
            double rise = Math.Sqrt(0.75) * step, fromCorner = k_CornerClearance * step;
            for (int row = 0; bounds.low + (row + k_ShiftZ) * rise < bounds.high; row++)
            {
                for (int column = 0; bounds.left + column * step < bounds.right; column++)
                {
                    var point = new PlanPoint(
                        bounds.left + (column + k_ShiftX + 0.5 * (row % 2)) * step, bounds.low + (row + k_ShiftZ) * rise);
                    double clearance = grid.Clearance(point, 2.0 * step);
                    if (clearance < k_Clearance * step
                        || corners.Exists(corner => (corner - point).LengthSquared < fromCorner * fromCorner))
                    {
                        continue;
                    }
                    places.Add((clearance, point));
                    if (places.Count > limit)
                        return places;
                }
            }

            return places;
        }
    }
}
