using System;
using System.Collections.Generic;
using Alate.Catalogue;
using UnityEngine;

namespace Alate.Editor.Tests
{
    /// <summary>Wings that tests draw: x from the hinge towards the tip, y towards the leading edge, wing lengths.</summary>
    internal sealed class DrawnWing
    {
        private DrawnWing(string name, Vector2[] outline)
        {
            Name = name;
            Outline = outline;
        }

        public static IEnumerable<DrawnWing> All
        {
            get
            {
                yield return Monarch();
                yield return Slender();
                yield return Tailed();
                yield return Scalloped();
                yield return Fan();
            }
        }

        public string Name { get; }

        /// <summary>Counterclockwise.</summary>
        public Vector2[] Outline { get; }

        public static DrawnWing Monarch()
        {
            WingOutline outline = InsectCatalogue.Find("monarch").Wings[0].Contour;
            return Of("monarch", 400, x => outline.LeadingAt(x), x => outline.TrailingAt(x));
        }

        /// <summary>Like a dragonfly's: nine times as long as wide.</summary>
        public static DrawnWing Slender() => Of("slender", 400, x => 0.015 + 0.03 * Bell(x, 6), x => -0.02 - 0.06 * Bell(x, 4));

        /// <summary>A hind wing with a tail.</summary>
        public static DrawnWing Tailed() => Of(
            "tailed", 800,
            x => 0.06 + 0.10 * Bell(x, 3) + 0.16 * Math.Sin(1.2 * x),
            x => -0.1 - 0.34 * Bell(x, 3) - 0.25 * Math.Exp(-Math.Pow((x - 0.62) / 0.035, 4)));

        /// <summary>Wing with a wavy trailing edge.</summary>
        public static DrawnWing Scalloped() => Of(
            "scalloped", 800, x => 0.04 + 0.12 * Bell(x, 3),
            x => -0.05 - 0.3 * Bell(x, 2.5) - 0.025 * Math.Sin(40 * x) * Math.Min(1, 4 * (1 - x)));

        /// <summary>A broad fan from a narrow base.</summary>
        public static DrawnWing Fan()
        {
            var outline = new List<Vector2> { new Vector2(0f, -0.05f) };
            for (int k = 0; k <= 200; k++)
            {
                double angle = -1.1 + 1.75 * k / 200, reach = 0.86 + 0.14 * Math.Cos(angle - 0.3);
                outline.Add(new Vector2((float)(reach * Math.Cos(angle)), (float)(reach * Math.Sin(angle))));
            }

            outline.Add(new Vector2(0f, 0.05f));
            return new DrawnWing("fan", outline.ToArray());
        }

        /// <summary>A hind wing with a tail nearly as long as itself.</summary>
        public static DrawnWing LongTailed()
        {
            var outline = new List<Vector2>();
            for (int k = 0; k <= 90; k++)
                outline.Add(new Vector2(0.01f * k, (float)(-0.4 * Math.Sin(0.024 * k))));
            outline.AddRange(
                new[] { new Vector2(0.94f, -0.85f), new Vector2(0.98f, -0.9f), new Vector2(1.02f, -0.85f), new Vector2(1f, -0.3f) });
            for (int k = 100; k > 0; k--)
                outline.Add(new Vector2(0.01f * k, (float)(0.2 * Math.Sin(0.029 * k))));
            return new DrawnWing("long-tailed", outline.ToArray());
        }

        /// <summary>Wing with a margin cut in to the middle, like a plume moth's.</summary>
        public static DrawnWing Cleft()
        {
            var outline = new List<Vector2>();
            for (int k = 0; k <= 95; k++)
                outline.Add(new Vector2(0.01f * k, (float)(-0.4 * Math.Sin(0.026 * k))));
            outline.Add(new Vector2(0.5f, 0f));
            for (int k = 100; k > 0; k--)
                outline.Add(new Vector2(0.01f * k, (float)(0.3 * Math.Sin(0.023 * k))));
            return new DrawnWing("cleft", outline.ToArray());
        }

        /// <summary>The outline in a picture, its longer side that many pixels, in the middle and turned by an angle.</summary>
        /// <param name="share">Longer side of the wing's bounds over the picture's side.</param>
        public WingPlace In(int side, float degrees = 0f, bool mirrored = false, float share = 0.86f) =>
            new WingPlace(Outline, side, degrees, mirrored, share);

        private static DrawnWing Of(string name, int steps, Func<double, double> leading, Func<double, double> trailing)
        {
            var outline = new List<Vector2>();
            for (int k = 0; k <= steps; k++)
                outline.Add(new Vector2((float)k / steps, (float)trailing((double)k / steps)));
            for (int k = steps; k >= 0; k--)
                outline.Add(new Vector2((float)k / steps, (float)leading((double)k / steps)));
            return new DrawnWing(name, outline.ToArray());
        }

        // Rises steeply from the hinge and falls to 0 at the tip.
        private static double Bell(double x, double power) =>
            Math.Sqrt(Math.Max(0.0, 1.0 - Math.Pow(x, power))) * Math.Min(1.0, 0.25 + 1.5 * x);
    }
}
