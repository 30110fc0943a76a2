using System;
using System.Collections.Generic;
using Alate.Geometry;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>Shapes with soft edges that patterns are drawn with, each a share from 0 outside to 1 inside.</summary>
    internal static class Ink
    {
        private const int k_EdgeSamples = 96, k_MarginSamples = 240, k_CurveSteps = 12;

        /// <summary>Distance of two rows of scales over that of two scales in a row: that of equilateral triangles.</summary>
        private const double k_RowOverSize = 0.866;

        /// <summary>Large odd numbers, which spread the bits of a place.</summary>
        private static readonly uint3 s_SpeckleFactors = new uint3(0x9E3779B1u, 0x85EBCA77u, 0xC2B2AE3Du);

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

        /// <summary>Soft ellipses: 1 inside of one, 0 outside of all.</summary>
        /// <param name="ellipses">Of each the span and the place ahead of its middle, and its radii along and across the span.</param>
        /// <param name="span">Place along the span.</param>
        /// <param name="forward">Place ahead of the hinge line.</param>
        /// <param name="softness">Width of their edges.</param>
        public static float Ellipses(double[] ellipses, double span, double forward, double softness)
        {
            float inside = 0f;
            for (int k = 0; k < ellipses.Length; k += 4)
            {
                inside = Math.Max(
                    inside, Ellipse(span - ellipses[k], forward - ellipses[k + 1], ellipses[k + 2], ellipses[k + 3], softness));
            }

            return inside;
        }

        /// <summary>A colour in more or less light; its opacity stays.</summary>
        public static Color Lit(Color colour, double light)
        {
            float factor = (float)light;
            return new Color(factor * colour.r, factor * colour.g, factor * colour.b, colour.a);
        }

        /// <summary>Share that falls from 1 at a place to 0 at a reach from it, and turns out there without a step.</summary>
        public static double Fade(double distance, double reach)
        {
            double near = Math.Clamp(1 - distance / reach, 0, 1);
            return near * near;
        }

        /// <summary>Pseudo-random value from 0 to 1 by place, repeatable: for the mottling of skins, hairs and scales.</summary>
        public static float Speckle(Vector3 place)
        {
            uint3 bits = math.asuint((float3)place) * s_SpeckleFactors;
            return Unity.Mathematics.Random.CreateFromIndex((bits.x ^ bits.y ^ bits.z) >> 1).NextFloat();
        }

        /// <summary>Grain of scales, −1 to 1 and 0 on average; none where samples are too far apart to show it.</summary>
        /// <param name="x">Along the span.</param>
        /// <param name="z">Forward.</param>
        /// <param name="size">Of a scale.</param>
        /// <param name="softness">Distance of two samples.</param>
        public static float Grain(double x, double z, double size, double softness)
        {
            float share = Within(softness, size, size);
            if (share == 0f)
                return 0f;

            // Rows of scales lie half a scale beside each other, so that none of their edges runs straight across the wing.
            double v = z / (k_RowOverSize * size), u = x / size - 0.5 * v, column = Math.Floor(u), row = Math.Floor(v), right = u - column,
                up = v - row, beyond = right + up - 1;
            double value = Scale(column + 1, row) * (beyond > 0 ? 1 - up : right) + Scale(column, row + 1) * (beyond > 0 ? 1 - right : up)
                + (beyond > 0 ? Scale(column + 1, row + 1) * beyond : -Scale(column, row) * beyond);
            return share * (float)(2 * value - 1);
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
            Points(k_EdgeSamples, from, to, span => new PlanPoint(span, edge(span)));

        /// <summary>
        /// Points x, z, x, z, … of a part of a wing's margin, between two shares of its length from the leading corner of the base.
        /// </summary>
        public static List<double> Margin(WingOutline outline, double from, double to)
        {
            Polyline margin = WingRim.Margin(outline);
            return Points(k_MarginSamples, from, to, share => margin.At(margin.Length * share));
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

        /// <summary>Points x, z, x, z, … of a smooth curve through points, after Catmull and Rom.</summary>
        public static List<double> Smooth(double[] points)
        {
            int last = points.Length / 2 - 1;
            PlanPoint At(int k) => new PlanPoint(points[2 * Math.Clamp(k, 0, last)], points[2 * Math.Clamp(k, 0, last) + 1]);
            var curve = new List<double> { points[0], points[1] };
            for (int k = 0; k < last; k++)
            {
                PlanPoint a = At(k), b = At(k + 1), leave = (b - At(k - 1)) * 0.5, arrive = (At(k + 2) - a) * 0.5;
                for (int step = 1; step <= k_CurveSteps; step++)
                {
                    double t = (double)step / k_CurveSteps, u = 1 - t;
                    PlanPoint place = a * (u * u * (1 + 2 * t)) + b * (t * t * (1 + 2 * u)) + leave * (u * u * t) - arrive * (t * t * u);
                    curve.Add(place.x);
                    curve.Add(place.z);
                }
            }

            return curve;
        }

        /// <summary>Length of a polyline given as x, z, x, z, …</summary>
        public static double Length(IReadOnlyList<double> points)
        {
            double length = 0;
            for (int k = 2; k < points.Count; k += 2)
            {
                double x = points[k] - points[k - 2], z = points[k + 1] - points[k - 1];
                length += Math.Sqrt(x * x + z * z);
            }

            return length;
        }

        /// <summary>Place on a polyline given as x, z, x, z, …, at a distance along it.</summary>
        public static (double X, double Z) On(IReadOnlyList<double> points, double along)
        {
            int last = points.Count - 2;
            for (int k = 0; k < last; k += 2)
            {
                double x = points[k + 2] - points[k], z = points[k + 3] - points[k + 1], length = Math.Sqrt(x * x + z * z);
                if (along <= length && length > 0)
                    return (points[k] + x * along / length, points[k + 1] + z * along / length);
                along -= length;
            }

            return (points[last], points[last + 1]);
        }

        private static float Scale(double column, double row) => Speckle(new Vector3((float)column, (float)row, 0f));

        private static List<double> Points(int samples, double from, double to, Func<double, PlanPoint> at)
        {
            var points = new List<double>();
            for (int i = 0; i <= samples; i++)
            {
                PlanPoint place = at(from + (to - from) * i / samples);
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
