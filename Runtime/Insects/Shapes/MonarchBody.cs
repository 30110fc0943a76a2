using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate
{
    /// <summary>A monarch's body, 29 mm long; proportions chosen by us.</summary>
    static class MonarchBody
    {
        const float k_DotRadius = 0.55f, k_SegmentLength = 2.5f;

        static readonly Color32 s_Black = new Color32(30, 25, 24, 255);
        static readonly Color32 s_Belly = new Color32(62, 50, 44, 255);
        static readonly Color32 s_Eye = new Color32(70, 36, 22, 255);
        static readonly Color32 s_Dot = new Color32(240, 234, 222, 255);

        static readonly Vector3[] s_Dots =
        {
            new Vector3(1.9f, 0.9f, 2.4f), new Vector3(2.1f, -0.8f, 1.2f), new Vector3(1.9f, -1.2f, -0.9f), new Vector3(1.6f, 1.2f, -2.4f),
            new Vector3(1.1f, -1.9f, 2.3f), new Vector3(0.9f, 1.1f, 4.3f), new Vector3(0.9f, -0.8f, 5.4f),
        };

        public static InsectBody Create()
        {
            var parts = new List<TubePart>
            {
                TubePart.Ellipsoid(new Vector3(0f, 0f, 0f), new Vector3(2.25f, 2.5f, 3.8f), 14, 16, Furred),
                TubePart.Ellipsoid(new Vector3(0f, 0.1f, 4.9f), new Vector3(1.5f, 1.4f, 1.5f), 10, 12, Furred),
                Abdomen(),
            };

            for (var side = -1; side <= 1; side += 2)
            {
                parts.Add(TubePart.Ellipsoid(new Vector3(1.15f * side, 0.25f, 5.2f), new Vector3(0.7f, 0.9f, 0.85f), 6, 8, _ => s_Eye));
                parts.Add(Antenna(side));
            }

            return new InsectBody(parts);
        }

        static TubePart Abdomen()
        {
            const int rings = 16;
            var spine = new Vector3[rings + 1];
            var radii = new Vector2[rings + 1];
            for (var ring = 0; ring <= rings; ring++)
            {
                var t = (float)ring / rings;
                var girth = ring == 0 || ring == rings ? 0.0 : Math.Pow(Math.Sin(Math.PI * Math.Pow(t, 0.72)), 0.55);
                spine[ring] = new Vector3(0f, -0.5f - 1.6f * t * t, -2.4f - 20f * t);
                radii[ring] = new Vector2(1.75f * (float)girth, 1.9f * (float)girth);
            }

            return new TubePart(spine, radii, 12, Segmented);
        }

        static Color32 Segmented(Vector3 place)
        {
            var ring = place.z / k_SegmentLength;
            return ring - Math.Floor(ring) < 0.4 ? s_Belly : s_Black;
        }

        static TubePart Antenna(int side)
        {
            const int rings = 16;
            var spine = new Vector3[rings + 1];
            var radii = new Vector2[rings + 1];
            for (var ring = 0; ring <= rings; ring++)
            {
                var t = (float)ring / rings;
                var club = Math.Exp(-Math.Pow((t - 0.92) / 0.055, 2));
                var radius = ring == 0 || ring == rings ? 0f : 0.13f + 0.24f * (float)club;
                spine[ring] = new Vector3(side * (0.5f + 6.2f * t - 1.2f * t * t), 1.2f + 4.6f * t - 1.5f * t * t, 5.7f + 11.5f * t);
                radii[ring] = new Vector2(radius, radius);
            }

            return new TubePart(spine, radii, 5, _ => s_Black);
        }

        static Color32 Furred(Vector3 place)
        {
            foreach (var dot in s_Dots)
            {
                var mirrored = new Vector3(Math.Abs(place.x), place.y, place.z);
                if ((mirrored - dot).sqrMagnitude < k_DotRadius * k_DotRadius)
                {
                    return s_Dot;
                }
            }

            return s_Black;
        }
    }
}
