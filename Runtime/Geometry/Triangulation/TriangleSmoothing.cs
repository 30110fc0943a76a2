using System;
using System.Collections.Generic;

namespace Alate.Geometry
{
    /// <summary>
    /// Makes triangles more even: moves inner points towards the middle of the triangles around them and flips sides by Delaunay's
    /// condition; then moves the corners of slender triangles to where the worst triangle around them is best.
    /// </summary>
    internal static class TriangleSmoothing
    {
        /// <summary>Quality below which a triangle is slender, 0 to 1.</summary>
        private const double k_Slender = 0.7;

        private const int k_Rounds = 20, k_MendingRounds = 6;

        /// <summary>
        /// Number of directions in which a better place is tried; first and last step, as shares of the distance to the farthest neighbour.
        /// </summary>
        private const int k_Directions = 8;
        private const double k_FirstStep = 0.25, k_LastStep = 0.01;

        /// <summary>Smooths the triangles in some rounds.</summary>
        /// <param name="mesh">Its points change places.</param>
        /// <param name="rimCount">Points before this one stay where they are.</param>
        public static void Run(TriangleLinks mesh, int rimCount)
        {
            Flip(mesh);
            var around = new List<int>();
            for (int round = 0; round < k_Rounds; round++)
            {
                for (int point = rimCount; point < mesh.points.Length; point++)
                    Move(mesh, point, around);
                Flip(mesh);
            }

            for (int round = 0; round < k_MendingRounds; round++)
            {
                for (int point = rimCount; point < mesh.points.Length; point++)
                    Mend(mesh, point, around);
                Flip(mesh);
            }
        }

        /// <summary>
        /// Quality of a triangle: 1 if equilateral, 0 without area, below 0 the wrong way round; area over the sum of the squared sides,
        /// scaled.
        /// </summary>
        public static double Quality(PlanPoint a, PlanPoint b, PlanPoint c)
        {
            double area = PlanPoint.Cross(b - a, c - a), sides = (b - a).LengthSquared + (c - b).LengthSquared + (a - c).LengthSquared;
            return 2.0 * Math.Sqrt(3.0) * area / sides;
        }

        private static void Flip(TriangleLinks mesh)
        {
            bool changed = true;
            for (int round = 0; changed && round < 50; round++)
            {
                changed = false;
                for (int side = 0; side < mesh.SideCount; side++)
                {
                    if (mesh.twins[side] <= side || !mesh.IsAgainstDelaunay(side) || !mesh.CanFlip(side))
                        continue;
                    mesh.Flip(side);
                    changed = true;
                }
            }
        }

        private static void Move(TriangleLinks mesh, int point, List<int> around)
        {
            Gather(mesh, point, around);
            PlanPoint old = mesh.points[point], sum = default;
            double weight = 0.0;
            foreach (int side in around)
            {
                PlanPoint b = mesh.points[mesh.End(side)], c = mesh.points[mesh.Apex(side)];
                double area = PlanPoint.Cross(b - old, c - old);
                sum += (old + b + c) * (area / 3.0);
                weight += area;
            }

            double worst = Math.Min(Worst(mesh, around, old), k_Slender);
            PlanPoint wanted = sum * (1.0 / weight);
            for (double share = 1.0; share > 0.1; share *= 0.5)
            {
                PlanPoint tried = old + (wanted - old) * share;
                if (Worst(mesh, around, tried) < worst)
                    continue;
                mesh.points[point] = tried;
                return;
            }
        }

        private static void Mend(TriangleLinks mesh, int point, List<int> around)
        {
            Gather(mesh, point, around);
            double worst = Worst(mesh, around, mesh.points[point]);
            if (worst >= k_Slender)
                return;
            double reach = 0.0;
            foreach (int side in around)
                reach = Math.Max(reach, (mesh.points[mesh.End(side)] - mesh.points[point]).LengthSquared);
            reach = Math.Sqrt(reach);
            for (double step = k_FirstStep; step > k_LastStep; step *= 0.5)
            {
                for (int direction = 0; direction < k_Directions; direction++)
                {
                    double angle = 2.0 * Math.PI * direction / k_Directions;
                    PlanPoint tried = mesh.points[point] + new PlanPoint(Elementary.Cos(angle), Elementary.Sin(angle)) * (step * reach);
                    double found = Worst(mesh, around, tried);
                    if (found <= worst)
                        continue;
                    worst = found;
                    mesh.points[point] = tried;
                }
            }
        }

        // The sides that begin at a point.
        private static void Gather(TriangleLinks mesh, int point, List<int> around)
        {
            around.Clear();
            int first = mesh.firstSides[point], side = first;
            do
            {
                around.Add(side);
                side = mesh.twins[TriangleLinks.Previous(side)];
            }
            while (side >= 0 && side != first);
        }

        private static double Worst(TriangleLinks mesh, List<int> around, PlanPoint tried)
        {
            double worst = 1.0;
            foreach (int side in around)
                worst = Math.Min(worst, Quality(tried, mesh.points[mesh.End(side)], mesh.points[mesh.Apex(side)]));
            return worst;
        }
    }
}
