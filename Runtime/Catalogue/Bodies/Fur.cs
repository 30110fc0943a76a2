using System;
using System.Collections.Generic;
using UnityEngine;
using Random = Unity.Mathematics.Random;

namespace Alate.Catalogue
{
    /// <summary>Hair and scales that stand off a part: slim pyramids that lean back.</summary>
    internal sealed class Fur
    {
        /// <summary>Depth of a hair's root in the skin, as a share of the hair's length.</summary>
        private const float k_Root = 0.15f;

        /// <summary>
        /// Share of the skin's normal in a hair's own, so that fur is lit as the round body it grows on; below 1, so that normals still
        /// point outwards.
        /// </summary>
        private const float k_SkinNormal = 0.6f;

        /// <summary>Hairs on the right side; the left has as many.</summary>
        public int Count { get; set; }

        /// <summary>Mean length, millimetres; single hairs are up to a third longer or shorter.</summary>
        public float Length { get; set; }

        /// <summary>Radius at the root, millimetres.</summary>
        public float Radius { get; set; }

        /// <summary>Direction of hair: its part along the skin is added to the skin's unit normal.</summary>
        public Vector3 Lay { get; set; } = new Vector3(0f, 0f, -0.9f);

        /// <summary>Filter for the places where hair grows; null is everywhere.</summary>
        public Func<Vector3, bool> Where { get; set; }

        public uint Seed { get; set; } = 1;

        /// <summary>The hair of the right half of a part.</summary>
        public BodyPart GrowOn(BodyPart skin)
        {
            var random = new Random(Seed);
            double[] areas = Areas(skin);
            var hairs = new Pyramids();
            var normals = new List<Vector3>();
            for (int hair = 0; hair < Count && areas[areas.Length - 1] > 0; hair++)
            {
                int triangle = Array.BinarySearch(areas, random.NextDouble() * areas[areas.Length - 1]);
                BodyPoint root = Root(skin, 3 * Math.Min(triangle < 0 ? ~triangle : triangle, areas.Length - 1), ref random);
                Add(hairs, root, ref random);
                normals.AddRange(new[] { root.Normal, root.Normal, root.Normal, root.Normal });
            }

            BodyPart fur = hairs.ToPart(skin.Extent);
            for (int vertex = 0; vertex < normals.Count; vertex++)
            {
                Vector3 mixed = fur.Normals[vertex] + k_SkinNormal * normals[vertex];
                fur.Normals[vertex] = mixed / mixed.magnitude;
            }

            return fur;
        }

        // Sums of the areas of the right half's triangles, as far as hair grows on them.
        private double[] Areas(BodyPart skin)
        {
            double[] sums = new double[skin.Triangles.Length / 3];
            double sum = 0.0;
            for (int k = 0; k < sums.Length; k++)
            {
                Vector3 a = skin.Positions[skin.Triangles[3 * k]];
                Vector3 b = skin.Positions[skin.Triangles[3 * k + 1]];
                Vector3 c = skin.Positions[skin.Triangles[3 * k + 2]];
                Vector3 middle = (a + b + c) / 3f;
                if (middle.x > 0f && (Where == null || Where(middle)))
                    sum += Vector3.Cross(b - a, c - a).magnitude;
                sums[k] = sum;
            }

            return sums;
        }

        private static BodyPoint Root(BodyPart skin, int corner, ref Random random)
        {
            float u = random.NextFloat(), v = random.NextFloat();
            if (u + v > 1f)
            {
                u = 1f - u;
                v = 1f - v;
            }

            int a = skin.Triangles[corner], b = skin.Triangles[corner + 1], c = skin.Triangles[corner + 2];
            float w = 1f - u - v;
            Vector3 normal = w * skin.Normals[a] + u * skin.Normals[b] + v * skin.Normals[c];
            return new BodyPoint(
                w * skin.Positions[a] + u * skin.Positions[b] + v * skin.Positions[c],
                normal / normal.magnitude,
                w * skin.Uvs[a] + u * skin.Uvs[b] + v * skin.Uvs[c]);
        }

        private void Add(Pyramids hairs, in BodyPoint root, ref Random random)
        {
            float length = Length * random.NextFloat(0.67f, 1.33f);
            var jitter = new Vector3(random.NextFloat(-1f, 1f), random.NextFloat(-1f, 1f), random.NextFloat(-1f, 1f));
            Vector3 along = root.Normal + Lay - Vector3.Dot(Lay, root.Normal) * root.Normal + 0.25f * jitter;
            along *= length / along.magnitude;
            Vector3 sunk = k_Root * length * root.Normal;
            hairs.Add(root.Place - sunk, along + sunk, jitter, Radius, new Vector2(root.Around, root.Along));
        }
    }
}
