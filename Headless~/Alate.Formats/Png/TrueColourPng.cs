using System.IO.Compression;
using UnityEngine;

namespace Alate.Formats;

/// <summary>Writes pictures as PNG files of 24 bits a pixel, or of 32 with opacity, every colour as it is.</summary>
internal static class TrueColourPng
{
    private const byte k_TrueColour = 2, k_TrueColourAndOpacity = 6;

    /// <summary>
    /// Filters in the order in which they are tried: above, Paeth, left, mean, none. Rows of paper need the first alone.
    /// </summary>
    private static readonly int[] s_Filters = [2, 4, 1, 3, 0];

    /// <summary>A picture.</summary>
    /// <param name="width">Pixels in a row.</param>
    /// <param name="height">Rows.</param>
    /// <param name="pixels">Rows from above.</param>
    /// <param name="texts">What is written in it, for those who do not see it.</param>
    /// <param name="hasOpacity">True where pixels may be seen through; else their opacity does not count.</param>
    public static byte[] Write(int width, int height, Color32[] pixels, IEnumerable<string> texts, bool hasOpacity = false) =>
        WriteFilm(width, height, [pixels], 1, true, texts, hasOpacity);

    /// <summary>An animation; a single frame is a still picture.</summary>
    /// <param name="width">Pixels in a row.</param>
    /// <param name="height">Rows.</param>
    /// <param name="frames">[frame] Rows from above.</param>
    /// <param name="rate">Frames a second.</param>
    /// <param name="repeats">True for ever, false once.</param>
    /// <param name="texts">What is written in it, for those who do not see it.</param>
    /// <param name="hasOpacity">True where pixels may be seen through; else their opacity does not count.</param>
    public static byte[] WriteFilm(
        int width, int height, IReadOnlyList<Color32[]> frames, int rate, bool repeats, IEnumerable<string> texts, bool hasOpacity)
    {
        using var file = new MemoryStream();
        file.Write(PngChunks.Signature);
        PngChunks.Write(file, "IHDR", PngChunks.Header(width, height, 8, hasOpacity ? k_TrueColourAndOpacity : k_TrueColour));
        PngChunks.WriteTexts(file, texts);
        var film = new PngFrames(file, frames.Count, rate, repeats);
        byte[][] packed = [.. frames.AsParallel().AsOrdered().Select(frame => Packed(width, height, frame, hasOpacity ? 4 : 3))];
        foreach (byte[] frame in packed)
            film.Write(0, 0, width, height, frame, isOver: false);
        PngChunks.Write(file, "IEND", []);
        return file.ToArray();
    }

    // Each row by the filter whose bytes have the least sum, as signed numbers: what is near nought packs best.
    private static byte[] Packed(int width, int height, Color32[] pixels, int channels)
    {
        int length = channels * width;
        byte[] above = new byte[length], row = new byte[length], filtered = new byte[length], best = new byte[length];
        using var packed = new MemoryStream();
        using (var zlib = new ZLibStream(packed, CompressionLevel.SmallestSize, leaveOpen: true))
        {
            for (int y = 0; y < height; y++)
            {
                for (int x = 0; x < width; x++)
                {
                    Color32 pixel = pixels[y * width + x];
                    (row[channels * x], row[channels * x + 1], row[channels * x + 2]) = (pixel.r, pixel.g, pixel.b);
                    if (channels == 4)
                        row[channels * x + 3] = pixel.a;
                }

                int least = int.MaxValue, chosen = 0;
                foreach (int filter in s_Filters)
                {
                    int sum = Filter(filter, row, above, filtered, channels);
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

    private static int Filter(int filter, byte[] row, byte[] above, byte[] filtered, int channels)
    {
        int sum = 0;
        for (int k = 0; k < row.Length; k++)
        {
            int left = k < channels ? 0 : row[k - channels], corner = k < channels ? 0 : above[k - channels];
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
