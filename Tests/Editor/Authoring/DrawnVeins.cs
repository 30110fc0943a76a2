using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate.Editor.Tests
{
    /// <summary>Veins that tests draw into a <see cref="DrawnWing"/>: gently bent lines from near the hinge to the margin.</summary>
    internal sealed class DrawnVeins
    {
        private const int k_Steps = 40;

        private DrawnVeins(List<Vector2[]> radial, List<Vector2[]> cross)
        {
            Radial = radial;
            Cross = cross;
        }

        /// <summary>From the leading to the trailing edge, each from its root to the margin.</summary>
        public IReadOnlyList<Vector2[]> Radial { get; }

        /// <summary>Between neighbours.</summary>
        public IReadOnlyList<Vector2[]> Cross { get; }

        /// <summary>Veins to places that lie evenly on the rim from near the tip to the rear.</summary>
        /// <param name="wing">Where they lie.</param>
        /// <param name="count">How many.</param>
        /// <param name="bend">Sideways bend, a share of their length.</param>
        public static DrawnVeins In(DrawnWing wing, int count, float bend = 0.06f)
        {
            Vector2[] rim = RearRim(wing);
            Vector2 root = 0.5f * (wing.Outline[0] + wing.Outline[wing.Outline.Length - 1]);
            Vector2 across = wing.Outline[wing.Outline.Length - 1] - wing.Outline[0];
            var radial = new List<Vector2[]>();
            for (int k = 0; k < count; k++)
            {
                Vector2 start = root + 0.6f * (0.5f - (k + 0.5f) / count) * across, end = At(rim, (k + 0.5f) / count);
                radial.Add(Bent(start, end, bend));
            }

            var cross = new List<Vector2[]>();
            for (int k = 0; k + 1 < count; k++)
            {
                for (int step = 16; step < k_Steps - 4; step += 8)
                    cross.Add(new[] { radial[k][step], radial[k + 1][step] });
            }

            return new DrawnVeins(radial, cross);
        }

        // The rim from the foremost place near the tip, around it, back to two tenths of the span.
        private static Vector2[] RearRim(DrawnWing wing)
        {
            var rim = new List<Vector2>(wing.Outline);
            rim.Reverse();
            int tip = 0;
            for (int k = 0; k < rim.Count; k++)
                tip = rim[k].x > 0.9f * LongestReach(wing) ? Math.Max(tip, k) : tip;
            int first = rim.FindIndex(p => p.x > 0.9f * LongestReach(wing));
            int last = rim.FindIndex(tip, p => p.x < 0.25f * LongestReach(wing));
            return rim.GetRange(first, last - first).ToArray();
        }

        private static float LongestReach(DrawnWing wing)
        {
            float reach = 0f;
            foreach (Vector2 point in wing.Outline)
                reach = Math.Max(reach, point.x);
            return reach;
        }

        private static Vector2 At(Vector2[] path, float share)
        {
            float length = 0f;
            for (int k = 0; k + 1 < path.Length; k++)
                length += (path[k + 1] - path[k]).magnitude;
            float wanted = share * length;
            for (int k = 0; k + 1 < path.Length; k++)
            {
                float step = (path[k + 1] - path[k]).magnitude;
                if (wanted <= step)
                    return path[k] + wanted / Math.Max(step, 1e-9f) * (path[k + 1] - path[k]);
                wanted -= step;
            }

            return path[path.Length - 1];
        }

        private static Vector2[] Bent(Vector2 start, Vector2 end, float bend)
        {
            var path = new Vector2[k_Steps + 1];
            Vector2 along = end - start, middle = 0.5f * (start + end) + bend * new Vector2(-along.y, along.x);
            for (int k = 0; k <= k_Steps; k++)
            {
                float t = (float)k / k_Steps;
                path[k] = (1f - t) * (1f - t) * start + 2f * t * (1f - t) * middle + t * t * end;
            }

            return path;
        }
    }
}
