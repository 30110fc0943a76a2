using System;
using UnityEngine;

namespace Alate.Editor.Tests
{
    /// <summary>
    /// Effect of strong JPEG compression on a block of eight by eight pixels: its cosine waves keep only whole multiples of a step.
    /// </summary>
    internal static class BlockQuantisation
    {
        private const int k_Side = 8;

        private static readonly float[,] s_Waves = MakeWaves();

        /// <summary>Rounds a block.</summary>
        /// <param name="colours">[row * width + column]</param>
        /// <param name="strength">1 is about quality 50; the step grows with the wave's number.</param>
        public static void Round(Vector3[] colours, int width, int height, int column, int row, float strength)
        {
            var block = new Vector3[k_Side, k_Side];
            for (int y = 0; y < k_Side; y++)
            {
                for (int x = 0; x < k_Side; x++)
                    block[y, x] = colours[Math.Min(height - 1, row + y) * width + Math.Min(width - 1, column + x)];
            }

            Vector3[,] waves = Transformed(block, false);
            for (int v = 0; v < k_Side; v++)
            {
                for (int u = 0; u < k_Side; u++)
                    waves[v, u] = Rounded(waves[v, u], strength * (12f + 6f * (u + v)));
            }

            block = Transformed(waves, true);
            for (int y = 0; y < k_Side && row + y < height; y++)
            {
                for (int x = 0; x < k_Side && column + x < width; x++)
                    colours[(row + y) * width + column + x] = block[y, x];
            }
        }

        private static Vector3[,] Transformed(Vector3[,] from, bool back)
        {
            var across = new Vector3[k_Side, k_Side];
            var both = new Vector3[k_Side, k_Side];
            for (int y = 0; y < k_Side; y++)
            {
                for (int u = 0; u < k_Side; u++)
                {
                    for (int x = 0; x < k_Side; x++)
                        across[y, u] += (back ? s_Waves[x, u] : s_Waves[u, x]) * from[y, x];
                }
            }

            for (int v = 0; v < k_Side; v++)
            {
                for (int u = 0; u < k_Side; u++)
                {
                    for (int y = 0; y < k_Side; y++)
                        both[v, u] += (back ? s_Waves[y, v] : s_Waves[v, y]) * across[y, u];
                }
            }

            return both;
        }

        private static Vector3 Rounded(Vector3 value, float step) =>
            step * new Vector3(Mathf.Round(value.x / step), Mathf.Round(value.y / step), Mathf.Round(value.z / step));

        private static float[,] MakeWaves()
        {
            float[,] waves = new float[k_Side, k_Side];
            for (int u = 0; u < k_Side; u++)
            {
                for (int x = 0; x < k_Side; x++)
                    waves[u, x] = Mathf.Sqrt((u == 0 ? 1f : 2f) / k_Side) * Mathf.Cos((2 * x + 1) * u * Mathf.PI / (2 * k_Side));
            }

            return waves;
        }
    }
}
