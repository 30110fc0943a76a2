using System.IO.Compression;
using UnityEngine;

namespace Alate.Formats;

/// <summary>Writes still pictures as PNG files of 24 bits a pixel, every colour as it is.</summary>
internal static class TrueColourPng
{
    private const byte k_TrueColour = 2;
    private const int k_Channels = 3;

    /// <summary>
    /// Filters in the order in which they are tried: above, Paeth, left, mean, none. Rows of paper need the first alone.
    /// </summary>
    private static readonly int[] s_Filters = [2, 4, 1, 3, 0];

    /// <summary>A picture.</summary>
    /// <param name="width">Pixels in a row.</param>
    /// <param name="height">Rows.</param>
    /// <param name="pixels">Rows from above; opaque.</param>
    /// <param name="texts">What is written in it, for those who do not see it.</param>
    public static byte[] Write(int width, int height, Color32[] pixels, IEnumerable<string> texts)
    {
        using var file = new MemoryStream();
        file.Write(PngChunks.Signature);
        PngChunks.Write(file, "IHDR", PngChunks.Header(width, height, 8, k_TrueColour));
        PngChunks.WriteTexts(file, texts);
        PngChunks.Write(file, "IDAT", Packed(width, height, pixels));
        PngChunks.Write(file, "IEND", []);
        return file.ToArray();
    }

    // Each row by the filter whose bytes have the least sum, as signed numbers: what is near nought packs best.
    private static byte[] Packed(int width, int height, Color32[] pixels)
    {
        int length = k_Channels * width;
        byte[] above = new byte[length], row = new byte[length], filtered = new byte[length], best = new byte[length];
        using var packed = new MemoryStream();
        using (var zlib = new ZLibStream(packed, CompressionLevel.SmallestSize, leaveOpen: true))
        {
            for (int y = 0; y < height; y++)
            {
                for (int x = 0; x < width; x++)
                {
                    Color32 pixel = pixels[y * width + x];
                    (row[k_Channels * x], row[k_Channels * x + 1], row[k_Channels * x + 2]) = (pixel.r, pixel.g, pixel.b);
                }

                int least = int.MaxValue, chosen = 0;
                foreach (int filter in s_Filters)
                {
                    int sum = Filter(filter, row, above, filtered);
                    if (sum >= least)
                        continue;
                    (least, chosen) = (sum, filter);
                    (best, filtered) = (filtered, best);
                    if (sum == 0)
                        break;
                }

                zlib.WriteByte((byte)chosen);
                zlib.Write(best);
                (above, row) = (row, above);
            }
        }

        return packed.ToArray();
    }

    private static int Filter(int filter, byte[] row, byte[] above, byte[] filtered)
    {
        int sum = 0;
        for (int k = 0; k < row.Length; k++)
        {
            int left = k < k_Channels ? 0 : row[k - k_Channels], corner = k < k_Channels ? 0 : above[k - k_Channels];
            int foretold = filter switch
            {
                0 => 0,
                1 => left,
                2 => above[k],
                3 => (left + above[k]) / 2,
                _ => Paeth(left, above[k], corner),
            };
            filtered[k] = (byte)(row[k] - foretold);
            sum += Math.Abs((int)(sbyte)filtered[k]);
        }

        return sum;
    }

    // That of the three which is nearest to left + above − corner.
    private static int Paeth(int left, int above, int corner)
    {
        int toLeft = Math.Abs(above - corner), toAbove = Math.Abs(left - corner), toCorner = Math.Abs(left + above - 2 * corner);
        return toLeft <= toAbove && toLeft <= toCorner ? left : toAbove <= toCorner ? above : corner;
    }
}
