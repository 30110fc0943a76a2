using System;
using System.Collections.Generic;
using Alate.Authoring;
using UnityEngine;

namespace Alate.Editor.Tests
{
    /// <summary>A picture that tests paint: places in pixels from the top left corner, y down, edges smoothed over a pixel.</summary>
    internal sealed class DrawnPicture
    {
        private const int k_Lines = 8;

        public readonly int width;
        public readonly int height;

        private readonly Vector3[] m_Colours;
        private readonly float[] m_Alpha;

        public DrawnPicture(int width, int height, Color32 ground)
        {
            this.width = width;
            this.height = height;
            m_Colours = new Vector3[width * height];
            m_Alpha = new float[width * height];
            Array.Fill(m_Colours, Shades(ground));
            Array.Fill(m_Alpha, ground.a);
        }

        /// <summary>Adds shades that depend on the place, from (0, 0) to (1, 1) over the picture.</summary>
        public DrawnPicture Shade(Func<float, float, float> shades)
        {
            for (int k = 0; k < m_Colours.Length; k++)
                m_Colours[k] += shades((k % width + 0.5f) / width, (k / width + 0.5f) / height) * Vector3.one;
            return this;
        }

        /// <summary>Fills a polygon.</summary>
        public DrawnPicture Fill(IReadOnlyList<Vector2> polygon, Color32 colour)
        {
            float[] cover = new float[width];
            var crossings = new List<float>();
            var sides = new List<(Vector2, Vector2)>();
            for (int row = 0; row < height; row++)
            {
                Array.Clear(cover, 0, width);
                FindSides(polygon, row, sides);
                for (int line = 0; line < k_Lines; line++)
                {
                    Cross(sides, row + (line + 0.5f) / k_Lines, crossings);
                    for (int k = 0; k + 1 < crossings.Count; k += 2)
                        Cover(cover, crossings[k], crossings[k + 1], 1f / k_Lines);
                }

                for (int column = 0; column < width; column++)
                    Blend(column, row, colour, cover[column]);
            }

            return this;
        }

        /// <summary>Draws lines through points with round ends.</summary>
        public DrawnPicture Stroke(IReadOnlyList<Vector2> path, float thickness, Color32 colour)
        {
            var cover = new Dictionary<int, float>();
            for (int k = 0; k + 1 < path.Count; k++)
                CoverSegment(path[k], path[k + 1], 0.5f * thickness, cover);
            foreach (KeyValuePair<int, float> pixel in cover)
                Blend(pixel.Key % width, pixel.Key / width, colour, pixel.Value);
            return this;
        }

        /// <summary>Adds noise of a normal distribution to every channel of every pixel.</summary>
        public DrawnPicture Noise(float shades, int seed)
        {
            var random = new System.Random(seed);
            for (int k = 0; k < m_Colours.Length; k++)
                m_Colours[k] += shades * new Vector3(Normal(random), Normal(random), Normal(random));
            return this;
        }

        /// <summary>Rounds the cosine waves of every block of eight by eight pixels, as strong JPEG compression does.</summary>
        public DrawnPicture Compress(float strength)
        {
            for (int row = 0; row < height; row += 8)
            {
                for (int column = 0; column < width; column += 8)
                    BlockQuantisation.Round(m_Colours, width, height, column, row, strength);
            }

            return this;
        }

        public WingPicture ToPicture()
        {
            return new WingPicture(width, height, ToPixels());
        }

        /// <summary>[row * width + column] Rows from the top.</summary>
        public Color32[] ToPixels()
        {
            var pixels = new Color32[m_Colours.Length];
            for (int k = 0; k < pixels.Length; k++)
                pixels[k] = new Color32(Byte(m_Colours[k].x), Byte(m_Colours[k].y), Byte(m_Colours[k].z), Byte(m_Alpha[k]));
            return pixels;
        }

        // Sides of a polygon that reach into a row.
        private static void FindSides(IReadOnlyList<Vector2> polygon, int row, List<(Vector2, Vector2)> sides)
        {
            sides.Clear();
            for (int k = 0, before = polygon.Count - 1; k < polygon.Count; before = k++)
            {
                Vector2 a = polygon[before], b = polygon[k];
                if (Math.Max(a.y, b.y) >= row && Math.Min(a.y, b.y) <= row + 1)
                    sides.Add((a, b));
            }
        }

        private static void Cross(List<(Vector2, Vector2)> sides, float y, List<float> crossings)
        {
            crossings.Clear();
            foreach ((Vector2 a, Vector2 b) in sides)
            {
                if (a.y > y != b.y > y)
                    crossings.Add(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
            }

            crossings.Sort();
        }

        private void Cover(float[] cover, float from, float to, float weight)
        {
            int last = Math.Min(width - 1, (int)Math.Floor(to));
            for (int column = Math.Max(0, (int)Math.Floor(from)); column <= last; column++)
                cover[column] += weight * Math.Max(0f, Math.Min(to, column + 1f) - Math.Max(from, column));
        }

        private void CoverSegment(Vector2 a, Vector2 b, float radius, Dictionary<int, float> cover)
        {
            int top = Math.Max(0, (int)(Math.Min(a.y, b.y) - radius - 1f)),
                bottom = Math.Min(height - 1, (int)(Math.Max(a.y, b.y) + radius + 1f));
            int left = Math.Max(0, (int)(Math.Min(a.x, b.x) - radius - 1f)),
                right = Math.Min(width - 1, (int)(Math.Max(a.x, b.x) + radius + 1f));
            for (int row = top; row <= bottom; row++)
            {
                for (int column = left; column <= right; column++)
                {
                    var centre = new Vector2(column + 0.5f, row + 0.5f);
                    float along = Mathf.Clamp01(Vector2.Dot(centre - a, b - a) / Math.Max(1e-9f, (b - a).sqrMagnitude));
                    float share = Mathf.Clamp01(radius + 0.5f - (a + along * (b - a) - centre).magnitude);
                    cover.TryGetValue(row * width + column, out float before);
                    cover[row * width + column] = Math.Max(before, Math.Min(share, 2f * radius));
                }
            }
        }

        private void Blend(int column, int row, Color32 colour, float share)
        {
            if (share <= 0f)
                return;
            int at = row * width + column;
            m_Colours[at] += share * (Shades(colour) - m_Colours[at]);
            m_Alpha[at] += share * (colour.a - m_Alpha[at]);
        }

        private static float Normal(System.Random random) =>
            (float)(Math.Sqrt(-2.0 * Math.Log(1.0 - random.NextDouble())) * Math.Cos(2.0 * Math.PI * random.NextDouble()));

        private static Vector3 Shades(Color32 colour) => new Vector3(colour.r, colour.g, colour.b);

        private static byte Byte(float shade) => (byte)Mathf.Clamp(Mathf.RoundToInt(shade), 0, 255);
    }
}
