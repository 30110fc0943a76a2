using System;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>
    /// Paints the vertex colours of a surface into a picture for its texture coordinates, for shaders that show no vertex colours.
    /// </summary>
    internal static class ColourTexture
    {
        /// <summary>Reach of colours beyond the used parts of the picture, pixels: for filtering and small mipmaps.</summary>
        private const int k_Bleed = 4;

        /// <summary>Paints the picture, row by row from v = 0.</summary>
        /// <param name="surface">With colours and texture coordinates.</param>
        /// <param name="size">Columns and rows, 1 or more.</param>
        /// <exception cref="ArgumentException">The surface lacks colours or texture coordinates, or the size is below 1.</exception>
        public static Color32[] Paint(SurfaceMesh surface, int size)
        {
            if (surface.uvs == null || surface.colours == null)
            {
                throw new ArgumentException(
                    "Only a surface with vertex colours and texture coordinates can be painted into a texture.", nameof(surface));
            }
            if (size < 1)
                throw new ArgumentOutOfRangeException(nameof(size), size, "A texture has one pixel or more.");
            var pixels = new Color32[size * size];
            bool[] isPainted = new bool[pixels.Length];
            for (int corner = 0; corner < surface.triangles.Length; corner += 3)
                PaintTriangle(surface, corner, size, pixels, isPainted);
            for (int ring = 0; ring < k_Bleed; ring++)
                Spread(size, pixels, isPainted);
            return pixels;
        }

        private static void PaintTriangle(SurfaceMesh surface, int corner, int size, Color32[] pixels, bool[] isPainted)
        {
            int i = surface.triangles[corner], j = surface.triangles[corner + 1], k = surface.triangles[corner + 2];
            float2 a = size * (float2)surface.uvs[i], b = size * (float2)surface.uvs[j], c = size * (float2)surface.uvs[k];
            float area = Cross(b - a, c - a);
            if (area == 0f)
                return;
            int2 from = math.max((int2)math.floor(math.min(a, math.min(b, c)) - 0.5f), 0);
            int2 to = math.min((int2)math.floor(math.max(a, math.max(b, c)) + 0.5f), size - 1);
            for (int y = from.y; y <= to.y; y++)
            {
                for (int x = from.x; x <= to.x; x++)
                {
                    var point = new float2(x + 0.5f, y + 0.5f);
                    float3 shares = new float3(Cross(c - b, point - b), Cross(a - c, point - c), Cross(b - a, point - a)) / area;
                    if (math.all(shares >= 0f))
                    {
                        pixels[y * size + x] = Mix(surface.colours[i], surface.colours[j], surface.colours[k], shares);
                        isPainted[y * size + x] = true;
                    }
                }
            }
        }

        // One pixel outwards from all that is painted.
        private static void Spread(int size, Color32[] pixels, bool[] isPainted)
        {
            bool[] before = (bool[])isPainted.Clone();
            for (int pixel = 0; pixel < pixels.Length; pixel++)
            {
                if (before[pixel])
                    continue;
                int x = pixel % size, y = pixel / size;
                int from = x > 0 && before[pixel - 1] ? pixel - 1
                    : x + 1 < size && before[pixel + 1] ? pixel + 1
                    : y > 0 && before[pixel - size] ? pixel - size
                    : y + 1 < size && before[pixel + size] ? pixel + size : -1;
                if (from >= 0)
                {
                    pixels[pixel] = pixels[from];
                    isPainted[pixel] = true;
                }
            }
        }

        private static Color32 Mix(Color32 a, Color32 b, Color32 c, float3 shares)
        {
            float4 mixed = shares.x * Numbers(a) + shares.y * Numbers(b) + shares.z * Numbers(c);
            var rounded = (int4)math.round(math.clamp(mixed, 0f, 255f));
            return new Color32((byte)rounded.x, (byte)rounded.y, (byte)rounded.z, (byte)rounded.w);
        }

        private static float4 Numbers(Color32 colour) => new float4(colour.r, colour.g, colour.b, colour.a);

        private static float Cross(float2 a, float2 b) => a.x * b.y - a.y * b.x;
    }
}
