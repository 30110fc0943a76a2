using System;
using System.Collections.Generic;
using Alate.Geometry;
using Unity.Mathematics;

namespace Alate.Fitting
{
    /// <summary>One layer of a wing, cleaned: its triangles, the plane in which it is seen from above, and its outline there.</summary>
    internal sealed class WingSheet
    {
        /// <summary>[place] Position in space.</summary>
        public readonly float3[] points;

        /// <summary>Triangles, three places each.</summary>
        public readonly List<int3> triangles;

        public readonly WingPlane plane;

        /// <summary>[place] Position seen from above.</summary>
        public readonly PlanPoint[] plan;

        /// <summary>Places counterclockwise round the wing; empty without open edges.</summary>
        public readonly List<int> rim;

        /// <summary>Places round each hole.</summary>
        public readonly List<List<int>> holes;

        /// <summary>The rim seen from above.</summary>
        public readonly PlanPoint[] outline;

        public WingSheet(float3[] points, List<int3> triangles, in WingPlane plane, float tolerance)
        {
            this.points = points;
            this.triangles = triangles;
            this.plane = plane;
            plan = new PlanPoint[points.Length];
            foreach (int3 t in triangles)
            {
                plan[t.x] = plane.ToPlan(points[t.x]);
                plan[t.y] = plane.ToPlan(points[t.y]);
                plan[t.z] = plane.ToPlan(points[t.z]);
                PlanArea += Math.Abs(Polygon.DoubledArea(plan[t.x], plan[t.y], plan[t.z])) / 2.0;
            }

            var walk = new OutlineWalk(plan, new SheetBoundary(points, triangles, tolerance).edges);
            rim = walk.outline;
            holes = walk.holes;
            outline = Seen(rim);
        }

        /// <summary>Area of the triangles in space.</summary>
        public double Area => SheetPieces.Area(points, triangles);

        /// <summary>Sum of the areas of the triangles seen from above.</summary>
        public double PlanArea { get; }

        /// <summary>
        /// Area of the outline over that of the triangles: 1 for a plain wing, about ½ for two layers, 0 for a closed one.
        /// </summary>
        public double OutlineShare => Polygon.Area(outline) / PlanArea;

        /// <summary>Place on the surface seen at a point from above; beside the surface the closest place of its rim.</summary>
        public float3 Lift(PlanPoint p)
        {
            double least = double.MaxValue;
            float3 found = plane.Direction(p);
            for (int k = 0; k < triangles.Count && least > 0.0; k++)
            {
                int3 t = triangles[k];
                var triangle = new PlanTriangle(plan[t.x], plan[t.y], plan[t.z]);
                if (triangle.LeastDistanceSquared(p) >= least)
                    continue;
                double distance = triangle.Closest(p, out double a, out double b, out double c);
                if (distance >= least)
                    continue;
                least = distance;
                found = (float)a * points[t.x] + (float)b * points[t.y] + (float)c * points[t.z];
            }

            return found;
        }

        /// <summary>Places seen from above.</summary>
        public PlanPoint[] Seen(List<int> places) => places.ConvertAll(place => plan[place]).ToArray();
    }
}
