using System;
using System.Collections.Generic;
using UnityEngine;
using Random = System.Random;

namespace Alate.Tests
{
    /// <summary>
    /// A random wing in plan, star-shaped about its middle: a Fourier series from slender to round; some with a tail, a notch, scallops or
    /// sweep. About 1 long; base towards −X, leading edge towards +Z.
    /// </summary>
    internal sealed class RandomOutline
    {
        private readonly double[] m_Amplitudes = new double[6];
        private readonly double[] m_Phases = new double[6];
        private readonly double m_Aspect;
        private readonly double m_Sweep;
        private readonly double m_TailHeight;
        private readonly double m_TailAngle;
        private readonly double m_TailWidth;
        private readonly double m_ScallopHeight;
        private readonly int m_ScallopCount;

        public RandomOutline(Random random)
        {
            double wildness = 0.25 * random.NextDouble();
            for (int k = 2; k < m_Amplitudes.Length; k++)
            {
                m_Amplitudes[k] = wildness * random.NextDouble() / k;
                m_Phases[k] = 2.0 * Math.PI * random.NextDouble();
            }

            m_Aspect = Math.Exp(Math.Log(0.12) * random.NextDouble());
            m_Sweep = 0.5 * (random.NextDouble() - 0.6);
            m_TailAngle = -0.6 - 1.4 * random.NextDouble();
            m_TailWidth = 0.05 + 0.07 * random.NextDouble();
            int feature = random.Next(4);
            HasTail = feature == 0;
            m_TailHeight = feature == 0 ? 0.25 + 0.45 * random.NextDouble() : feature == 1 ? -0.35 * random.NextDouble() : 0.0;
            m_ScallopHeight = feature == 2 ? 0.01 + 0.02 * random.NextDouble() : 0.0;
            m_ScallopCount = random.Next(12, 30);
        }

        public bool HasTail { get; }

        /// <summary>A point of the outline, counterclockwise with the angle from the tip.</summary>
        /// <param name="angle">About the middle, radians.</param>
        /// <param name="share">0 is the middle, 1 the outline.</param>
        public (double X, double Z) At(double angle, double share = 1.0)
        {
            double r = 1.0;
            for (int k = 2; k < m_Amplitudes.Length; k++)
                r += m_Amplitudes[k] * Math.Cos(k * angle + m_Phases[k]);
            double wrapped = angle - 2.0 * Math.PI * Math.Round(angle / (2.0 * Math.PI)), off = (wrapped - m_TailAngle) / m_TailWidth;
            r += m_TailHeight * Math.Exp(-0.5 * off * off);
            double rear = Math.Max(0.0, Math.Sin(-wrapped));
            r += m_ScallopHeight * rear * Math.Cos(m_ScallopCount * angle);
            double x = 0.5 + 0.5 * share * r * Math.Cos(angle), z = 0.5 * share * m_Aspect * r * Math.Sin(angle);
            return (x, z + m_Sweep * x * x);
        }

        /// <summary>The outline as a polygon.</summary>
        public (double X, double Z)[] Polygon(int corners)
        {
            var polygon = new (double, double)[corners];
            for (int k = 0; k < corners; k++)
                polygon[k] = At(2.0 * Math.PI * k / corners);
            return polygon;
        }

        /// <summary>A random triangulation in the plane y = 0: rings of irregular vertices, stitched; every seed makes another.</summary>
        public WingSurface Mesh(Random random)
        {
            int rings = random.Next(1, 9), rim = random.Next(500, 900);
            var positions = new List<Vector3>();
            var starts = new List<int>();
            var angles = new List<double[]>();
            for (int ring = 1; ring <= rings; ring++)
            {
                int count = ring == rings ? rim : Math.Max(5, rim * ring / rings / random.Next(1, 6));
                double[] around = Angles(count, random);
                starts.Add(positions.Count);
                angles.Add(around);
                foreach (double angle in around)
                {
                    double jitter = ring == rings ? 0.0 : 0.2 * (random.NextDouble() - 0.5) / rings;
                    (double x, double z) = At(angle, (double)ring / rings + jitter);
                    positions.Add(new Vector3((float)x, 0f, (float)z));
                }
            }

            (double middleX, double middleZ) = At(0.0, 0.0);
            positions.Add(new Vector3((float)middleX, 0f, (float)middleZ));
            var triangles = new List<int>();
            int first = angles[0].Length;
            for (int k = 0; k < first; k++)
                triangles.AddRange(new[] { positions.Count - 1, (k + 1) % first, k });
            for (int ring = 1; ring < rings; ring++)
                Stitch(triangles, starts[ring - 1], angles[ring - 1], starts[ring], angles[ring]);
            return new WingSurface { name = "Random", positions = positions.ToArray(), triangles = triangles.ToArray() };
        }

        private static double[] Angles(int count, Random random)
        {
            var angles = new double[count];
            double offset = random.NextDouble();
            for (int k = 0; k < count; k++)
                angles[k] = 2.0 * Math.PI * (k + offset + 0.6 * (random.NextDouble() - 0.5)) / count;
            return angles;
        }

        // Steps round both rings, whichever lags.
        private static void Stitch(List<int> triangles, int inner, double[] innerAngles, int outer, double[] outerAngles)
        {
            int a = 0, b = 0;
            while (a < innerAngles.Length || b < outerAngles.Length)
            {
                int i = inner + a % innerAngles.Length, o = outer + b % outerAngles.Length;
                if (b == outerAngles.Length || (a < innerAngles.Length && Next(innerAngles, a) < Next(outerAngles, b)))
                    triangles.AddRange(new[] { i, inner + ++a % innerAngles.Length, o });
                else
                    triangles.AddRange(new[] { i, outer + (b + 1) % outerAngles.Length, outer + b++ % outerAngles.Length });
            }
        }

        private static double Next(double[] angles, int k) =>
            k + 1 < angles.Length ? angles[k + 1] : angles[0] + 2.0 * Math.PI;
    }
}
