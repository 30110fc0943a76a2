using System;
using System.Collections.Generic;
using UnityEngine;
using Random = System.Random;

namespace Alate.Tests
{
    /// <summary>Kinds of wings that differ in where their points and their breadth are.</summary>
    public enum OutlineKind
    {
        /// <summary>
        /// A butterfly's fore wing: a triangle with a long costa, a pointed apex and a narrow base opposite its outer margin.
        /// </summary>
        Butterfly,

        /// <summary>A butterfly's or moth's hind wing: a round fan from a narrow base.</summary>
        HindWing,

        /// <summary>A dragonfly's or fishfly's: long, the front edge nearly straight.</summary>
        Slender,

        /// <summary>A fly's or wasp's: an oval on a stalk.</summary>
        Oval,
    }

    /// <summary>
    /// Outlines of insects' wings as tests draw them: the hinge at (0, 0), x towards the tip, y towards the leading edge, the length about
    /// 1. Every seed makes another, within what wings of its kind have.
    /// </summary>
    internal static class InsectOutlines
    {
        private const int k_Steps = 24;

        public static Vector2[] Make(OutlineKind kind, int seed)
        {
            var random = new Random(1000 * seed + (int)kind);
            switch (kind)
            {
                case OutlineKind.Butterfly: return Butterfly(random);
                case OutlineKind.HindWing: return HindWing(random);
                case OutlineKind.Slender: return Blade(random, 0.015, 0.05, 0.06, 0.14, 2.5, 6.0);
                default: return Blade(random, 0.05, 0.12, 0.14, 0.3, 1.6, 3.0);
            }
        }

        // Costa, outer margin from the apex to the tornus, inner margin; all three bow out or in.
        private static Vector2[] Butterfly(Random random)
        {
            double top = Between(random, 0.05, 0.25), tornusX = Between(random, 0.55, 0.9), tornusY = -Between(random, 0.2, 0.45);
            double half = Between(random, 0.02, 0.06);
            var apex = new Vector2(1f, (float)top);
            var tornus = new Vector2((float)tornusX, (float)tornusY);
            Vector2 front = new Vector2(0f, (float)half), rear = new Vector2(0f, (float)-half);
            var path = new List<Vector2>();
            Arc(path, rear, tornus, Between(random, -0.03, 0.06));
            Arc(path, tornus, apex, Between(random, -0.06, 0.1));
            Arc(path, apex, front, Between(random, 0.02, 0.1));
            path.Add(front);
            return Rounded(path.ToArray(), Between(random, 0.01, 0.06));
        }

        // A fan about the base whose reach changes with the angle.
        private static Vector2[] HindWing(Random random)
        {
            double first = Between(random, 0.2, 0.6), last = -Between(random, 0.9, 1.5), half = Between(random, 0.02, 0.06);
            double skew = Between(random, -0.1, 0.35), wave = Between(random, 0.0, 0.02), waves = random.Next(5, 10);
            var path = new List<Vector2> { new Vector2(0f, (float)-half) };
            for (int k = 0; k <= 4 * k_Steps; k++)
            {
                double share = (double)k / (4 * k_Steps), angle = last + (first - last) * share;
                double reach = (1.0 - skew * (1.0 - share)) * Math.Pow(Math.Sin(Math.PI * (0.12 + 0.76 * share)), 0.5)
                    + wave * Math.Cos(2.0 * Math.PI * waves * share);
                path.Add(new Vector2((float)(reach * Math.Cos(angle)), (float)(reach * Math.Sin(angle))));
            }

            path.Add(new Vector2(0f, (float)half));
            return Rounded(path.ToArray(), 0.02);
        }

        private static Vector2[] Blade(
            Random random, double frontLeast, double frontMost, double rearLeast, double rearMost, double powerLeast, double powerMost)
        {
            double front = Between(random, frontLeast, frontMost), rear = Between(random, rearLeast, rearMost),
                half = Between(random, 0.015, 0.04);
            double frontPower = Between(random, powerLeast, powerMost) + 1.5, rearPower = Between(random, powerLeast, powerMost),
                stalk = Between(random, 3.0, 7.0);
            double sweep = Between(random, -0.1, 0.1);
            var path = new List<Vector2>();
            for (int k = 0; k <= 4 * k_Steps; k++)
                path.Add(Place(1.0 - Math.Cos(0.5 * Math.PI * k / (4 * k_Steps)), -rear, rearPower));
            for (int k = 4 * k_Steps - 1; k >= 0; k--)
                path.Add(Place(1.0 - Math.Cos(0.5 * Math.PI * k / (4 * k_Steps)), front, frontPower));
            return Rounded(path.ToArray(), Between(random, 0.02, 0.06));

            Vector2 Place(double x, double width, double power)
            {
                // x runs 0 to 1, slowly at the base and quickly at the tip.
                double at = Math.Sin(0.5 * Math.PI * x),
                    bell = Math.Sqrt(Math.Max(0.0, 1.0 - Math.Pow(at, power))) * Math.Min(1.0, stalk * at * 0.5);
                return new Vector2((float)at, (float)(Math.Sign(width) * half * (1.0 - at) + width * bell + sweep * at * at));
            }
        }

        private static void Arc(List<Vector2> path, Vector2 from, Vector2 to, double bow)
        {
            Vector2 along = to - from, across = new Vector2(along.y, -along.x);
            for (int k = 0; k < k_Steps; k++)
            {
                float share = (float)k / k_Steps;
                path.Add(from + share * along + 4f * share * (1f - share) * (float)bow * across);
            }
        }

        // Corners cut by averaging over a length of the outline; the base keeps its place.
        private static Vector2[] Rounded(Vector2[] path, double radius)
        {
            Vector2[] even = Even(path, 400);
            double length = 0.0;
            for (int k = 0; k < even.Length; k++)
                length += (even[(k + 1) % even.Length] - even[k]).magnitude;
            int reach = Math.Max(1, (int)Math.Round(radius / length * even.Length));
            var rounded = new Vector2[even.Length];
            for (int k = 0; k < even.Length; k++)
            {
                Vector2 sum = default;
                for (int j = -reach; j <= reach; j++)
                    sum += even[(k + j + even.Length) % even.Length];
                rounded[k] = sum / (2 * reach + 1);
            }

            return rounded;
        }

        private static Vector2[] Even(Vector2[] path, int count)
        {
            double[] lengths = new double[path.Length + 1];
            for (int k = 0; k < path.Length; k++)
                lengths[k + 1] = lengths[k] + (path[(k + 1) % path.Length] - path[k]).magnitude;
            var even = new Vector2[count];
            int at = 0;
            for (int k = 0; k < count; k++)
            {
                double wanted = lengths[path.Length] * k / count;
                while (lengths[at + 1] < wanted)
                    at++;
                double share = (wanted - lengths[at]) / Math.Max(lengths[at + 1] - lengths[at], 1e-12);
                even[k] = path[at] + (float)share * (path[(at + 1) % path.Length] - path[at]);
            }

            return even;
        }

        private static double Between(Random random, double least, double most) => least + (most - least) * random.NextDouble();
    }
}
