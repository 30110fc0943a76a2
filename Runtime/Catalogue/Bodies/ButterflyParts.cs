using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>
    /// Parts common to the bodies of butterflies: a head with eyes, palps and a rolled tongue, clubbed antennae, folded legs, a segmented
    /// abdomen.
    /// </summary>
    internal static class ButterflyParts
    {
        private const float k_TongueTurns = 2.6f;

        /// <summary>A round head with large eyes and two palps that stand before it; returns the head alone.</summary>
        public static BodyPatch AddHead(BodyParts parts, Vector3 centre, float radius, BodyPaint face, BodyPaint eye)
        {
            BodyPatch head = parts.Add(Ellipsoid.Around(centre, radius * new Vector3(1f, 0.95f, 1f), 10, 16), face);
            parts.AddPair(
                Ellipsoid.Around(centre + radius * new Vector3(0.68f, 0.1f, 0.2f), radius * new Vector3(0.56f, 0.72f, 0.68f), 10, 14), eye);
            Vector3[] palp = new[]
            {
                centre + radius * new Vector3(0.2f, -0.7f, 0.5f), centre + radius * new Vector3(0.24f, -0.75f, 1.3f),
                centre + radius * new Vector3(0.22f, -0.1f, 1.6f), centre + radius * new Vector3(0.18f, 0.35f, 1.72f),
            };
            parts.AddPair(Stalk.Along(palp, t => radius * (0.24f - 0.17f * t), 5, 8), face);
            return head;
        }

        /// <summary>The tongue, rolled up below the palps, of pieces with as many sides.</summary>
        public static void AddTongue(BodyParts parts, Vector3 middle, float radius, Color32 colour, int pieces = 44, int sides = 6)
        {
            var sections = new CrossSection[pieces + 1];
            for (int k = 0; k <= pieces; k++)
            {
                float t = (float)k / pieces;
                double angle = 2 * Math.PI * k_TongueTurns * t;
                float away = radius * (1f - 0.78f * t);
                Vector3 place = middle + away * new Vector3(0f, (float)Math.Cos(angle), (float)Math.Sin(angle));
                sections[k] = CrossSection.Round(place, k == 0 || k == pieces ? 0f : radius * (0.15f - 0.07f * t));
            }

            parts.Add(Tube.Along(sections, sides, new Vector3(0f, 1f, 0f)), (in BodyPoint point) => colour);
        }

        /// <summary>Antennae along a Bezier curve (the right one, millimetres) that end in a club; radii of shaft and club.</summary>
        public static void AddAntennae(BodyParts parts, Vector3[] curve, float radius, float club, BodyPaint paint)
        {
            float Girth(float t) => radius + (club - radius) * (float)Math.Exp(-Math.Pow((t - 0.94) / 0.05, 2));
            parts.AddPair(Stalk.Along(curve, Girth, 24, 6), paint);
        }

        /// <summary>
        /// Legs as they hang folded under the thorax in flight: hip, knee, ankle, toes and tip of each right one; the radius of the thigh,
        /// millimetres.
        /// </summary>
        public static void AddLegs(BodyParts parts, IEnumerable<Vector3[]> pairs, float girth, BodyPaint paint)
        {
            foreach (Vector3[] joints in pairs)
                parts.AddPair(Stalk.Leg(joints, new[] { 1.2f * girth, girth, 0.8f * girth, 0.5f * girth, 0.3f * girth }, 6), paint);
        }

        /// <summary>
        /// Factor on an abdomen's girth that shows its rings: each swells a little and is drawn in where the next begins.
        /// </summary>
        /// <param name="segments">Number of rings.</param>
        /// <param name="depth">Depth of the furrows over the radius.</param>
        public static Func<float, float> Rings(float segments, float depth)
        {
            return t =>
            {
                float within = segments * t - (float)Math.Floor(segments * t);
                return 1f - depth * (float)Math.Pow(Math.Abs(2 * within - 1), 6);
            };
        }
    }
}
