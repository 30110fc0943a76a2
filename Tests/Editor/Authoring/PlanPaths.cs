using System;
using System.Collections.Generic;
using Alate.Geometry;
using UnityEngine;

namespace Alate.Editor.Tests
{
    /// <summary>Distances between lines in a picture.</summary>
    internal static class PlanPaths
    {
        /// <summary>Pixels with y down as points with z up.</summary>
        public static PlanPoint[] ToPlan(Vector2[] places) => Array.ConvertAll(places, place => new PlanPoint(place.x, -place.y));

        /// <summary>The outline counterclockwise.</summary>
        public static PlanPoint[] Counterclockwise(Vector2[] outline)
        {
            PlanPoint[] plan = ToPlan(outline);
            if (Polygon.Area(plan) < 0.0)
                Array.Reverse(plan);
            return plan;
        }

        /// <summary>The largest distance of any place on either closed line from the other one.</summary>
        public static double Hausdorff(PlanPoint[] a, PlanPoint[] b) => Math.Max(Farthest(a, b), Farthest(b, a));

        /// <summary>Distance of a place from the nearest of some open lines.</summary>
        public static double Distance(Vector2 place, IEnumerable<Vector2[]> lines)
        {
            double least = double.MaxValue;
            foreach (Vector2[] line in lines)
                least = Math.Min(least, Polyline.Distance(ToPlan(line), new PlanPoint(place.x, -place.y)));
            return least;
        }

        private static double Farthest(PlanPoint[] from, PlanPoint[] to)
        {
            const int steps = 4;
            double farthest = 0.0;
            for (int k = 0; k < from.Length * steps; k++)
            {
                PlanPoint a = from[k / steps], b = from[(k / steps + 1) % from.Length];
                farthest = Math.Max(farthest, Polyline.Distance(to, a + (b - a) * ((double)(k % steps) / steps), true));
            }

            return farthest;
        }
    }
}
