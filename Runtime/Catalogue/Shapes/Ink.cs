using System;
using System.Collections.Generic;
using Alate.Geometry;

namespace Alate.Catalogue
{
    /// <summary>Shapes with soft edges that patterns are drawn with, each a share from 0 outside to 1 inside.</summary>
    internal static class Ink
    {
        private const int k_EdgeSamples = 96;

        /// <summary>Soft step: 1 within the limit, 0 beyond it, over the given width.</summary>
        public static float Within(double distance, double limit, double softness)
        {
            return (float)Math.Clamp(0.5 + (limit - distance) / Math.Max(softness, 1e-9), 0, 1);
        }

        /// <summary>Soft band: 1 between two limits, 0 outside.</summary>
        public static float Between(double value, double from, double to, double softness)
        {
            return Math.Min(Within(value, to, softness), Within(-value, -from, softness));
        }

        /// <summary>Soft ellipse with axes along and across the span: 1 inside, 0 outside.</summary>
        public static float Ellipse(double x, double z, double radiusX, double radiusZ, double softness)
        {
            double size = Math.Min(radiusX, radiusZ);
            return Within((Math.Sqrt(x * x / (radiusX * radiusX) + z * z / (radiusZ * radiusZ)) - 1) * size, 0, softness);
        }

        /// <summary>Row of soft spots along an edge: 1 inside a spot, 0 outside.</summary>
        /// <param name="along">Where along the edge.</param>
        /// <param name="distance">How far from the edge.</param>
        /// <param name="spacing">From one spot to the next.</param>
        /// <param name="depth">Of the spots' middles below the edge.</param>
        /// <param name="radiusAlong">Half their length.</param>
        /// <param name="radiusAcross">Half their width.</param>
        /// <param name="softness">Width of their edges.</param>
        public static float Row(
            double along, double distance, double spacing, double depth, double radiusAlong, double radiusAcross, double softness)
        {
            double beside = along - spacing * (Math.Floor(along / spacing) + 0.5);
            return Ellipse(beside, distance - depth, radiusAlong, radiusAcross, softness);
        }

        /// <summary>Points x, z, x, z, … of an edge over a range of span.</summary>
        public static List<double> Edge(Func<double, double> edge, double from, double to) =>
            Points(from, to, span => new PlanPoint(span, edge(span)));

        /// <summary>
        /// Points x, z, x, z, … of a part of a wing's margin, between two shares of its length from the leading corner of the base.
        /// </summary>
        public static List<double> Margin(WingOutline outline, double from, double to)
        {
            Polyline margin = WingRim.Margin(outline);
            return Points(from, to, share => margin.At(margin.Length * share));
        }

        /// <summary>Points with both ends led on straight, so that a band along them does not end in a round.</summary>
        public static List<double> Extended(List<double> points, double by)
        {
            int last = points.Count - 2;
            (double startX, double startZ) = Beyond(points, 2, 0, by);
            (double endX, double endZ) = Beyond(points, last - 2, last, by);
            var extended = new List<double> { startX, startZ };
            extended.AddRange(points);
            extended.Add(endX);
            extended.Add(endZ);
            return extended;
        }

        private static List<double> Points(double from, double to, Func<double, PlanPoint> at)
        {
            var points = new List<double>();
            for (int i = 0; i <= k_EdgeSamples; i++)
            {
                PlanPoint place = at(from + (to - from) * i / k_EdgeSamples);
                points.Add(place.x);
                points.Add(place.z);
            }

            return points;
        }

        private static (double X, double Z) Beyond(List<double> points, int before, int end, double by)
        {
            double x = points[end] - points[before];
            double z = points[end + 1] - points[before + 1];
            double length = Math.Sqrt(x * x + z * z);
            return (points[end] + by * x / length, points[end + 1] + by * z / length);
        }
    }
}
