using System;
using System.Collections.Generic;
using UnityEngine;
using Random = System.Random;

namespace Alate.Tests
{
    /// <summary>
    /// A wing for tests, star-shaped about its middle, about 1 long: base towards −X, leading edge towards +Z, up +Y; an ellipse unless
    /// its fields say otherwise.
    /// </summary>
    public sealed class PolarWing
    {
        /// <summary>Width over length.</summary>
        public double aspect = 0.45;

        /// <summary>Forward sweep of the tip end, lengths.</summary>
        public double sweep;

        /// <summary>Amplitude and phase of the waves 0, 1, 2, … round the outline, shares of the radius.</summary>
        public double[] waves = new double[0];
        public double[] phases = new double[0];

        /// <summary>
        /// Height of a tail, or depth of a notch where negative, in radii; its angle from the tip and its width, radians.
        /// </summary>
        public double tail;
        public double tailAngle = -0.9;
        public double tailWidth = 0.07;

        /// <summary>Height and number of the scallops of the rear margin.</summary>
        public double scallop;
        public int scallops = 24;

        /// <summary>Height over the span squared and over the chord squared of a wing that is not flat.</summary>
        public double bend;
        public double camber;

        /// <summary>A place of the wing.</summary>
        /// <param name="angle">About the middle, radians: 0 is the tip, ½π the leading edge.</param>
        /// <param name="share">0 is the middle, 1 the outline.</param>
        public Vector3 At(double angle, double share = 1.0)
        {
            double r = 1.0;
            for (int k = 0; k < waves.Length; k++)
                r += waves[k] * Math.Cos(k * angle + phases[k]);
            double wrapped = angle - 2.0 * Math.PI * Math.Round(angle / (2.0 * Math.PI)), off = (wrapped - tailAngle) / tailWidth;
            r += tail * Math.Exp(-0.5 * off * off);
            r += scallop * Math.Max(0.0, Math.Sin(-wrapped)) * Math.Cos(scallops * angle);
            double x = 0.5 + 0.5 * share * r * Math.Cos(angle), z = 0.5 * share * aspect * r * Math.Sin(angle);
            return new Vector3((float)x, (float)(bend * x * x + camber * z * z), (float)(z + sweep * x * x));
        }

        /// <summary>The outline as a polygon of many corners.</summary>
        public Vector3[] Outline(int corners = 3000)
        {
            var outline = new Vector3[corners];
            for (int k = 0; k < corners; k++)
                outline[k] = At(2.0 * Math.PI * k / corners);
            return outline;
        }

        /// <summary>A triangulation with irregular rings of vertices; every seed makes another.</summary>
        public SurfaceMesh Mesh(int seed = 1)
        {
            var random = new Random(seed);
            int rings = random.Next(1, 9), rim = random.Next(500, 900);
            var positions = new List<Vector3>();
            var triangles = new List<int>();
            double[][] angles = new double[rings][];
            for (int ring = 0; ring < rings; ring++)
            {
                bool isRim = ring == rings - 1;
                angles[ring] = Angles(isRim ? rim : Math.Max(5, rim * (ring + 1) / rings / random.Next(1, 6)), random);
                foreach (double angle in angles[ring])
                {
                    double jitter = isRim ? 0.0 : 0.2 * (random.NextDouble() - 0.5) / rings;
                    positions.Add(At(angle, (double)(ring + 1) / rings + jitter));
                }
            }

            int first = angles[0].Length;
            for (int k = 0; k < first; k++)
                triangles.AddRange(new[] { positions.Count, (k + 1) % first, k });
            positions.Add(At(0.0, 0.0));
            for (int ring = 1, start = 0; ring < rings; start += angles[ring - 1].Length, ring++)
                Stitch(triangles, start, angles[ring - 1], angles[ring]);
            return new SurfaceMesh { name = "Polar", positions = positions.ToArray(), triangles = triangles.ToArray() };
        }

        private static double[] Angles(int count, Random random)
        {
            double[] angles = new double[count];
            double offset = random.NextDouble();
            for (int k = 0; k < count; k++)
                angles[k] = 2.0 * Math.PI * (k + offset + 0.6 * (random.NextDouble() - 0.5)) / count;
            return angles;
        }

        // Steps round two neighbouring rings, on whichever lags.
        private static void Stitch(List<int> triangles, int inner, double[] innerAngles, double[] outerAngles)
        {
            int outer = inner + innerAngles.Length;
            for (int a = 0, b = 0; a < innerAngles.Length || b < outerAngles.Length;)
            {
                int i = inner + a % innerAngles.Length, o = outer + b % outerAngles.Length;
                bool innerLags = a < innerAngles.Length && Next(innerAngles, a) < Next(outerAngles, b);
                if (b == outerAngles.Length || innerLags)
                    triangles.AddRange(new[] { i, inner + ++a % innerAngles.Length, o });
                else
                    triangles.AddRange(new[] { i, outer + ++b % outerAngles.Length, o });
            }
        }

        private static double Next(double[] angles, int k) => k + 1 < angles.Length ? angles[k + 1] : angles[0] + 2.0 * Math.PI;
    }
}
