using System;
using System.Collections.Generic;
using Alate.Geometry;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>
    /// A smooth, rounded part through a few sections, such as a thorax. The squares of the sizes are interpolated by monotone cubics: near
    /// an end where they fall to 0 that makes a round cap, as of an ellipsoid.
    /// </summary>
    internal static class Trunk
    {
        /// <summary>Crowding of sections at the ends, where the outline turns: 0 is even spacing, 1 spacing as on a circle.</summary>
        private const float k_Crowding = 0.6f;

        /// <param name="keys">Three or more; the first and the last are points.</param>
        /// <param name="rings">Pieces along the part.</param>
        /// <param name="sides">Vertices of a section, even.</param>
        /// <param name="relief">Factor on the girth at a place along the part from 0 to 1; null is 1 throughout.</param>
        public static BodyPart Through(IReadOnlyList<CrossSection> keys, int rings, int sides, Func<float, float> relief = null) =>
            Tube.Along(Sections(keys, rings, relief), sides);

        /// <summary>Interpolates the sections of a trunk.</summary>
        public static CrossSection[] Sections(IReadOnlyList<CrossSection> keys, int rings, Func<float, float> relief = null)
        {
            double[] places = Places(keys);
            MonotoneCurve x = Curve(places, keys, key => key.Centre.x);
            MonotoneCurve y = Curve(places, keys, key => key.Centre.y);
            MonotoneCurve z = Curve(places, keys, key => key.Centre.z);
            MonotoneCurve width = Curve(places, keys, key => key.HalfWidth * key.HalfWidth);
            MonotoneCurve above = Curve(places, keys, key => key.Above * key.Above);
            MonotoneCurve below = Curve(places, keys, key => key.Below * key.Below);
            MonotoneCurve arch = Curve(places, keys, key => key.Arch);
            var sections = new CrossSection[rings + 1];
            for (int ring = 0; ring <= rings; ring++)
            {
                double t = (double)ring / rings;
                t += k_Crowding * (0.5 - 0.5 * Math.Cos(Math.PI * t) - t);
                var centre = new Vector3((float)x.At(t), (float)y.At(t), (float)z.At(t));
                bool isEnd = ring == 0 || ring == rings;
                sections[ring] = isEnd
                    ? CrossSection.Round(centre, 0f)
                    : new CrossSection(centre, Root(width.At(t)), Root(above.At(t)), Root(below.At(t)), (float)arch.At(t))
                        .Swollen(relief == null ? 1f : relief((float)t));
            }

            return sections;
        }

        private static float Root(double square) => (float)Math.Sqrt(Math.Max(square, 1e-6));

        private static double[] Places(IReadOnlyList<CrossSection> keys)
        {
            double[] places = new double[keys.Count];
            for (int k = 1; k < places.Length; k++)
                places[k] = places[k - 1] + (keys[k].Centre - keys[k - 1].Centre).magnitude;
            return Array.ConvertAll(places, place => place / places[places.Length - 1]);
        }

        private static MonotoneCurve Curve(double[] places, IReadOnlyList<CrossSection> keys, Func<CrossSection, double> value)
        {
            double[] values = new double[keys.Count];
            for (int k = 0; k < values.Length; k++)
                values[k] = value(keys[k]);
            return MonotoneCurve.Straight(places, values).Smoothed();
        }
    }
}
