using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>Outlines of blades along +x from a hinge at the origin: narrow ones, and such on a stalk.</summary>
    internal static class BladeOutline
    {
        private const int k_Steps = 300;

        /// <summary>Twelve times as long as it is wide.</summary>
        public static Vector2[] Narrow => Make(0.0, (0.012, 0.018), (0.014, 0.04));

        /// <summary>Stalk as a damselfly's: a fifth of the wing, nearly as narrow as a vein is thick.</summary>
        public static Vector2[] Stalked => Make(0.18, (0.018, 0.05), (0.018, 0.09));

        /// <summary>A third of the wing.</summary>
        public static Vector2[] LongStalked => Make(0.35, (0.012, 0.07), (0.012, 0.11));

        // Counterclockwise; ahead of the middle line and behind it the least width and what the blade adds, from the end of the stalk.
        private static Vector2[] Make(double stalk, (double Least, double Blade) ahead, (double Least, double Blade) behind)
        {
            var outline = new List<Vector2>();
            for (int k = 0; k <= k_Steps; k++)
                outline.Add(At(k, -1.0, behind));
            for (int k = k_Steps - 1; k >= 0; k--)
                outline.Add(At(k, 1.0, ahead));
            return outline.ToArray();

            Vector2 At(int k, double side, (double Least, double Blade) width)
            {
                double x = (double)k / k_Steps, rounded = Math.Sqrt(Math.Max(0.0, 1.0 - Math.Pow(x, 40.0)));
                double blade = x < stalk ? 0.0 : Math.Sqrt(Math.Max(0.0, Math.Sin(Math.PI * (x - stalk) / (1.0 - stalk))));
                return new Vector2((float)x, (float)(side * rounded * (width.Least + width.Blade * blade)));
            }
        }
    }
}
