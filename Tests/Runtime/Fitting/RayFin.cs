using System.Collections.Generic;
using UnityEngine;
using Random = System.Random;

namespace Alate.Tests
{
    /// <summary>A fin for tests, 1 long: rays that fan out from a base along Z, their ends joined by hollows.</summary>
    public sealed class RayFin
    {
        private const int k_CornersPerHollow = 12;

        /// <summary>Number of rays.</summary>
        public int rays = 11;

        /// <summary>Depth of the hollows, ray lengths.</summary>
        public double depth = 0.06;

        /// <summary>Directions of the first and the last ray, radians from the span towards the leading edge.</summary>
        public double first = 1.0;
        public double last = -1.1;

        /// <summary>Length of the first ray; the others are 1 long.</summary>
        public double firstLength = 1.0;

        /// <summary>The end of a ray.</summary>
        public Vector3 End(double ray) => On(first + (last - first) * ray / (rays - 1), Length(ray));

        /// <summary>The outline from the leading corner of the base.</summary>
        public Vector3[] Outline()
        {
            var outline = new List<Vector3> { new Vector3(0f, 0f, 0.12f) };
            int hollows = rays - 1;
            for (int k = 0; k <= hollows * k_CornersPerHollow; k++)
            {
                double at = (double)k / k_CornersPerHollow, share = at - System.Math.Floor(at);
                outline.Add(On(first + (last - first) * at / hollows, Length(at) * (1.0 - 4.0 * depth * share * (1.0 - share))));
            }

            outline.Add(new Vector3(0f, 0f, -0.12f));
            return outline.ToArray();
        }

        /// <summary>A fan of triangles with random places inside.</summary>
        public SurfaceMesh Mesh(int seed = 1)
        {
            var random = new Random(seed);
            var positions = new List<Vector3>(Outline());
            var triangles = new List<int>();
            int rim = positions.Count, middle = rim;
            positions.Add(new Vector3(0.1f, 0f, 0f));
            for (int k = 0; k < rim; k++)
            {
                int next = (k + 1) % rim;
                float share = 0.2f + 0.6f * (float)random.NextDouble();
                positions.Add(Vector3.Lerp(positions[middle], 0.5f * (positions[k] + positions[next]), share));
                int inner = positions.Count - 1;
                triangles.AddRange(new[] { middle, k, inner, k, next, inner, next, middle, inner });
            }

            return new SurfaceMesh { name = "Fin", positions = positions.ToArray(), triangles = triangles.ToArray() };
        }

        private double Length(double ray) => firstLength + (1.0 - firstLength) * System.Math.Min(1.0, ray);

        private static Vector3 On(double angle, double length) =>
            new Vector3((float)(length * System.Math.Cos(angle)), 0f, (float)(length * System.Math.Sin(angle)));
    }
}
